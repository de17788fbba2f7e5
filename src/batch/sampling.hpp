#pragma once

#include "core/settings.hpp"
#include "core/unit.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace breccia {

/// How random values are drawn.
struct Sampling {
  std::size_t samples = 0;
  std::uint64_t seed = 1;
  bool hypercube = false;  ///< one sample in every equal share of each distribution

  /// The share of its distribution, in (0, 1), that each sample of a key takes; `key` counts keys.
  [[nodiscard]] std::vector<double> shares(std::uint32_t key) const;
};

/// The distribution of a [[batch.uncertain]].
class Distribution {
 public:
  /// \throws Error when parameters are missing, too many, of different units or without sense.
  explicit Distribution(const Settings& section);

  /// The value below which this share of all values lies, in SI.
  [[nodiscard]] double quantile(double share) const;

  /// The unit of its values in SI; empty for pure numbers.
  [[nodiscard]] std::string unit_text() const;

 private:
  void read_parameters(const Settings& section);
  void read_bounds(const Settings& section);
  [[nodiscard]] double quantity(const Settings& section, const char* key);
  [[nodiscard]] double uncut_quantile(double share) const;
  [[nodiscard]] double share_below(double value) const;

  std::string kind_;
  double first_ = 0, second_ = 0;  ///< as the kind has them: bounds, mean and deviation, ...
  double low_ = 0, high_ = 1;      ///< shares below the bounds
  std::string unit_key_;           ///< the parameter that has said the dimension
  Dimension dimension_;
};

}  // namespace breccia
