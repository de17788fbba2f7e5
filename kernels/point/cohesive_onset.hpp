#pragma once
#include "base/vec.hpp"

namespace breccia {

/// When a bonded face is replaced by an interface.
///
// symbols  t [Pa] traction on the face, t_n, t_s its normal and shear parts
//          f_t, c_0 [Pa] tensile strength, cohesion   mu_i [1] friction of the intact face
//          e [1/s] rate of deformation of the face, e_0 where strength begins to grow
// source   ALGORITHMS
// page     docs/modules/fracture.md
struct CohesiveOnset {
  double tension = 0, cohesion = 0, friction = 0;
  double alpha = 1;
  bool elliptic = false;
  double rate_reference = 0;  ///< e_0, 1/s; 0: no rate counts
  double rate_exponent = 0, rate_limit = 1;

  /// eq:cohesive-22  share = min(limit, max(1, (e / e_0)^exponent)), on f_t and c_0 alike
  KOKKOS_FUNCTION
  double dynamic_share(double rate) const {
    if (!(rate > rate_reference)) return 1;
    return Kokkos::min(rate_limit, Kokkos::pow(rate / rate_reference, rate_exponent));
  }

  /// The onset of a face whose strengths are this share of what they are at rest.
  KOKKOS_FUNCTION
  CohesiveOnset scaled(double share) const {
    CohesiveOnset onset = *this;
    onset.tension *= share;
    onset.cohesion *= share;
    return onset;
  }

  /// Share of the strength that is used; 1 on the envelope.
  template <int D>
  KOKKOS_FUNCTION
  double measure(const Vec<D>& traction, const Vec<D>& normal) const {
    const double t_n = dot(traction, normal);
    const double t_s = norm(traction - normal * t_n);
    const double f_te = t_n / tension;  // eq:cohesive-17
    if (elliptic) {
      // eq:cohesive-18  f^2 = max(f_te, 0)^2 + (t_s / (c_0 - mu_i t_n))^2
      const double strength = cohesion - friction * t_n;
      if (!(strength > 0)) return f_te > 1 ? f_te : 1;
      const double opening = f_te > 0 ? f_te : 0, sliding = t_s / strength;
      return Kokkos::sqrt(opening * opening + sliding * sliding);
    }
    const double f_sh = (t_s + friction * t_n) / cohesion;  // eq:cohesive-19
    return f_te > f_sh ? f_te : f_sh;
  }
};

}  // namespace breccia
