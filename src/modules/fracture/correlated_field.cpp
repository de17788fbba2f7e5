#include "modules/fracture/correlated_field.hpp"

#include "core/random.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace breccia {

namespace {

/// Waves in the sum: its kurtosis is that of Gauss less 1.5 over their number.
constexpr int kWaves = 128;
constexpr std::uint32_t kStream = 0x77617665;  // "wave": independent of other random fields

}  // namespace

// The transform of exp(-(r/l)^2) is a Gaussian of deviation sqrt(2)/l in each wave number.
CorrelatedField::CorrelatedField(int seed, double length) {
  const Random random{static_cast<std::uint64_t>(seed), kStream};
  for (int i = 0; i < kWaves; ++i) {
    const auto id = static_cast<std::uint64_t>(i);
    Wave wave;
    for (std::uint32_t d = 0; d < 3; ++d)
      wave.number[d] = std::numbers::sqrt2 / length * random.normal(id, d);
    wave.phase = 2 * std::numbers::pi * random.uniform(id, 3);
    waves_.push_back(wave);
  }
}

double CorrelatedField::value(const std::array<double, 3>& place) const {
  double sum = 0;
  for (const Wave& wave : waves_)
    sum += std::cos(wave.number[0] * place[0] + wave.number[1] * place[1] +
                    wave.number[2] * place[2] + wave.phase);
  return std::sqrt(2.0 / kWaves) * sum;
}

double CorrelatedField::share(const std::array<double, 3>& place) const {
  const double below = 0.5 * std::erfc(-value(place) / std::numbers::sqrt2);
  return std::clamp(below, 0x1.0p-53, 1 - 0x1.0p-53);
}

}  // namespace breccia
