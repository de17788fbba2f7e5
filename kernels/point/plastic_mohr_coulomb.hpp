#pragma once
#include "point/plastic_drucker_prager.hpp"

namespace breccia {

/// Mohr and Coulomb's pyramid with Rankine's tension cut-off and non-associated flow
/// (ALGORITHMS A-1.7c).
///
// symbols  s1 >= s2 >= s3 [Pa] principal stress, tension > 0   phi, psi [rad] friction, dilation
//          c(ep) [Pa] cohesion   sT [Pa] tension cut-off, at most c cot(phi)
//          n, m normals of a plane and of its potential   dl [1] multipliers
// eq:plastic-13  si - sk + (si + sk) sin(phi) - 2 c cos(phi) <= 0 for (i, k) = (1,3), (1,2), (2,3)
// eq:plastic-14  si <= sT, associated
// eq:plastic-15  s = s_trial - sum_j dl_j D m_j with n_j . s = strength_j, dl_j >= 0
// The planes that act are found by trying: one, then pairs (edges), then triples (apex, corners),
// 41 sets in all; the first set with multipliers not below 0 that leaves no plane violated. With
// one plane and two this gives the constants of A-1.7c; the apex is where the cut-off ends there.
// source   Koiter 1953; de Souza Neto, Peric, Owen (2008), chapter 8
struct MohrCoulomb {
  static constexpr int kHistory = 1;
  static constexpr std::array<HistoryEntry, 1> kHistoryEntries{kPlasticStrain};
  double bulk = 0, shear = 0;       ///< Pa
  double sin_phi = 0, cos_phi = 1;  ///< of friction
  double sin_psi = 0;               ///< of dilation, not above sin_phi
  Cohesion cohesion;
  double cut_off = 1e300;      ///< sT, Pa
  double strength_factor = 1;  ///< on c and sT, by the rate of strain

  /// 2 c cos(phi)
  template <class R>
  KOKKOS_INLINE_FUNCTION
  R strength(const R& ep) const { return R(2 * cos_phi * strength_factor) * cohesion.at(ep); }
  KOKKOS_INLINE_FUNCTION
  double tension_limit(double strength_now) const {
    const double cut = cut_off * strength_factor;
    return 2 * sin_phi * cut > strength_now ? strength_now / (2 * sin_phi) : cut;
  }
  /// Largest stress in simple tension, Pa, before any plastic strain.
  KOKKOS_INLINE_FUNCTION
  double uniaxial_tension() const {
    const double k = strength(0.0);
    return minimum(k / (1 + sin_phi), tension_limit(k));
  }

  template <class R>
  KOKKOS_FUNCTION
  R beyond(const R& mean, const R& root_j2, const R* history) const {
    // s1 - s3 <= 2 r, (s1 + s3) / 2 <= sm + r / sqrt(3), s1 <= sm + 2 r / sqrt(3)
    const R third = R(0.5773502691896258) * root_j2;
    const R pyramid = R(2) * root_j2 + R(2 * sin_phi) * (mean + third) - strength(history[0]);
    return maximum(pyramid, mean + R(2) * third - R(cut_off * strength_factor));
  }

  KOKKOS_FUNCTION
  double update(double (&strain)[3], double (&history)[kMaxHistory], double /*dt*/) const;

  /// Planes of eq:plastic-13 (0, 1, 2) and eq:plastic-14 (3, 4, 5).
  static constexpr int kPlanes = 6;
  KOKKOS_INLINE_FUNCTION
  static void plane(int which, double sine, double (&normal)[3]) {
    for (double& n : normal) n = 0;
    if (which >= 3) {
      normal[which - 3] = 1;
      return;
    }
    normal[which == 2 ? 1 : 0] = 1 + sine;
    normal[which == 1 ? 1 : 2] = sine - 1;
  }
  /// By how much a sorted stress violates a plane, Pa.
  KOKKOS_INLINE_FUNCTION
  double excess(int which, const double (&s)[3], double strength_now, double limit) const {
    double n[3];
    plane(which, sin_phi, n);
    return n[0] * s[0] + n[1] * s[1] + n[2] * s[2] - (which < 3 ? strength_now : limit);
  }
  KOKKOS_INLINE_FUNCTION
  double worst(const double (&s)[3], double strength_now, double limit) const {
    double most = excess(0, s, strength_now, limit);
    for (int k = 1; k < kPlanes; ++k) most = maximum(most, excess(k, s, strength_now, limit));
    return most;
  }
  /// Tries eq:plastic-15 with the planes set[0..count): true, and the stress, if it is the answer.
  KOKKOS_INLINE_FUNCTION
  bool try_planes(const int (&set)[3], int count, const double (&trial)[3], double strength_now,
                  double limit, double (&s)[3]) const;
  /// Sorted trial stress to the elastic domain of a given strength.
  KOKKOS_INLINE_FUNCTION
  void project(const double (&trial)[3], double strength_now, double limit, double (&s)[3]) const;
};
static_assert(InelasticLaw<MohrCoulomb>);

KOKKOS_INLINE_FUNCTION
bool MohrCoulomb::try_planes(const int (&set)[3], int count, const double (&trial)[3],
                             double strength_now, double limit, double (&s)[3]) const {
  double flow[3][3], a[3][4];  // D m_j; the equations of the multipliers with their right side
  for (int j = 0; j < count; ++j) {
    double m[3];
    plane(set[j], sin_psi, m);
    const double volume = (bulk - 2 * shear / 3) * (m[0] + m[1] + m[2]);
    for (int i = 0; i < 3; ++i) flow[j][i] = volume + 2 * shear * m[i];
  }
  for (int i = 0; i < count; ++i) {
    double n[3];
    plane(set[i], sin_phi, n);
    for (int j = 0; j < count; ++j)
      a[i][j] = n[0] * flow[j][0] + n[1] * flow[j][1] + n[2] * flow[j][2];
    a[i][3] = excess(set[i], trial, strength_now, limit);
  }
  for (int p = 0; p < count; ++p) {  // Gauss and Jordan: at most three unknowns
    int best = p;
    for (int i = p + 1; i < count; ++i)
      if (Kokkos::abs(a[i][p]) > Kokkos::abs(a[best][p])) best = i;
    if (!(Kokkos::abs(a[best][p]) > 1e-10 * shear)) return false;  // planes that depend
    for (int j = 0; j < 4; ++j) {
      const double other = a[p][j];
      a[p][j] = a[best][j];
      a[best][j] = other;
    }
    for (int i = 0; i < count; ++i) {
      if (i == p) continue;
      const double factor = a[i][p] / a[p][p];
      for (int j = p; j < 4; ++j) a[i][j] -= factor * a[p][j];
    }
  }
  for (int i = 0; i < 3; ++i) s[i] = trial[i];
  for (int j = 0; j < count; ++j) {
    const double multiplier = a[j][3] / a[j][j];
    if (multiplier < 0) return false;
    for (int i = 0; i < 3; ++i) s[i] -= multiplier * flow[j][i];
  }
  const double size = strength_now + Kokkos::abs(trial[0]) + Kokkos::abs(trial[2]);
  return worst(s, strength_now, limit) <= 1e-12 * size;
}

KOKKOS_INLINE_FUNCTION
void MohrCoulomb::project(const double (&trial)[3], double strength_now, double limit,
                          double (&s)[3]) const {
  for (int a = 0; a < kPlanes; ++a)
    if (try_planes({a, 0, 0}, 1, trial, strength_now, limit, s)) return;
  for (int a = 0; a < kPlanes; ++a)
    for (int b = a + 1; b < kPlanes; ++b)
      if (try_planes({a, b, 0}, 2, trial, strength_now, limit, s)) return;
  for (int a = 0; a < kPlanes; ++a)
    for (int b = a + 1; b < kPlanes; ++b)
      for (int c = b + 1; c < kPlanes; ++c)
        if (try_planes({a, b, c}, 3, trial, strength_now, limit, s)) return;
  // No set of planes answers (flow far from associated, by round-off): the deviator shrinks.
  const double middle = (trial[0] + trial[1] + trial[2]) / 3, mean = minimum(middle, limit);
  double keep = 1;
  const double centre[3] = {mean, mean, mean};
  const double shifted[3] = {trial[0] - middle + mean, trial[1] - middle + mean,
                             trial[2] - middle + mean};
  for (int k = 0; k < kPlanes; ++k) {
    const double inside = -excess(k, centre, strength_now, limit);
    const double way = excess(k, shifted, strength_now, limit) + inside;
    if (way > 0) keep = minimum(keep, maximum(0.0, inside) / way);
  }
  for (int i = 0; i < 3; ++i) s[i] = mean + keep * (trial[i] - middle);
}

KOKKOS_INLINE_FUNCTION
double MohrCoulomb::update(double (&strain)[3], double (&history)[kMaxHistory],
                           double /*dt*/) const {
  const PrincipalStress now = PrincipalStress::of(strain, bulk, shear);
  int order[3] = {0, 1, 2};
  const auto sort = [&](int a, int b) {
    if (now.tau[order[a]] >= now.tau[order[b]]) return;
    const int other = order[a];
    order[a] = order[b];
    order[b] = other;
  };
  sort(0, 1);
  sort(1, 2);
  sort(0, 1);
  const double trial[3] = {now.tau[order[0]], now.tau[order[1]], now.tau[order[2]]};
  const double start = strength(history[0]);
  if (!(worst(trial, start, tension_limit(start)) > 0)) return 0;

  // With a cohesion that changes the strength is that of the plastic strain found: iterated, and
  // the last return is to the strength that the history kept says.
  double s[3], grown = 0, work = 0;
  const int passes = cohesion.strain > 0 ? 8 : 1;
  for (int pass = 0; pass < passes; ++pass) {
    const double k = strength(history[0] + grown);
    project(trial, k, tension_limit(k), s);
    if (pass + 1 == passes && passes > 1) break;
    double change[3], trace = 0, square = 0;
    for (int i = 0; i < 3; ++i) trace += (trial[i] - s[i]) / (9 * bulk);
    const double mean = trace * 3 * bulk;
    for (int i = 0; i < 3; ++i) {
      change[i] = trace + (trial[i] - s[i] - mean) / (2 * shear);
      square += change[i] * change[i];
    }
    grown = Kokkos::sqrt(2 * square / 3);
  }
  PrincipalStress end;
  for (int i = 0; i < 3; ++i) end.tau[order[i]] = s[i];
  double elastic[3];
  end.to_strain(bulk, shear, elastic);
  for (int i = 0; i < 3; ++i) {
    work += end.tau[i] * (strain[i] - elastic[i]);
    strain[i] = elastic[i];
  }
  history[0] += grown;
  return work > 0 ? work : 0;
}

}  // namespace breccia
