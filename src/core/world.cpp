#include "core/world.hpp"

#include "core/error.hpp"

#include <cstdlib>

#if BRECCIA_WITH_MPI
#include <mpi.h>
#endif

namespace breccia {

#if BRECCIA_WITH_MPI

namespace {

/// MPI is started only under a launcher: alone it costs half a second and can fail on machines
/// whose network is restricted, for nothing.
bool launched() {
  for (const char* name : {"OMPI_COMM_WORLD_SIZE", "PMIX_RANK", "PMI_RANK", "PMI_SIZE",
                           "MPI_LOCALRANKID", "SLURM_STEP_ID"}) {
    if (std::getenv(name) != nullptr) return true;
  }
  return false;
}

}  // namespace

World::World(int* argc, char*** argv) {
  if (!launched()) return;
  int running = 0;
  MPI_Initialized(&running);
  if (running == 0) {
    int provided = 0;
    MPI_Init_thread(argc, argv, MPI_THREAD_FUNNELED, &provided);
    owns_mpi_ = true;
  }
  MPI_Comm_rank(MPI_COMM_WORLD, &rank_);
  MPI_Comm_size(MPI_COMM_WORLD, &size_);
}

World::~World() {
  if (owns_mpi_) MPI_Finalize();
}

void World::abort(int status) const {
  if (size_ > 1) MPI_Abort(MPI_COMM_WORLD, status);
  std::exit(status);
}

#else

World::World(int*, char***) {}
World::~World() = default;
void World::abort(int status) const {
  std::exit(status);
}

#endif

void World::require_one_rank() const {
  if (size_ == 1) return;
  throw Error("launcher", "started on " + std::to_string(size_) + " ranks",
              "many ranks come with a later release; run on one rank");
}

}  // namespace breccia
