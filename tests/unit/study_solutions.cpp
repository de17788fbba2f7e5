#include "core/error.hpp"
#include "harness/failures.hpp"
#include "study/solutions.hpp"

#include <cmath>
#include <numbers>
#include <set>

namespace breccia {
namespace {

using testing::HasSubstr;

struct Known {
  std::string name;
  std::vector<std::string> parameters;
  double value;  ///< worked out by hand, or as published
  double share;  ///< how exactly it is known
};

const std::vector<Known>& known_values() {
  static const std::vector<Known> all = {
      {"bar.stress", {"velocity = 2", "young = 1 GPa", "density = 1000"}, 2e6, 1e-12},
      {"bar.arrival", {"distance = 50 cm", "young = 1 GPa", "density = 1000"}, 5e-4, 1e-12},
      // plate impact on granite: 104.1 m/s, 41 MPa
      {"plate.free_surface",
       {"velocity = 91.5", "density_1 = 2700", "speed_1 = 6420", "density_2 = 2630",
        "speed_2 = 5000"},
       104.1,
       5e-4},
      {"spall.strength", {"density = 2630", "speed = 5 km/s", "pull_back = 6.2"}, 41e6, 1e-2},
      {"cantilever.deflection",
       {"force = 100 N", "length = 4", "height = 1", "thickness = 1", "young = 1 MPa",
        "poisson = 0"},
       0.02656,
       1e-12},
      {"cantilever.frequency",
       {"length = 2", "height = 0.1", "young = 210 GPa", "density = 7800"},
       20.955,
       5e-5},
      {"kirsch.stress_x", {"stress = 1 MPa", "radius = 1", "height = 1"}, 3e6, 1e-12},
      {"kirsch.stress_x", {"stress = 1 MPa", "radius = 1", "height = 2"}, 1.21875e6, 1e-12},
      {"ring.widening",
       {"pressure = 0.001", "inner = 1", "outer = 2", "young = 1000", "poisson = 0.3"},
       1.906667e-6,
       1e-6},
      {"brazilian.strength",
       {"force = 314.1592653589793 kN", "diameter = 50 mm", "thickness = 1 m"},
       4e6,
       1e-12},
      {"hertz.force",
       {"radius = 1", "depth = 0.1 mm", "young = 9.1 GPa", "poisson = 0.3"},
       6666.666667,
       1e-9},
      {"hertz.half_width",
       {"line_force = 100 kN/m", "radius = 0.1", "young = 1.82 GPa", "poisson = 0.3"},
       3.568248e-3,
       1e-6},
      {"restitution.damped", {"damping = 0"}, 1, 1e-12},
      {"restitution.damped", {"damping = 0.1"}, 0.7292, 1e-4},
      {"sliding.distance", {"velocity = 2", "friction = 0.5", "gravity = 9.81"}, 0.407747, 1e-6},
      {"rolling.speed", {"gravity = 9.81", "angle = 30 deg", "time = 1"}, 3.27, 1e-9},
      {"griffith.strength",
       {"young = 70 GPa", "energy = 100", "half_length = 10 mm", "half_width = 100 mm"},
       14.83e6,
       5e-4},
      // 362 pieces of a ring 50 mm long
      {"ring.fragment",
       {"rate = 1e5", "young = 275 GPa", "density = 2750", "strength = 300 MPa", "energy = 100"},
       0.05 / 362,
       2e-3},
  };
  return all;
}

TEST(StudySolutions, HaveTheValuesThatAreKnown) {
  for (const Known& known : known_values())
    EXPECT_NEAR(solve(known.name, known.parameters) / known.value, 1, known.share) << known.name;
}

TEST(StudySolutions, DurationOfAnImpactAsPublished) {
  // Johnson: 2.87 (m^2 / (R E^2 v))^(1/5) with the reduced mass, radius and modulus
  const double mass = 0.5 * 4.0 / 3 * std::numbers::pi * 1e-6 * 7800, modulus = 0.5 * 200e9 / 0.91;
  const double expected = 2.87 * std::pow(mass * mass / (0.005 * modulus * modulus * 2), 0.2);
  EXPECT_NEAR(solve("hertz.duration", {"radius = 10 mm", "density = 7800", "young = 200 GPa",
                                       "poisson = 0.3", "velocity = 2"}) /
                  expected,
              1, 1e-3);
}

TEST(StudySolutions, EnergyOfACantileverIsTheSlopeOfItsCompliance) {
  const auto with = [](const std::string& name, const std::string& crack) {
    return solve(name, {"force = 3 kN", "crack = " + crack, "height = 10 mm", "thickness = 20 mm",
                        "young = 70 GPa"});
  };
  const double slope = (with("dcb.opening", "0.06001") - with("dcb.opening", "0.05999")) / 2e-5;
  EXPECT_NEAR(with("dcb.energy", "0.06") / (3000 * slope / (2 * 0.02)), 1, 1e-6);
}

TEST(StudySolutions, EveryOneIsTestedAndExplained) {
  std::set<std::string> tested{"hertz.duration", "dcb.opening", "dcb.energy"};
  for (const Known& known : known_values()) tested.insert(known.name);
  std::set<std::string> names;
  for (const Solution& s : solutions()) {
    EXPECT_TRUE(names.insert(s.name).second) << s.name << " is there twice";
    EXPECT_TRUE(tested.contains(s.name)) << s.name;
    EXPECT_FALSE(s.doc.empty() || s.source.empty() || s.parameters.empty()) << s.name;
    EXPECT_THAT(solutions_text(), HasSubstr("| `" + s.name + "` |"));
  }
}

TEST(StudySolutions, RefuseWhatTheyCannotTake) {
  const auto cause = [](const std::string& name, const std::vector<std::string>& parameters) {
    try {
      solve(name, parameters);
    } catch (const Error& e) {
      return std::string(e.what());
    }
    return std::string("nothing");
  };
  EXPECT_THAT(cause("bar.stres", {}), HasSubstr("Did you mean 'bar.stress'?"));
  EXPECT_THAT(cause("bar.stress", {"velocty = 1"}), HasSubstr("Did you mean 'velocity'?"));
  EXPECT_THAT(cause("bar.stress", {"velocity = 1", "young = 1 GPa"}),
              HasSubstr("needs the parameter 'density'"));
  EXPECT_THAT(cause("bar.stress", {"velocity = 1 m"}), HasSubstr("a length; a velocity"));
  EXPECT_THAT(cause("bar.stress", {"velocity = 1", "young = -1", "density = 1"}),
              HasSubstr("no value for these parameters"));
}

}  // namespace
}  // namespace breccia
