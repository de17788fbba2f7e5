#pragma once
#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace breccia {

/// What Kokkos did while this object lived, through the callbacks of Kokkos Tools. One at a time.
class KokkosLog {
 public:
  KokkosLog();
  ~KokkosLog();
  KokkosLog(const KokkosLog&) = delete;
  KokkosLog& operator=(const KokkosLog&) = delete;

  struct Record {
    std::map<std::string, std::int64_t> launches;     ///< by label
    std::map<std::string, std::int64_t> allocations;  ///< by label
    std::map<std::string, std::uint64_t> bytes;       ///< allocated, by label
    std::map<std::string, std::int64_t> held;         ///< bytes less those that were freed
    std::vector<std::string> copies;                  ///< deep copies: source -> destination
    std::vector<std::string> fences;
  };
  const Record& record() const;

  std::int64_t launches() const { return sum(record().launches); }
  std::int64_t allocations() const { return sum(record().allocations); }
  /// Launches and allocations whose label begins with "breccia::<effect>::", and their bytes.
  std::int64_t launches_of(const std::string& effect) const;
  std::int64_t allocations_of(const std::string& effect) const;
  std::int64_t held_by(const std::string& effect) const;

 private:
  static std::int64_t sum(const std::map<std::string, std::int64_t>& counts);
  static std::int64_t sum_of(const std::map<std::string, std::int64_t>& counts,
                             const std::string& effect);
};

}  // namespace breccia
