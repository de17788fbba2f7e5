// Scene keys of the laws of rock and soil: Drucker-Prager, Mohr-Coulomb.
#include "core/text.hpp"
#include "step/material_laws.hpp"

#include <cmath>

namespace breccia {

namespace {

void add_rock_keys(SectionBuilder s) {
  s.number("cohesion", unit::pressure)
      .at_least(0)
      .required()
      .example("20 MPa")
      .doc("Shear strength without pressure.");
  s.number("friction_angle", unit::angle)
      .at_least(0)
      .below(1.5)
      .required()
      .example("40 deg")
      .doc("Pressure raises shear strength by the tangent of this angle.");
  s.number("dilation_angle", unit::angle)
      .at_least(0)
      .below(1.5)
      .by_default(0.0)
      .example("10 deg")
      .doc("How much the material swells as it shears; not above friction_angle.");
  s.number("tension_cutoff", unit::pressure)
      .at_least(0)
      .example("5 MPa")
      .doc("Largest tension; that of the tip of the cone or pyramid if absent.");
  s.number("residual_cohesion", unit::pressure)
      .at_least(0)
      .example("2 MPa")
      .doc("Cohesion after residual_strain, along a line; it stays as it is if absent.");
  s.number("residual_strain", unit::none)
      .above(0)
      .at_most(100)
      .example("0.02")
      .doc("Plastic strain at which residual_cohesion is reached.");
  s.number("rate_reference", unit::frequency)
      .above(0)
      .example("10 1/s")
      .doc("Rate of strain above which cohesion and tension cut-off rise; they do not if absent.");
  s.number("rate_exponent", unit::none)
      .above(0)
      .at_most(1)
      .by_default(0.3)
      .doc("Power of the rate over rate_reference that they rise with.");
  s.number("rate_filter", unit::time)
      .above(0)
      .example("1 us")
      .doc("Time over which the rate is averaged; twenty steps if absent.");
}

void check_angles(const Settings& law) {
  if (law.number("dilation_angle") <= law.number("friction_angle")) return;
  throw law.error("dilation_angle", "is above friction_angle",
                  "such a material would give energy away as it flows");
}

Cohesion read_cohesion(const Settings& law) {
  const bool end = law.has("residual_cohesion"), strain = law.has("residual_strain");
  if (end != strain) {
    throw law.error(end ? "residual_cohesion" : "residual_strain",
                    "residual_cohesion and residual_strain belong together", "give both or none");
  }
  Cohesion c;
  c.first = law.number("cohesion");
  c.last = end ? law.number("residual_cohesion") : c.first;
  c.strain = end ? law.number("residual_strain") : 0;
  return c;
}

/// The cut-off must lie below the tip of the cone or pyramid.
double read_cut_off(const Settings& law, double tip) {
  const auto given = law.maybe_number("tension_cutoff");
  if (!given) return tip;
  if (*given >= tip) {
    throw law.error("tension_cutoff",
                    "cohesion and friction let go at " + number_text(tip) +
                        " Pa of tension in all directions; the cut-off would never be reached",
                    "take a smaller tension_cutoff, or leave it out");
  }
  return *given;
}

template <class Law>
PlasticLaw with_rate(const Law& law, const Settings& settings) {
  if (!settings.has("rate_reference")) return law;
  RateDependent<Law> faster;
  static_cast<Law&>(faster) = law;
  faster.rate_reference = settings.number("rate_reference");
  faster.rate_exponent = settings.number("rate_exponent");
  faster.filter_time = settings.maybe_number("rate_filter").value_or(0);
  return faster;
}

constexpr double kNoLimit = 1e300;

void declare_drucker_prager(SectionBuilder s) {
  add_rock_keys(s);
  s.choice("fit", {"compression", "extension", "plane_strain"})
      .by_default("compression")
      .doc(
          "Where the cone has the strength of cohesion and friction_angle: triaxial compression, "
          "triaxial extension, or failure in plane strain.");
}

PlasticLaw read_drucker_prager(const Settings& law, const MaterialBasis& basis) {
  using Fit = DruckerPrager::Fit;
  check_angles(law);
  const std::string& word = law.text("fit");
  const Fit fit = word == "compression" ? Fit::compression
                  : word == "extension" ? Fit::extension
                                        : Fit::plane_strain;
  DruckerPrager dp =
      DruckerPrager::fitted(fit, law.number("friction_angle"), law.number("dilation_angle"));
  dp.cohesion = read_cohesion(law);
  const double b = dp.per_cohesion * dp.cohesion.first;
  dp.cut_off = read_cut_off(law, dp.friction > 0 ? b / dp.friction : kNoLimit);
  const double stiff = basis.shear + basis.bulk * dp.friction * dp.dilation;
  const double slope = dp.per_cohesion * dp.cohesion.slope(0) * dp.strain_per_step();
  if (slope < 0 && stiff + slope <= 0) {
    throw law.error("residual_strain", "cohesion falls faster than the elastic stress can",
                    "take a larger residual_strain");
  }
  return with_rate(dp, law);
}

PlasticLaw read_mohr_coulomb(const Settings& law, const MaterialBasis& basis) {
  check_angles(law);
  const double phi = law.number("friction_angle");
  MohrCoulomb mc;
  mc.sin_phi = std::sin(phi);
  mc.cos_phi = std::cos(phi);
  mc.sin_psi = std::sin(law.number("dilation_angle"));
  mc.cohesion = read_cohesion(law);
  mc.cut_off = read_cut_off(law, phi > 0 ? mc.cohesion.first * mc.cos_phi / mc.sin_phi : kNoLimit);
  if (mc.cohesion.strain > 0 && mc.cohesion.slope(0) < -basis.shear) {
    throw law.error("residual_strain", "cohesion falls faster than the elastic stress can",
                    "take a larger residual_strain");
  }
  return with_rate(mc, law);
}

}  // namespace

PlasticKeys drucker_prager_keys() {
  return {"drucker_prager", "Drucker and Prager's cone: rock, concrete, soil.",
          declare_drucker_prager, read_drucker_prager};
}

PlasticKeys mohr_coulomb_keys() {
  return {"mohr_coulomb", "Mohr and Coulomb's pyramid with Rankine's cut-off: rock, soil.",
          add_rock_keys, read_mohr_coulomb};
}

}  // namespace breccia
