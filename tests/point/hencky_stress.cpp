#include "point/hencky_stress.hpp"

#include "point/anisotropic.hpp"

#include <gtest/gtest.h>

#include <random>

namespace {

using namespace breccia;

/// A stiffness without any symmetry but its own, positive definite, Pa.
Anisotropic any_stiffness() {
  std::mt19937 generator(7);
  std::uniform_real_distribution<double> number(-0.3, 0.3);
  double root[6][6];
  for (int i = 0; i < 6; ++i)
    for (int j = 0; j < 6; ++j) root[i][j] = (i == j ? 1 : 0) + number(generator);
  Anisotropic law;
  for (int i = 0; i < 6; ++i)
    for (int j = 0; j < 6; ++j) {
      for (int k = 0; k < 6; ++k) law.c[i][j] += 1e9 * root[i][k] * root[j][k];
      if (j >= 3) law.c[i][j] *= 2;
    }
  return law;
}

template <int D>
Mat<D> deformation(double size, unsigned seed) {
  std::mt19937 generator(seed);
  std::uniform_real_distribution<double> number(-size, size);
  Mat<D> f = Mat<D>::identity();
  for (int i = 0; i < D; ++i)
    for (int j = 0; j < D; ++j) f(i, j) += number(generator);
  return f;
}

template <int D>
FullSym<D> strain(const Mat<D>& f) {
  return {hencky_strain(right_cauchy_green(f), determinant(f)), 0};
}

template <int D>
double energy(const Anisotropic& law, const Mat<D>& f) {
  const FullSym<D> eps = strain(f);
  return 0.5 * contract(law.stress(eps), eps);
}

/// P : dF of the law against the difference quotient of its energy.
template <int D>
void expect_derivative(double size) {
  const Anisotropic law = any_stiffness();
  for (unsigned seed = 0; seed < 20; ++seed) {
    const Mat<D> f = deformation<D>(size, seed), way = deformation<D>(1.0, 100 + seed);
    const Sym<D> s = second_piola(law.stress(strain(f)).in, right_cauchy_green(f), determinant(f));
    double power = 0;
    for (int i = 0; i < D; ++i)
      for (int j = 0; j < D; ++j)
        for (int k = 0; k < D; ++k) power += f(i, k) * s(k, j) * way(i, j);
    const double h = 1e-3 * size;
    double quotient = 0;  // fourth order: error h^4
    for (const auto& [at, weight] : {std::pair{-2, 1.0}, {-1, -8.0}, {1, 8.0}, {2, -1.0}}) {
      Mat<D> moved = f;
      for (int i = 0; i < D; ++i)
        for (int j = 0; j < D; ++j) moved(i, j) += at * h * way(i, j);
      quotient += weight * energy(law, moved) / (12 * h);
    }
    // Strains have round-off near 1e-16 whatever their size; the quotient divides it by h.
    EXPECT_NEAR(power, quotient, 1e9 * (3e-15 * size / h + 1e-9 * size)) << size;
  }
}

TEST(HenckyStress, IsTheDerivativeOfTheEnergyInThePlane) {
  for (const double size : {1e-4, 1e-2, 0.2}) expect_derivative<2>(size);
}

TEST(HenckyStress, IsTheDerivativeOfTheEnergyInSpace) {
  for (const double size : {1e-5, 1e-3, 1e-2, 0.15}) expect_derivative<3>(size);
}

// For an isotropic law S = F^-1 tau F^-T with tau = t of the left strain.
TEST(HenckyStress, OfAnIsotropicLawIsTheLawInSpatialAxes) {
  const HenckyElastic law{3e9, 2e9};
  for (const double size : {1e-5, 1e-3, 0.2}) {
    const Mat<3> f = deformation<3>(size, 3);
    const double jacobian = determinant(f);
    const Sym<3> t = law.kirchhoff(hencky_strain(right_cauchy_green(f), jacobian));
    const Sym<3> tau = congruent(f, second_piola(t, right_cauchy_green(f), jacobian));
    const Sym<3> expected = law.kirchhoff(hencky_strain(left_cauchy_green(f), jacobian));
    for (int i = 0; i < 6; ++i) EXPECT_NEAR(tau.s[i], expected.s[i], 1e10 * (1e-15 + 1e-12 * size));
  }
}

// Lanes in the reach of the series and beyond it, in one pack: to the last bit.
TEST(HenckyStress, IsTheSameInEveryLane) {
  const Anisotropic law = any_stiffness();
  constexpr int kLanes = lanes<Pack>();
  Sym<3, Pack> packed_t, packed_c;
  Sym<3> t[kLanes], c[kLanes];
  for (int l = 0; l < kLanes; ++l) {
    const double sizes[] = {1e-6, 1e-4, 0.1};  // two terms of the series, four, eigenvalues
    const Mat<3> f = deformation<3>(sizes[l % 3], static_cast<unsigned>(l));
    c[l] = right_cauchy_green(f);
    t[l] = law.stress(strain(f)).in;
  }
  for (int i = 0; i < 6; ++i) {
    packed_t.s[i] = fill<Pack>([&](int l) { return t[l].s[i]; });
    packed_c.s[i] = fill<Pack>([&](int l) { return c[l].s[i]; });
  }
  const Sym<3, Pack> s = second_piola(packed_t, packed_c, Pack(1));
  for (int i = 0; i < 6; ++i) {
    double value[kLanes];
    store(s.s[i], value);
    for (int l = 0; l < kLanes; ++l) {
      const Sym<3> alone = second_piola(t[l], c[l], 1.0);
      EXPECT_EQ(value[l], alone.s[i]) << l;
    }
  }
}

}  // namespace
