// Isotropic elasticity in logarithmic strain: V-005 (which rate), V-004 (objectivity), the law
// itself against tensors made from their principal values.
#include "point/hencky.hpp"

#include "harness/tensors.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace breccia {
namespace {

const HenckyElastic kLaw{40e9, 30e9};
constexpr double kModulus = 40e9 + 2 * 30e9;

template <int D, class R = double>
Sym<D, R> kirchhoff(const Mat<D, R>& f) {
  return kLaw.kirchhoff(hencky_strain(left_cauchy_green(f), determinant(f)));
}

/// F = V R of principal stretches exp(eps) and random axes; `eps` of size about `size`.
template <int D>
struct Sample {
  Vec<D> principal;
  Mat<D> axes, f;

  Sample(std::uint64_t id, double size) {
    const Random random{7, 3};
    axes = random_rotation<D>(random, 2 * id);
    Vec<D> stretch;
    for (int k = 0; k < D; ++k) {
      principal[k] = size * (2 * random.uniform(id, static_cast<std::uint32_t>(k)) - 1);
      stretch[k] = std::exp(principal[k]);
    }
    f = full(spectral(axes, stretch)) * random_rotation<D>(random, 2 * id + 1);
  }
};

// B is rounded to eps |B|, which shifts the logarithm of its smallest principal value by eps times
// the ratio of the largest to the smallest.
double rounding(double size) {
  return 20 * 2.3e-16 * std::exp(4 * size);
}

template <int D>
void check_against_principal_values(double size) {
  for (std::uint64_t id = 0; id < 500; ++id) {
    const Sample<D> s(id, size);
    const Sym<D> eps = hencky_strain(left_cauchy_green(s.f), determinant(s.f));
    EXPECT_LT(distance(eps, spectral(s.axes, s.principal)), rounding(size)) << id;
  }
}

/// ln U from C - 1 and J - 1, in R, against principal values; `rounding` of R times the strain is
/// allowed.
template <int D, class R>
void check_growth(double size, double rounding) {
  for (std::uint64_t id = 0; id < 500; ++id) {
    const Random random{7, 3};
    const Mat<D> axes = random_rotation<D>(random, 2 * id);
    Vec<D> principal, growth;
    for (int k = 0; k < D; ++k) {
      principal[k] = size * (2 * random.uniform(id, static_cast<std::uint32_t>(k)) - 1);
      growth[k] = std::expm1(2 * principal[k]);
    }
    const Sym<D> exact = spectral(axes, growth);
    Sym<D, R> e;
    for (int i = 0; i < Sym<D>::size; ++i) e.s[i] = static_cast<R>(exact.s[i]);
    double sum = 0;
    for (int k = 0; k < D; ++k) sum += principal[k];
    const R dilation = static_cast<R>(std::expm1(sum));
    const Sym<D, R> eps = hencky_strain_of_growth(e, dilation);
    Sym<D> wide;
    for (int i = 0; i < Sym<D>::size; ++i) wide.s[i] = eps.s[i];
    EXPECT_LT(distance(wide, spectral(axes, principal)), rounding * size * std::exp(4 * size))
        << id << ' ' << size;
  }
}

// The smaller the strain, the smaller the error: nothing is taken from one.
TEST(Hencky, StrainOfAGrowthHasTheErrorOfTheGrowth) {
  for (const double size : {1e-12, 1e-6, 1e-3, 0.05, 0.13, 0.3, 0.7}) {
    check_growth<2, double>(size, 20 * 1.1e-16);
    check_growth<3, double>(size, 20 * 1.1e-16);
    check_growth<2, float>(size, 20 * 6e-8);
    check_growth<3, float>(size, 20 * 6e-8);
  }
}

// Sizes on both sides of where the series ends (stretch 1.3), and far beyond.
TEST(Hencky, StrainOfKnownPrincipalStretches) {
  for (const double size : {1e-9, 1e-3, 0.05, 0.13, 0.3, 0.7, 2.0}) {
    SCOPED_TRACE(size);
    check_against_principal_values<2>(size);
    check_against_principal_values<3>(size);
  }
}

template <int D>
void check_equal_stretches() {
  for (const double eps : {-1.0, -0.01, 0.0, 0.2, 1.0}) {
    Mat<D> f = Mat<D>::zero();
    for (int i = 0; i < D; ++i) f(i, i) = std::exp(eps);
    const Sym<D> strain = hencky_strain(left_cauchy_green(f), determinant(f));
    EXPECT_LT(distance(strain, Sym<D>::identity() * eps), 2e-15) << eps;
  }
}

TEST(Hencky, EqualStretchesAreNoSpecialCase) {
  check_equal_stretches<2>();
  check_equal_stretches<3>();
}

// A pack of lanes is one element each; those beyond the series, none to all of them, must not
// disturb their neighbours.
template <int D>
void check_lanes(int beyond) {
  using R = HostPack;
  const auto size = [beyond](int l) { return l < beyond ? 1.0 : 1e-3; };
  Mat<D> f[lanes<R>()];
  for (int l = 0; l < lanes<R>(); ++l) f[l] = Sample<D>(static_cast<std::uint64_t>(l), size(l)).f;
  Mat<D, R> packed;
  for (int i = 0; i < D; ++i)
    for (int j = 0; j < D; ++j) packed(i, j) = fill<R>([&](int l) { return f[l](i, j); });
  const Sym<D, R> tau = kirchhoff(packed);
  for (int c = 0; c < Sym<D>::size; ++c) {
    double lane[lanes<R>()];
    store(tau.s[c], lane);
    for (int l = 0; l < lanes<R>(); ++l)
      EXPECT_NEAR(lane[l], kirchhoff(f[l]).s[c], kModulus * rounding(size(l))) << l;
  }
}

TEST(Hencky, LanesDoNotSeeEachOther) {
  for (int beyond = 0; beyond <= lanes<HostPack>(); ++beyond) {
    check_lanes<2>(beyond);
    check_lanes<3>(beyond);
  }
}

/// V-005: simple shear of amount g has ln V = asinh(g/2) on axes whose double angle has the
/// tangent 2/g, so tau_12 = 4 mu asinh(g/2) / sqrt(4 + g^2), tau_11 = -tau_22 = g/2 tau_12.
template <int D>
void check_simple_shear() {
  const double mu = kLaw.mu;
  double last = 0;
  for (double g = 0; g <= 8.001; g += 0.05) {
    Mat<D> f = Mat<D>::identity();
    f(0, 1) = g;
    const Sym<D> tau = kirchhoff(f);
    const double shear = 4 * mu * std::asinh(0.5 * g) / std::sqrt(4 + g * g);
    // The larger stretch of B is (g/2)^4 times the smaller one: eps times that is lost.
    const double allowed = mu * 1e-14 * (1 + g * g * g * g);
    EXPECT_NEAR(tau(0, 1), shear, allowed) << g;
    EXPECT_NEAR(tau(0, 0), 0.5 * g * shear, allowed) << g;
    EXPECT_NEAR(tau(1, 1), -0.5 * g * shear, allowed) << g;
    // No oscillation (a Jaumann rate would change sign): the normal stress only grows.
    EXPECT_GE(tau(0, 0), last);
    last = tau(0, 0);
  }
}

TEST(Hencky, SimpleShearFollowsItsOwnClosedForm) {
  check_simple_shear<2>();
  check_simple_shear<3>();
}

template <int D>
void check_rotation() {
  const Random random{5, 1};
  for (std::uint64_t id = 0; id < 100; ++id) {
    const Mat<D> q = random_rotation<D>(random, id);
    EXPECT_LT(largest(kirchhoff(q)), 4e-15 * kModulus);  // V-004: a rotation is no strain
    const Sample<D> s(id, 0.2);
    const Sym<D> tau = kirchhoff(s.f);
    EXPECT_LT(distance(kirchhoff(q * s.f), rotated(tau, q)), 1e-12 * largest(tau));
    EXPECT_LT(distance(kirchhoff(s.f * q), tau), 1e-12 * largest(tau));  // isotropy
  }
}

TEST(Hencky, StressTurnsWithTheBody) {
  check_rotation<2>();
  check_rotation<3>();
}

// V-004: a prestressed element turned by 90 degrees.
TEST(Hencky, QuarterTurnSwapsTheAxes) {
  const Mat<2> f{{{1.2, 0.1}, {0.05, 0.9}}};
  const Sym<2> tau = kirchhoff(f), turned = kirchhoff(rotation_matrix(std::acos(0.0)) * f);
  EXPECT_NEAR(turned(0, 0), tau(1, 1), 1e-14 * kModulus);
  EXPECT_NEAR(turned(1, 1), tau(0, 0), 1e-14 * kModulus);
  EXPECT_NEAR(turned(0, 1), -tau(0, 1), 1e-14 * kModulus);
  EXPECT_NEAR(trace(turned), trace(tau), 1e-12 * std::abs(trace(tau)));
  EXPECT_NEAR(contract(turned, turned), contract(tau, tau), 1e-12 * contract(tau, tau));
}

/// tau : d is the rate of the strain energy for every motion: the law is exactly hyperelastic.
template <int D>
void check_power() {
  const Random random{9, 2};
  const double h = 1e-5;
  for (std::uint64_t id = 0; id < 200; ++id) {
    const Sample<D> s(id, 0.4);
    Mat<D> l;
    for (int i = 0; i < D; ++i)
      for (int j = 0; j < D; ++j)
        l(i, j) = random.normal(id, static_cast<std::uint32_t>(3 * i + j));
    const auto energy = [&](double t) {
      Mat<D> g = Mat<D>::identity();
      for (int i = 0; i < D; ++i)
        for (int j = 0; j < D; ++j) g(i, j) += t * l(i, j);
      const Mat<D> f = g * s.f;
      return kLaw.energy(hencky_strain(left_cauchy_green(f), determinant(f)));
    };
    const double power = contract(kirchhoff(s.f), symmetric_part(l));
    // Central difference: h^2 times a third derivative, and round-off of w over h.
    EXPECT_NEAR((energy(h) - energy(-h)) / (2 * h), power, 1e-8 * kModulus) << id;
  }
}

TEST(Hencky, PowerOfStressIsRateOfEnergy) {
  check_power<2>();
  check_power<3>();
}

template <int D>
void check_small_strain() {
  const Random random{11, 4};
  for (std::uint64_t id = 0; id < 100; ++id) {
    Mat<D> h;
    for (int i = 0; i < D; ++i)
      for (int j = 0; j < D; ++j)
        h(i, j) = 1e-6 * random.normal(id, static_cast<std::uint32_t>(3 * i + j));
    Mat<D> f = h;
    for (int i = 0; i < D; ++i) f(i, i) += 1;
    double size2 = 0;
    for (const auto& row : h.m)
      for (const double c : row) size2 += c * c;
    // What is left out is of second order in the displacement gradient.
    EXPECT_LT(distance(kirchhoff(f), kLaw.kirchhoff(symmetric_part(h))), kModulus * size2) << id;
  }
}

TEST(Hencky, SmallStrainsAreLinearElasticity) {
  check_small_strain<2>();
  check_small_strain<3>();
}

// S-10: an element pressed to a twentieth and one pulled to ten times its length stay finite.
TEST(Hencky, ExtremeStretchesStayFinite) {
  for (const double stretch : {0.05, 0.2, 3.0, 10.0}) {
    Mat<3> f = Mat<3>::identity();
    f(0, 0) = stretch;
    const double one = (kLaw.lambda + 2 * kLaw.mu) * std::log(stretch);
    EXPECT_NEAR(kirchhoff(f)(0, 0), one, 1e-12 * kModulus) << stretch;
    EXPECT_NEAR(kirchhoff(f)(1, 1), kLaw.lambda * std::log(stretch), 1e-12 * kModulus) << stretch;
  }
}

}  // namespace
}  // namespace breccia
