#include "cost/kokkos_log.hpp"

#include <Kokkos_Core.hpp>

namespace breccia {

namespace {

// The callbacks are plain functions, so what they write to has to be global.
KokkosLog::Record current;

void launched(const char* name, std::uint32_t, std::uint64_t*) {
  ++current.launches[name];
}

void allocated(Kokkos::Tools::SpaceHandle, const char* label, const void*, std::uint64_t bytes) {
  ++current.allocations[label];
  current.bytes[label] += bytes;
  current.held[label] += static_cast<std::int64_t>(bytes);
}

void freed(Kokkos::Tools::SpaceHandle, const char* label, const void*, std::uint64_t bytes) {
  current.held[label] -= static_cast<std::int64_t>(bytes);
}

void copied(Kokkos::Tools::SpaceHandle, const char* to, const void*, Kokkos::Tools::SpaceHandle,
            const char* from, const void*, std::uint64_t) {
  current.copies.push_back(std::string(from) + " -> " + to);
}

void fenced(const char* name, std::uint32_t, std::uint64_t*) {
  current.fences.emplace_back(name);
}

}  // namespace

KokkosLog::KokkosLog() {
  namespace tools = Kokkos::Tools::Experimental;
  current = {};
  tools::set_begin_parallel_for_callback(launched);
  tools::set_begin_parallel_reduce_callback(launched);
  tools::set_begin_parallel_scan_callback(launched);
  tools::set_allocate_data_callback(allocated);
  tools::set_deallocate_data_callback(freed);
  tools::set_begin_deep_copy_callback(copied);
  tools::set_begin_fence_callback(fenced);
}

KokkosLog::~KokkosLog() {
  namespace tools = Kokkos::Tools::Experimental;
  tools::set_begin_parallel_for_callback(nullptr);
  tools::set_begin_parallel_reduce_callback(nullptr);
  tools::set_begin_parallel_scan_callback(nullptr);
  tools::set_allocate_data_callback(nullptr);
  tools::set_deallocate_data_callback(nullptr);
  tools::set_begin_deep_copy_callback(nullptr);
  tools::set_begin_fence_callback(nullptr);
}

const KokkosLog::Record& KokkosLog::record() const {
  return current;
}

std::int64_t KokkosLog::launches_of(const std::string& effect) const {
  return sum_of(current.launches, effect);
}

std::int64_t KokkosLog::allocations_of(const std::string& effect) const {
  return sum_of(current.allocations, effect);
}

std::int64_t KokkosLog::held_by(const std::string& effect) const {
  return sum_of(current.held, effect);
}

std::int64_t KokkosLog::sum(const std::map<std::string, std::int64_t>& counts) {
  std::int64_t n = 0;
  for (const auto& [label, count] : counts) n += count;
  return n;
}

std::int64_t KokkosLog::sum_of(const std::map<std::string, std::int64_t>& counts,
                               const std::string& effect) {
  const std::string front = "breccia::" + effect + "::";
  std::int64_t n = 0;
  for (const auto& [label, count] : counts)
    if (label.compare(0, front.size(), front) == 0) n += count;
  return n;
}

}  // namespace breccia
