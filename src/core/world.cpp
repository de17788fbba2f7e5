#include "core/world.hpp"

#include "core/error.hpp"

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <thread>
#include <utility>

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

namespace {

/// One message holds at most this many bytes; MPI counts in int.
constexpr std::size_t kMessage = std::size_t{1} << 30;
constexpr int kDelivery = 1, kSwap = 2;

template <class T>
T reduced(T value, MPI_Datatype type, MPI_Op operation) {
  T result = value;
  MPI_Allreduce(&value, &result, 1, type, operation, MPI_COMM_WORLD);
  return result;
}

void begin_send(const Post& post, int tag, std::vector<MPI_Request>& open) {
  for (std::size_t at = 0; at < post.bytes; at += kMessage) {
    const auto n = static_cast<int>(std::min(kMessage, post.bytes - at));
    open.emplace_back();
    MPI_Isend(static_cast<char*>(post.data) + at, n, MPI_CHAR, post.rank, tag, MPI_COMM_WORLD,
              &open.back());
  }
}

void begin_receive(const Post& post, int tag, std::vector<MPI_Request>& open) {
  for (std::size_t at = 0; at < post.bytes; at += kMessage) {
    const auto n = static_cast<int>(std::min(kMessage, post.bytes - at));
    open.emplace_back();
    MPI_Irecv(static_cast<char*>(post.data) + at, n, MPI_CHAR, post.rank, tag, MPI_COMM_WORLD,
              &open.back());
  }
}

Post post_of(const Parcel& parcel) {
  return {parcel.rank, const_cast<char*>(parcel.bytes.data()), parcel.bytes.size()};
}

void finish(std::vector<MPI_Request>& open) {
  MPI_Waitall(static_cast<int>(open.size()), open.data(), MPI_STATUSES_IGNORE);
}

}  // namespace

int World::cores() const {
  const auto all = static_cast<int>(std::thread::hardware_concurrency());
  if (size_ == 1) return all;
  MPI_Comm here = MPI_COMM_NULL;
  MPI_Comm_split_type(MPI_COMM_WORLD, MPI_COMM_TYPE_SHARED, rank_, MPI_INFO_NULL, &here);
  int ranks = 1;
  MPI_Comm_size(here, &ranks);
  MPI_Comm_free(&here);
  return std::max(1, all / ranks);
}

double World::least(double value) const {
  return size_ == 1 ? value : reduced(value, MPI_DOUBLE, MPI_MIN);
}
double World::largest(double value) const {
  return size_ == 1 ? value : reduced(value, MPI_DOUBLE, MPI_MAX);
}
void World::largest(std::vector<double>& values) const {
  if (size_ == 1) return;
  MPI_Allreduce(MPI_IN_PLACE, values.data(), static_cast<int>(values.size()), MPI_DOUBLE, MPI_MAX,
                MPI_COMM_WORLD);
}
void World::any(std::vector<std::uint8_t>& flags) const {
  if (size_ == 1) return;
  MPI_Allreduce(MPI_IN_PLACE, flags.data(), static_cast<int>(flags.size()), MPI_UINT8_T, MPI_BOR,
                MPI_COMM_WORLD);
}
std::int64_t World::sum(std::int64_t value) const {
  return size_ == 1 ? value : reduced(value, MPI_INT64_T, MPI_SUM);
}
bool World::any(bool value) const {
  return bits(value ? 1 : 0) != 0;
}
std::uint64_t World::bits(std::uint64_t value) const {
  return size_ == 1 ? value : reduced(value, MPI_UINT64_T, MPI_BOR);
}

bool World::together(double seconds) const {
  if (size_ == 1) return true;
  MPI_Request barrier;
  MPI_Ibarrier(MPI_COMM_WORLD, &barrier);
  const auto start = std::chrono::steady_clock::now();
  int there = 0;
  while (there == 0) {
    MPI_Test(&barrier, &there, MPI_STATUS_IGNORE);
    const std::chrono::duration<double> waited = std::chrono::steady_clock::now() - start;
    if (there == 0 && waited.count() > seconds) return false;
    if (there == 0) std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  return true;
}

void World::add_up(std::vector<double>& values) const {
  if (size_ == 1) return;
  const auto count = static_cast<int>(values.size());
  MPI_Allreduce(MPI_IN_PLACE, values.data(), count, MPI_DOUBLE, MPI_SUM, MPI_COMM_WORLD);
}

void World::share(std::vector<char>& bytes, int from) const {
  if (size_ == 1) return;
  std::uint64_t size = bytes.size();
  MPI_Bcast(&size, 1, MPI_UINT64_T, from, MPI_COMM_WORLD);
  bytes.resize(size);
  for (std::size_t at = 0; at < size; at += kMessage)
    MPI_Bcast(bytes.data() + at, static_cast<int>(std::min(kMessage, size - at)), MPI_CHAR, from,
              MPI_COMM_WORLD);
}

std::vector<std::vector<char>> World::collect(const std::vector<char>& bytes) const {
  std::vector<Parcel> out;
  if (rank_ != 0) out.push_back({0, bytes});
  std::vector<std::vector<char>> all(rank_ == 0 ? static_cast<std::size_t>(size_) : 0);
  for (Parcel& parcel : deliver(out))
    all[static_cast<std::size_t>(parcel.rank)] = std::move(parcel.bytes);
  if (rank_ == 0) all[0] = bytes;
  return all;
}

std::vector<Parcel> World::deliver(const std::vector<Parcel>& parcels) const {
  if (size_ == 1) return {};
  std::vector<std::uint64_t> sends(static_cast<std::size_t>(size_), 0), comes(sends);
  for (const Parcel& parcel : parcels)
    sends[static_cast<std::size_t>(parcel.rank)] = parcel.bytes.size();
  MPI_Alltoall(sends.data(), 1, MPI_UINT64_T, comes.data(), 1, MPI_UINT64_T, MPI_COMM_WORLD);
  std::vector<Parcel> in;
  for (int r = 0; r < size_; ++r)
    if (const std::uint64_t n = comes[static_cast<std::size_t>(r)]; n > 0)
      in.push_back({r, std::vector<char>(n)});
  std::vector<MPI_Request> open;
  for (const Parcel& parcel : in) begin_receive(post_of(parcel), kDelivery, open);
  for (const Parcel& parcel : parcels) begin_send(post_of(parcel), kDelivery, open);
  finish(open);
  return in;
}

void World::swap(const std::vector<Post>& out, const std::vector<Post>& in) const {
  std::vector<MPI_Request> open;
  for (const Post& post : in) begin_receive(post, kSwap, open);
  for (const Post& post : out) begin_send(post, kSwap, open);
  finish(open);
}

#else

World::World(int*, char***) {}
World::~World() = default;
void World::abort(int status) const {
  std::exit(status);
}

double World::least(double value) const {
  return value;
}
double World::largest(double value) const {
  return value;
}
void World::largest(std::vector<double>&) const {}
void World::any(std::vector<std::uint8_t>&) const {}
std::int64_t World::sum(std::int64_t value) const {
  return value;
}
bool World::any(bool value) const {
  return value;
}
std::uint64_t World::bits(std::uint64_t value) const {
  return value;
}
int World::cores() const {
  return static_cast<int>(std::thread::hardware_concurrency());
}
bool World::together(double) const {
  return true;
}
void World::add_up(std::vector<double>&) const {}
void World::share(std::vector<char>&, int) const {}
std::vector<std::vector<char>> World::collect(const std::vector<char>& bytes) const {
  return {bytes};
}
std::vector<Parcel> World::deliver(const std::vector<Parcel>&) const {
  return {};
}
void World::swap(const std::vector<Post>&, const std::vector<Post>&) const {}

#endif

void World::share(std::string& text, int from) const {
  std::vector<char> letters(text.begin(), text.end());
  share(letters, from);
  text.assign(letters.begin(), letters.end());
}

void World::require_one_rank() const {
  if (size_ == 1) return;
  throw Error("launcher", "started on " + std::to_string(size_) + " ranks",
              "this command works on one rank; many are for `breccia run`");
}

void World::lead(const std::function<void()>& work) const {
  if (size_ == 1) return work();
  std::string place, cause, remedy;
  if (speaks()) {
    try {
      work();
    } catch (const Error& error) {
      place = error.place();
      cause = error.cause();
      remedy = error.remedy();
    }
  }
  for (std::string* text : {&place, &cause, &remedy}) share(*text, 0);
  if (!cause.empty()) throw Error(place, cause, remedy);
}

}  // namespace breccia
