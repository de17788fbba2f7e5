#include "step/anisotropy.hpp"

#include "point/principal.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <numbers>

namespace breccia {

namespace {

using Six = std::array<std::array<double, 6>, 6>;

/// Order of the first leading minor that is not positive, 0 where all are (Sylvester's criterion,
/// by the pivots of Gaussian elimination).
int failing_minor(Six a) {
  for (std::size_t k = 0; k < 6; ++k) {
    if (!(a[k][k] > 0)) return static_cast<int>(k) + 1;
    for (std::size_t i = k + 1; i < 6; ++i)
      for (std::size_t j = 6; j-- > k;) a[i][j] -= a[i][k] / a[k][k] * a[k][j];
  }
  return 0;
}

/// Inverse of a positive definite matrix (Gauss-Jordan).
Six inverse(Six a) {
  Six r{};
  for (std::size_t i = 0; i < 6; ++i) r[i][i] = 1;
  for (std::size_t k = 0; k < 6; ++k) {
    const double pivot = a[k][k];
    for (std::size_t j = 0; j < 6; ++j) {
      a[k][j] /= pivot;
      r[k][j] /= pivot;
    }
    for (std::size_t i = 0; i < 6; ++i) {
      if (i == k) continue;
      const double f = a[i][k];
      for (std::size_t j = 0; j < 6; ++j) {
        a[i][j] -= f * a[k][j];
        r[i][j] -= f * r[k][j];
      }
    }
  }
  return r;
}

/// Engineering form, Voigt: symmetric, acts on doubled shears.
Six engineering(const Anisotropic& law) {
  Six c{};
  for (std::size_t i = 0; i < 6; ++i)
    for (std::size_t j = 0; j < 6; ++j) c[i][j] = law.c[i][j] / (j < 3 ? 1 : 2);
  return c;
}

Anisotropic law_of(const Six& c) {
  Anisotropic law;
  for (std::size_t i = 0; i < 6; ++i)
    for (std::size_t j = 0; j < 6; ++j) law.c[i][j] = c[i][j] * (j < 3 ? 1 : 2);
  return law;
}

/// From Young's moduli, Poisson's ratios 12, 13, 23 (contraction along the second axis by a load
/// along the first) and shear moduli 12, 13, 23.
Six compliance(const std::array<double, 3>& young, const std::array<double, 3>& poisson,
               const std::array<double, 3>& shear) {
  Six s{};
  for (std::size_t i = 0; i < 3; ++i) s[i][i] = 1 / young[i];
  s[0][1] = s[1][0] = -poisson[0] / young[0];
  s[0][2] = s[2][0] = -poisson[1] / young[0];
  s[1][2] = s[2][1] = -poisson[2] / young[1];
  s[3][3] = 1 / shear[2];
  s[4][4] = 1 / shear[1];
  s[5][5] = 1 / shear[0];
  return s;
}

std::array<double, 3> three(const Settings& section, const char* key) {
  const auto& v = section.vector(key);
  if (v.size() != 3)
    throw section.error(key, fmt::format("{} numbers; three are wanted", v.size()));
  return {v[0], v[1], v[2]};
}

Six inverted(const Settings& section, const Six& s) {
  const int minor = failing_minor(s);
  if (minor != 0)
    throw section.error("",
                        fmt::format("a strain would give energy: the leading minor of order {} of "
                                    "the compliance is not positive",
                                    minor),
                        "make the Poisson ratios smaller: nu_ij^2 < E_i / E_j, all three together");
  return inverse(s);
}

Six read_orthotropic(const Settings& s) {
  return inverted(s, compliance(three(s, "young"), three(s, "poisson"), three(s, "shear")));
}

Six read_transverse(const Settings& s, int dimension) {
  const double e = s.number("young"), axis = s.number("young_axis"), nu = s.number("poisson");
  const double across = s.number("poisson_axis"), g = s.number("shear_axis");
  const double inside = e / (2 * (1 + nu));
  const double other = across * e / axis;  // contraction along the axis by a load across it
  if (dimension == 2)
    return inverted(s, compliance({e, axis, e}, {other, nu, across}, {g, inside, g}));
  return inverted(s, compliance({e, e, axis}, {nu, other, other}, {inside, g, g}));
}

Six read_stiffness(const Settings& s, int dimension) {
  const auto& given = s.vector("constants");
  if (given.size() != 21)
    throw s.error("constants", fmt::format("{} numbers; a stiffness has 21", given.size()),
                  "[C11, C12, C13, C14, C15, C16, C22, C23, ... C66], rows of the upper triangle, "
                  "order xx, yy, zz, yz, xz, xy");
  Six c{};
  std::size_t next = 0;
  for (std::size_t i = 0; i < 6; ++i)
    for (std::size_t j = i; j < 6; ++j) c[i][j] = c[j][i] = given[next++];
  const int minor = failing_minor(c);
  if (minor != 0)
    throw s.error("constants",
                  fmt::format("a strain would give energy: the leading minor of order {} of the "
                              "stiffness is not positive",
                              minor),
                  "a stiffness must be positive definite; see that the order is xx, yy, zz, yz, "
                  "xz, xy");
  if (dimension == 2)
    for (const std::size_t i : {0u, 1u, 2u, 5u})
      for (const std::size_t j : {3u, 4u})
        if (c[i][j] != 0)
          throw s.error("constants",
                        fmt::format("C{}{} would shear the plane out of itself", i + 1, j + 1),
                        "in the plane C14, C15, C24, C25, C34, C35, C46 and C56 must be 0");
  return c;
}

/// rho c^2 of the fastest wave along n: largest eigenvalue of n_j C_ijkl n_l.
double fastest_along(const Six& c, const Vec<3>& n, int dimension) {
  constexpr std::size_t kVoigt[3][3] = {{0, 5, 4}, {5, 1, 3}, {4, 3, 2}};
  Sym<3> acoustic = Sym<3>::zero();
  for (int i = 0; i < dimension; ++i)
    for (int k = i; k < dimension; ++k)
      for (int j = 0; j < 3; ++j)
        for (int l = 0; l < 3; ++l) acoustic(i, k) += c[kVoigt[i][j]][kVoigt[k][l]] * n[j] * n[l];
  const Principal<3> p = principal_of(acoustic);
  return std::max({p.value[0], p.value[1], p.value[2]});
}

}  // namespace

void declare_anisotropy(Schema& schema) {
  auto o =
      schema.section("material.*.orthotropic").doc("Elasticity with three planes of symmetry.");
  o.numbers("young", unit::pressure)
      .above(0)
      .required()
      .doc("Young's moduli along the three material axes.")
      .example("[\"60 GPa\", \"45 GPa\", \"50 GPa\"]");
  o.numbers("poisson", unit::none)
      .required()
      .doc("Ratios 12, 13, 23: contraction along the second axis by a load along the first.")
      .example("[0.25, 0.2, 0.22]");
  o.numbers("shear", unit::pressure)
      .above(0)
      .required()
      .doc("Shear moduli 12, 13, 23.")
      .example("[\"20 GPa\", \"18 GPa\", \"19 GPa\"]");
  auto t = schema.section("material.*.transversely_isotropic")
               .doc(
                   "Layered rock: alike in all directions across one axis, which is y in the "
                   "plane and z in space until [[axes]] turn it.");
  t.number("young", unit::pressure).above(0).required().doc("Along the layers.").example("40 GPa");
  t.number("young_axis", unit::pressure)
      .above(0)
      .required()
      .doc("Along the axis, across the layers.")
      .example("25 GPa");
  t.number("poisson", unit::none)
      .above(-1)
      .below(1)
      .required()
      .doc("Contraction along the layers by a load along them.")
      .example("0.2");
  t.number("poisson_axis", unit::none)
      .required()
      .doc("Contraction along the layers by a load along the axis.")
      .example("0.15");
  t.number("shear_axis", unit::pressure)
      .above(0)
      .required()
      .doc("Shear modulus of planes that hold the axis.")
      .example("12 GPa");
  schema.section("material.*.stiffness")
      .doc("Elasticity of any symmetry.")
      .numbers("constants", unit::pressure)
      .required()
      .doc(
          "C11, C12, ... C16, C22, ... C66: the upper triangle row by row, in the order xx, yy, "
          "zz, yz, xz, xy, for doubled shears.")
      .example(
          "[31e9, 4e9, 14e9, 0, 0, 0, 22e9, 4e9, 0, 0, 0, 31e9, 0, 0, 0, 6e9, 0, 0, 9e9, 0, 6e9]");
}

std::optional<Anisotropic> read_anisotropy(const Settings& material, int dimension) {
  if (material.has("orthotropic")) return law_of(read_orthotropic(material.at("orthotropic")));
  if (material.has("transversely_isotropic"))
    return law_of(read_transverse(material.at("transversely_isotropic"), dimension));
  if (material.has("stiffness")) return law_of(read_stiffness(material.at("stiffness"), dimension));
  return std::nullopt;
}

Anisotropic plane_stress_of(const Anisotropic& law) {
  Six c = engineering(law);
  Six reduced = c;
  for (std::size_t i = 0; i < 6; ++i)
    for (std::size_t j = 0; j < 6; ++j) reduced[i][j] -= c[i][2] * c[2][j] / c[2][2];
  return law_of(reduced);
}

double fastest_modulus(const Anisotropic& law, int dimension) {
  const Six c = engineering(law);
  double most = 0;
  if (dimension == 2) {
    for (int i = 0; i < 720; ++i) {
      const double a = std::numbers::pi * i / 720;
      most = std::max(most, fastest_along(c, {{std::cos(a), std::sin(a), 0}}, 2));
    }
  } else {
    // Fibonacci's lattice on the half sphere: directions of equal area.
    constexpr int kDirections = 1000;
    for (int i = 0; i < kDirections; ++i) {
      const double z = (i + 0.5) / kDirections, r = std::sqrt(1 - z * z);
      const double a = std::numbers::pi * (1 + std::sqrt(5.0)) * i;
      most = std::max(most, fastest_along(c, {{r * std::cos(a), r * std::sin(a), z}}, 3));
    }
  }
  return 1.01 * most;
}

double mean_shear(const Anisotropic& law) {
  const Six c = engineering(law);
  return (c[0][0] + c[1][1] + c[2][2] - c[0][1] - c[0][2] - c[1][2]) / 15 +
         (c[3][3] + c[4][4] + c[5][5]) / 5;
}

Sym<3> strain_of(const Anisotropic& law, const Sym<3>& stress) {
  const Six s = inverse(engineering(law));
  Sym<3> strain = Sym<3>::zero();
  for (std::size_t i = 0; i < 6; ++i)
    for (std::size_t j = 0; j < 6; ++j) strain.s[i] += s[i][j] * stress.s[j] / (i < 3 ? 1 : 2);
  return strain;
}

}  // namespace breccia
