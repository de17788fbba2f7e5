// Scene keys of the inelastic laws; a new law is one function each to declare and to read, and
// one line in the table.
#include "step/material_laws.hpp"

namespace breccia {

namespace {

void declare_j2(SectionBuilder s) {
  s.number("yield", unit::pressure)
      .above(0)
      .required()
      .example("90 MPa")
      .doc("Yield stress in simple tension before any plastic strain.");
  s.number("hardening", unit::pressure)
      .at_least(0)
      .by_default(0.0)
      .example("292 MPa")
      .doc("Rise of the yield stress per plastic strain.");
}

PlasticLaw read_j2(const Settings& law, const MaterialBasis&) {
  J2 j2;
  j2.yield = law.number("yield");
  j2.hardening = law.number("hardening");
  return j2;
}

}  // namespace

const std::vector<PlasticKeys>& plastic_keys() {
  static const std::vector<PlasticKeys> list{
      {"j2", "Von Mises plasticity: metals.", declare_j2, read_j2},
  };
  return list;
}

}  // namespace breccia
