#pragma once
#include <time.h>

#include <algorithm>
#include <functional>
#include <vector>

namespace breccia {

/// Seconds that all threads of this process have computed.
inline double processor_seconds() {
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

inline double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/// How much longer `b` takes than `a`: the median over the turns of b / a, where each turn runs
/// both, in changing order, so that whatever else the machine does meets both alike.
inline double paired_ratio(int turns, const std::function<void()>& a,
                           const std::function<void()>& b) {
  const auto seconds = [](const std::function<void()>& work) {
    const double start = processor_seconds();
    work();
    return processor_seconds() - start;
  };
  std::vector<double> ratio;
  for (int turn = 0; turn < turns; ++turn) {
    const bool swapped = turn % 2 == 1;
    const double first = seconds(swapped ? b : a);
    const double second = seconds(swapped ? a : b);
    ratio.push_back(swapped ? first / second : second / first);
  }
  return median(ratio);
}

}  // namespace breccia
