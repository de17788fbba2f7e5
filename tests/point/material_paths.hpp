#pragma once
#include "point/inelastic.hpp"

#include <cmath>

namespace breccia {

/// A material point under control of its axial strain and its lateral stress.
template <class Law>
struct PointDriver {
  Law law;
  double strain[3] = {0, 0, 0};  ///< elastic
  double history[kMaxHistory] = {};
  double work = 0;              ///< plastic, J/m3
  double total[3] = {0, 0, 0};  ///< strain put in

  PrincipalStress stress() const { return PrincipalStress::of(strain, law.bulk, law.shear); }

  void step(double axial, double lateral_1, double lateral_2, double dt = 1e-6) {
    const double change[3] = {axial, lateral_1, lateral_2};
    for (int i = 0; i < 3; ++i) {
      strain[i] += change[i];
      total[i] += change[i];
    }
    work += law.update(strain, history, dt);
  }

  /// One step of axial strain; the lateral one is found by halving so that the lateral Kirchhoff
  /// stress is the wanted one.
  void step_held(double axial, double lateral_stress, double dt = 1e-6) {
    double low = -10 * std::abs(axial) - 1e-9, high = -low;
    low -= std::abs(lateral_stress) / law.shear;
    high += std::abs(lateral_stress) / law.shear;
    for (int i = 0; i < 200; ++i) {
      const double middle = 0.5 * (low + high);
      PointDriver trial = *this;
      trial.step(axial, middle, middle, dt);
      (trial.stress().tau[1] < lateral_stress ? low : high) = middle;
    }
    step(axial, high, high, dt);
  }

  /// Trace of the plastic strain.
  double plastic_volume() const {
    return total[0] + total[1] + total[2] - strain[0] - strain[1] - strain[2];
  }
};

}  // namespace breccia
