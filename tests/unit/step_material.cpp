#include "harness/failures.hpp"
#include "io/scene_reader.hpp"
#include "scene/commands.hpp"
#include "step/material.hpp"
#include "step/material_laws.hpp"

#include <gtest/gtest.h>

namespace breccia {
namespace {

/// The material that a scene makes of these keys.
Material material(const std::string& keys) {
  const std::string text =
      "title = \"x\"\n[run]\ndimension = 2\nduration = 1\n[[body]]\nname = \"b\"\nmaterial = "
      "\"m\"\n"
      "shape.rectangle = { corner = [0, 0], size = [1, 1] }\nmesh = { size = 1 }\n"
      "[material.m]\ndensity = 2000\nelastic = { young = \"60 GPa\", poisson = 0.25 }\n" +
      keys + "\n";
  Schema schema;
  declare_schema(schema);
  return read_materials(schema.resolve(read_scene_text(text, "s.toml"))).at(0);
}

TEST(MaterialLaws, ElasticUnlessSaidOtherwise) {
  const Material m = material("");
  EXPECT_FALSE(m.yields());
  EXPECT_FALSE(m.eos);
  EXPECT_FALSE(m.viscosity.on());
  EXPECT_DOUBLE_EQ(std::get<NoYield>(m.plastic).bulk, 40e9);
  EXPECT_DOUBLE_EQ(std::get<NoYield>(m.plastic).shear, 24e9);
}

TEST(MaterialLaws, MetalsWithTheirSimplestLaw) {
  const Material line = material("j2 = { yield = \"90 MPa\", hardening = \"1 GPa\" }");
  const J2& j2 = std::get<J2>(line.plastic);
  EXPECT_DOUBLE_EQ(j2.bulk, 40e9);
  EXPECT_DOUBLE_EQ(j2.yield, 90e6);
  EXPECT_DOUBLE_EQ(j2.hardening, 1e9);
  const Material fast = material("j2 = { yield = 1, rate_reference = \"100 1/s\" }");
  EXPECT_EQ(std::get<JohnsonCook>(fast.plastic).rate_law, RateFactor::perzyna);
  const Material hot = material(
      "johnson_cook = { yield = 1, melting = \"1300 K\", room = \"300 K\", start = \"500 K\", "
      "heat_capacity = \"400 J/(kg.K)\", heat_share = 0.8 }");
  const JohnsonCook& jc = std::get<JohnsonCook>(hot.plastic);
  EXPECT_DOUBLE_EQ(jc.melting, 1000);
  EXPECT_DOUBLE_EQ(jc.start, 200);
  EXPECT_DOUBLE_EQ(jc.heat, 0.8 / (2000 * 400.0));
  EXPECT_EQ(jc.exponent, 1);
}

TEST(MaterialLaws, RockWithAnglesInDegrees) {
  const std::string keys = "cohesion = \"20 MPa\", friction_angle = \"30 deg\"";
  const Material m = material("mohr_coulomb = { " + keys + ", tension_cutoff = \"5 MPa\" }");
  const MohrCoulomb& mc = std::get<MohrCoulomb>(m.plastic);
  EXPECT_NEAR(mc.sin_phi, 0.5, 1e-15);
  EXPECT_EQ(mc.cut_off, 5e6);
  EXPECT_EQ(tension_of_bulk(m.plastic), 5e6);
  const Material cone = material("drucker_prager = { " + keys + ", fit = \"extension\" }");
  const DruckerPrager& dp = std::get<DruckerPrager>(cone.plastic);
  EXPECT_NEAR(dp.friction, 6 * 0.5 / (std::sqrt(3.0) * 3.5), 1e-14);
  EXPECT_NEAR(dp.cut_off, 20e6 * std::sqrt(3.0), 1);  // c cot(phi)
  const Material rate = material("mohr_coulomb = { " + keys + ", rate_reference = 10 }");
  EXPECT_EQ(std::get<RateDependent<MohrCoulomb>>(rate.plastic).rate_reference, 10);
  EXPECT_FALSE(tension_of_bulk(PlasticLaw(J2{})));
}

TEST(MaterialLaws, EquationsOfState) {
  const Material metal = material("eos.mie_gruneisen = { c0 = 4000, s = 1.5, gruneisen = 2 }");
  EXPECT_EQ(metal.eos->kind, EosKind::mie_gruneisen);
  EXPECT_DOUBLE_EQ(metal.eos->modulus0, 2000 * 16e6);
  EXPECT_EQ(metal.viscosity.quadratic, 1.5);
  EXPECT_EQ(metal.viscosity.linear, 0.06);
  const Material gas =
      material("bulk_viscosity = [2, 0]\neos.ideal_gas = { gamma = 1.5, pressure = \"1 bar\" }");
  EXPECT_DOUBLE_EQ(gas.eos->start().p, 1e5);
  EXPECT_EQ(gas.viscosity.quadratic, 2);
  EXPECT_DOUBLE_EQ(material("eos.linear = {}").eos->linear.bulk, 40e9);
  const Material porous = material(
      "eos.linear = { bulk = 1e9 }\neos.pores = { distension = 1.25, begin = 1e6, end = 1e8 }");
  EXPECT_DOUBLE_EQ(porous.eos->rho0, 2000);
  EXPECT_DOUBLE_EQ(porous.eos->linear.rho0, 2500);
  EXPECT_DOUBLE_EQ(porous.eos->modulus0, 1e9 / 1.25);
  EXPECT_NEAR(porous.eos->start().p, 0, 1e-3);
}

}  // namespace
}  // namespace breccia
