#pragma once
#include <string>

namespace breccia {

/// The ranks of a run; the only place of core that knows MPI. Without BRECCIA_WITH_MPI, or when no
/// launcher started the program, there is one rank.
class World {
 public:
  World(int* argc, char*** argv);
  ~World();
  World(const World&) = delete;
  World& operator=(const World&) = delete;

  [[nodiscard]] int rank() const { return rank_; }
  [[nodiscard]] int size() const { return size_; }
  [[nodiscard]] bool speaks() const { return rank_ == 0; }  ///< the one rank that prints

  /// \throws Error on all ranks when there is more than one.
  void require_one_rank() const;

  /// Ends all ranks at once; for failures that only one rank has seen.
  [[noreturn]] void abort(int status) const;

 private:
  int rank_ = 0;
  int size_ = 1;
  bool owns_mpi_ = false;
};

}  // namespace breccia
