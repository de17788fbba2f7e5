#pragma once
#include <array>
#include <vector>

namespace breccia {

/// A random field over space, mean 0 and variance 1, whose values at a distance r are correlated by
/// exp(-(r / length)^2). The sum of waves whose directions and lengths are drawn from the field's
/// spectrum (Shinozuka and Deodatis 1996, doi:10.1115/1.3101883); counted random numbers, so that a
/// value depends on seed and place alone.
class CorrelatedField {
 public:
  CorrelatedField(int seed, double length);

  /// At a place, m.
  double value(const std::array<double, 3>& place) const;
  /// The same as a number that is spread evenly over (0, 1).
  double share(const std::array<double, 3>& place) const;

 private:
  struct Wave {
    std::array<double, 3> number;  ///< 1/m
    double phase;
  };
  std::vector<Wave> waves_;
};

}  // namespace breccia
