// Scene keys of the equations of state.
#include "step/material_laws.hpp"

namespace breccia {

namespace {

void add_gruneisen(SectionBuilder s) {
  s.number("gruneisen", unit::none)
      .between(0, 10)
      .by_default(0.0)
      .example("1.99")
      .doc("Pressure per energy density at constant volume.");
}

void add_spall(SectionBuilder s) {
  s.number("spall", unit::pressure)
      .above(0)
      .example("1.2 GPa")
      .doc("Largest tension that the material bears as a whole; without end if absent.");
}

double spall_of(const Settings& law) {
  return law.maybe_number("spall").value_or(1e300);
}

void declare_linear(SectionBuilder s) {
  s.number("bulk", unit::pressure)
      .above(0)
      .example("40 GPa")
      .doc("Bulk modulus; that of the elastic constants if absent.");
  add_gruneisen(s);
  add_spall(s);
}

void read_linear(const Settings& law, const MaterialBasis& basis, Eos& eos) {
  eos.kind = EosKind::linear;
  eos.linear = {basis.density, law.maybe_number("bulk").value_or(basis.bulk),
                law.number("gruneisen"), spall_of(law)};
}

void declare_mie_gruneisen(SectionBuilder s) {
  s.number("c0", unit::velocity)
      .above(0)
      .required()
      .example("3940 m/s")
      .doc("Shock velocity of the weakest shock.");
  s.number("s", unit::none)
      .between(0, 5)
      .required()
      .example("1.489")
      .doc("Rise of the shock velocity per particle velocity.");
  add_gruneisen(s);
  add_spall(s);
}

void read_mie_gruneisen(const Settings& law, const MaterialBasis& basis, Eos& eos) {
  eos.kind = EosKind::mie_gruneisen;
  eos.mie_gruneisen = {basis.density, law.number("c0"), law.number("s"), law.number("gruneisen"),
                       spall_of(law)};
}

}  // namespace

const std::vector<EosKeys>& eos_keys() {
  static const std::vector<EosKeys> list{
      {"linear", "Pressure proportional to compression.", declare_linear, read_linear},
      {"mie_gruneisen", "Mie and Grueneisen: solids and liquids under shock.",
       declare_mie_gruneisen, read_mie_gruneisen},
  };
  return list;
}

}  // namespace breccia
