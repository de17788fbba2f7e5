#pragma once
#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace breccia {

/// Bytes on their way from one rank to another.
struct Parcel {
  int rank = 0;  ///< the other one
  std::vector<char> bytes;
};

/// Memory that goes to another rank, or that waits for what comes from it.
struct Post {
  int rank = 0;
  void* data = nullptr;
  std::size_t bytes = 0;
};

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

  /// Cores of this machine for each of the ranks on it.
  [[nodiscard]] int cores() const;

  /// \throws Error on all ranks when there is more than one.
  void require_one_rank() const;
  /// Work of one rank for all, files for example; where it throws an Error, all ranks do.
  void lead(const std::function<void()>& work) const;
  /// Waits until all ranks have come here, but not for ever; false when some have not.
  [[nodiscard]] bool together(double seconds) const;

  // Collective: all ranks call them in the same order, and all get the same answer, whatever their
  // number.
  [[nodiscard]] double least(double value) const;
  [[nodiscard]] double largest(double value) const;
  void largest(std::vector<double>& values) const;  ///< number by number
  [[nodiscard]] std::int64_t sum(std::int64_t value) const;
  [[nodiscard]] bool any(bool value) const;
  /// Bits that are set on some rank.
  [[nodiscard]] std::uint64_t bits(std::uint64_t value) const;
  /// Flags that are raised on some rank, flag by flag.
  void any(std::vector<std::uint8_t>& flags) const;
  /// Sums of numbers, added rank by rank: the last bits depend on the number of ranks.
  void add_up(std::vector<double>& values) const;
  /// What `from` has, for everybody.
  void share(std::vector<char>& bytes, int from) const;
  void share(std::string& text, int from) const;
  /// The bytes of all ranks in their order, at rank 0; nothing elsewhere.
  [[nodiscard]] std::vector<std::vector<char>> collect(const std::vector<char>& bytes) const;
  /// Delivers parcels of any length; each rank may send one to each other. Sorted by sender.
  [[nodiscard]] std::vector<Parcel> deliver(const std::vector<Parcel>& parcels) const;

  /// Between neighbours, who know what to expect: sends the memory of `out`, fills that of `in`.
  /// Not collective.
  void swap(const std::vector<Post>& out, const std::vector<Post>& in) const;

  /// Ends all ranks at once; for failures that only one rank has seen.
  [[noreturn]] void abort(int status) const;

 private:
  int rank_ = 0;
  int size_ = 1;
  bool owns_mpi_ = false;
};

}  // namespace breccia
