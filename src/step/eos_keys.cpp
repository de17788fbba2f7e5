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

void declare_tillotson(SectionBuilder s) {
  s.number("a", unit::none).above(0).required().example("0.5").doc("Limit at high energy.");
  s.number("b", unit::none).at_least(0).required().example("1.63").doc("More at low energy.");
  s.number("bulk", unit::pressure).above(0).required().example("75.2 GPa").doc("A.");
  s.number("bulk2", unit::pressure)
      .at_least(0)
      .required()
      .example("65 GPa")
      .doc("B, of the square of compression.");
  s.number("alpha", unit::none)
      .between(0, 100)
      .by_default(5.0)
      .doc("How fast a vapour forgets that it was a solid.");
  s.number("beta", unit::none).between(0, 100).by_default(5.0).doc("How fast its cohesion goes.");
  s.number("energy", unit::specific_energy).above(0).required().example("5 MJ/kg").doc("e0.");
  s.number("energy_begin", unit::specific_energy)
      .above(0)
      .required()
      .example("3 MJ/kg")
      .doc("Energy at which vaporisation begins, e_iv.");
  s.number("energy_end", unit::specific_energy)
      .above(0)
      .required()
      .example("13.9 MJ/kg")
      .doc("Energy at which it is complete, e_cv.");
  add_spall(s);
}

void read_tillotson(const Settings& law, const MaterialBasis& basis, Eos& eos) {
  eos.kind = EosKind::tillotson;
  Tillotson& t = eos.tillotson;
  t.rho0 = basis.density;
  t.a = law.number("a");
  t.b = law.number("b");
  t.bulk = law.number("bulk");
  t.bulk2 = law.number("bulk2");
  t.alpha = law.number("alpha");
  t.beta = law.number("beta");
  t.e0 = law.number("energy");
  t.e_iv = law.number("energy_begin");
  t.e_cv = law.number("energy_end");
  t.spall = spall_of(law);
  if (t.e_cv <= t.e_iv) {
    throw law.error("energy_end", "is not above energy_begin",
                    "between the two the material is partly vapour");
  }
}

void declare_ideal_gas(SectionBuilder s) {
  s.number("gamma", unit::none)
      .above(1)
      .at_most(10)
      .required()
      .example("1.4")
      .doc("Ratio of specific heats.");
  s.number("pressure", unit::pressure).above(0).required().example("101 kPa").doc("At the start.");
}

void read_ideal_gas(const Settings& law, const MaterialBasis& basis, Eos& eos) {
  eos.kind = EosKind::ideal_gas;
  eos.ideal_gas.gamma = law.number("gamma");
  eos.energy0 = law.number("pressure") / ((eos.ideal_gas.gamma - 1) * basis.density);
}

void declare_jwl(SectionBuilder s) {
  s.number("a", unit::pressure).at_least(0).required().example("371.2 GPa").doc("A.");
  s.number("b", unit::pressure).at_least(0).required().example("3.231 GPa").doc("B.");
  s.number("r1", unit::none).above(0).at_most(50).required().example("4.15").doc("R1.");
  s.number("r2", unit::none).above(0).at_most(50).required().example("0.95").doc("R2.");
  s.number("omega", unit::none).above(0).at_most(2).required().example("0.3").doc("w.");
  s.number("energy", unit::pressure)
      .above(0)
      .required()
      .example("7 GPa")
      .doc("Energy per first volume of the explosive.");
}

void read_jwl(const Settings& law, const MaterialBasis& basis, Eos& eos) {
  eos.kind = EosKind::jwl;
  eos.jwl = {basis.density,    law.number("a"),  law.number("b"),
             law.number("r1"), law.number("r2"), law.number("omega")};
  eos.energy0 = law.number("energy") / basis.density;
}

}  // namespace

const std::vector<EosKeys>& eos_keys() {
  static const std::vector<EosKeys> list{
      {"linear", "Pressure proportional to compression.", declare_linear, read_linear},
      {"mie_gruneisen", "Mie and Grueneisen: solids and liquids under shock.",
       declare_mie_gruneisen, read_mie_gruneisen},
      {"tillotson", "Tillotson: impacts, from compressed solid to vapour.", declare_tillotson,
       read_tillotson},
      {"ideal_gas", "Ideal gas.", declare_ideal_gas, read_ideal_gas},
      {"jwl", "Jones, Wilkins and Lee: the gases of an explosive, detonated at the start.",
       declare_jwl, read_jwl},
  };
  return list;
}

void declare_pores(SectionBuilder s) {
  s.number("distension", unit::none)
      .above(1)
      .at_most(10)
      .required()
      .example("1.25")
      .doc("Density of the solid over that of the porous material at rest, alpha0.");
  s.number("begin", unit::pressure)
      .at_least(0)
      .required()
      .example("20 MPa")
      .doc("Pressure at which pores begin to close.");
  s.number("end", unit::pressure)
      .above(0)
      .required()
      .example("1.5 GPa")
      .doc("Pressure at which none is left.");
}

Pores read_pores(const Settings& section) {
  const Pores pores{section.number("distension"), section.number("begin"), section.number("end")};
  if (pores.end <= pores.begin) {
    throw section.error("end", "is not above `begin`", "pores close between the two pressures");
  }
  return pores;
}

}  // namespace breccia
