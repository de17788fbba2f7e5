// Closed forms that studies name as their reference.
#include "study/solutions.hpp"

#include <cmath>
#include <numbers>

namespace breccia {

namespace {

using std::pow;
using std::sqrt;
using std::numbers::pi;
using P = std::span<const double>;

std::vector<Solution> waves() {
  return {
      {"bar.stress",
       unit::pressure,
       "stress of the wave that a velocity v starts in a thin bar: v sqrt(E rho)",
       "Kolsky, Stress Waves in Solids (1953)",
       {{"velocity", unit::velocity, "v"},
        {"young", unit::pressure, "E"},
        {"density", unit::density, "rho"}},
       [](P p) { return p[0] * sqrt(p[1] * p[2]); }},
      {"bar.arrival",
       unit::time,
       "time of a wave over a distance x in a thin bar: x sqrt(rho / E)",
       "Kolsky, Stress Waves in Solids (1953)",
       {{"distance", unit::length, "x"},
        {"young", unit::pressure, "E"},
        {"density", unit::density, "rho"}},
       [](P p) { return p[0] * sqrt(p[2] / p[1]); }},
      {"plate.free_surface",
       unit::velocity,
       "velocity of the free face behind an impact of elastic plates: 2 v Z1 / (Z1 + Z2), Z = rho "
       "c of flyer and target",
       "Meyers, Dynamic Behavior of Materials (1994)",
       {{"velocity", unit::velocity, "v of the flyer"},
        {"density_1", unit::density, "of the flyer"},
        {"speed_1", unit::velocity, "c of the flyer"},
        {"density_2", unit::density, "of the target"},
        {"speed_2", unit::velocity, "c of the target"}},
       [](P p) { return 2 * p[0] * p[1] * p[2] / (p[1] * p[2] + p[3] * p[4]); }},
      {"spall.strength",
       unit::pressure,
       "tension that a pull-back du of the free face tells: rho c du / 2",
       "Antoun et al., Spall Fracture (2003)",
       {{"density", unit::density, "rho"},
        {"speed", unit::velocity, "c"},
        {"pull_back", unit::velocity, "du"}},
       [](P p) { return 0.5 * p[0] * p[1] * p[2]; }},
  };
}

std::vector<Solution> beams() {
  return {
      {"cantilever.deflection",
       unit::length,
       "end of a beam of length L, height h and thickness b under a force F: F L^3 / (3 E I) + 12 "
       "(1 + nu) F L / (5 E b h)",
       "Timoshenko, Phil. Mag. 41 (1921) 744",
       {{"force", unit::force, "F"},
        {"length", unit::length, "L"},
        {"height", unit::length, "h"},
        {"thickness", unit::length, "b"},
        {"young", unit::pressure, "E"},
        {"poisson", unit::none, "nu"}},
       [](P p) {
         const double bend = 4 * p[0] * pow(p[1] / p[2], 3) / (p[4] * p[3]);
         return bend + 12 * (1 + p[5]) * p[0] * p[1] / (5 * p[4] * p[3] * p[2]);
       }},
      {"cantilever.frequency",
       unit::frequency,
       "first frequency of a beam of length L and height h: 1.8751^2 h / (2 pi L^2) sqrt(E / (12 "
       "rho))",
       "Euler and Bernoulli",
       {{"length", unit::length, "L"},
        {"height", unit::length, "h"},
        {"young", unit::pressure, "E"},
        {"density", unit::density, "rho"}},
       [](P p) {
         return pow(1.875104068711961, 2) / (2 * pi * p[0] * p[0]) * p[1] *
                sqrt(p[2] / (12 * p[3]));
       }},
  };
}

std::vector<Solution> rounds() {
  return {
      {"kirsch.stress_x",
       unit::pressure,
       "stress along x above a hole of radius a under a far stress S along x, at a height y: S (2 "
       "+ a^2/y^2 + 3 a^4/y^4) / 2",
       "Kirsch, Z. VDI 42 (1898) 797",
       {{"stress", unit::pressure, "S"},
        {"radius", unit::length, "a"},
        {"height", unit::length, "y from the centre"}},
       [](P p) {
         const double q = pow(p[1] / p[2], 2);
         return 0.5 * p[0] * (2 + q + 3 * q * q);
       }},
      {"ring.widening",
       unit::length,
       "growth of the inner radius a of a ring with outer radius b under a pressure p inside, "
       "plane strain: "
       "p a (1 + nu) / E ((1 - 2 nu) a^2 + b^2) / (b^2 - a^2)",
       "Lame (1852)",
       {{"pressure", unit::pressure, "p"},
        {"inner", unit::length, "a"},
        {"outer", unit::length, "b"},
        {"young", unit::pressure, "E"},
        {"poisson", unit::none, "nu"}},
       [](P p) {
         const double a = p[1] * p[1], b = p[2] * p[2];
         return p[0] * p[1] * (1 + p[4]) / p[3] * ((1 - 2 * p[4]) * a + b) / (b - a);
       }},
      {"brazilian.strength",
       unit::pressure,
       "tensile strength that a disc tells: 2 F / (pi D t)",
       "ISRM suggested method (1978)",
       {{"force", unit::force, "F at the peak"},
        {"diameter", unit::length, "D"},
        {"thickness", unit::length, "t"}},
       [](P p) { return 2 * p[0] / (pi * p[1] * p[2]); }},
  };
}

std::vector<Solution> contacts() {
  return {
      {"hertz.force",
       unit::force,
       "force between a ball of radius R and a plane pressed together by d: 4/3 E* sqrt(R) d^1.5, "
       "E* = E / (2 (1 - nu^2)) for equal materials",
       "Hertz, J. reine angew. Math. 92 (1881) 156",
       {{"radius", unit::length, "R"},
        {"depth", unit::length, "d"},
        {"young", unit::pressure, "E"},
        {"poisson", unit::none, "nu"}},
       [](P p) { return 2.0 / 3.0 * p[2] / (1 - p[3] * p[3]) * sqrt(p[0]) * pow(p[1], 1.5); }},
      {"hertz.duration",
       unit::time,
       "time that two equal balls of radius R and mass m touch when they meet with v: 2.943 (15 m* "
       "/ (16 E* sqrt(R*)))^(2/5) v^(-1/5), "
       "m* = m / 2, R* = R / 2, E* = E / (2 (1 - nu^2))",
       "Johnson, Contact Mechanics (1985), section 11.4",
       {{"radius", unit::length, "R"},
        {"density", unit::density, "of the balls"},
        {"young", unit::pressure, "E"},
        {"poisson", unit::none, "nu"},
        {"velocity", unit::velocity, "v, of one towards the other"}},
       [](P p) {
         const double mass = 2.0 / 3.0 * pi * pow(p[0], 3) * p[1];
         const double modulus = 0.5 * p[2] / (1 - p[3] * p[3]);
         return 2.9432750716 * pow(15 * mass / (16 * modulus * sqrt(0.5 * p[0])), 0.4) *
                pow(p[4], -0.2);
       }},
      {"hertz.half_width",
       unit::length,
       "half the width of the contact of a cylinder of radius R and a plane under a force q per "
       "length: sqrt(4 q R / (pi E*)), "
       "E* = E / (2 (1 - nu^2)) for equal materials",
       "Johnson, Contact Mechanics (1985), section 4.2",
       {{"line_force", unit::surface_energy, "q"},
        {"radius", unit::length, "R"},
        {"young", unit::pressure, "E"},
        {"poisson", unit::none, "nu"}},
       [](P p) { return sqrt(8 * p[0] * p[1] * (1 - p[3] * p[3]) / (pi * p[2])); }},
  };
}

std::vector<Solution> motions() {
  return {
      {"restitution.damped",
       unit::none,
       "restitution of a contact of a spring and a damper with the share z of critical damping: "
       "exp(-pi z / sqrt(1 - z^2))",
       "Schaefer, Dippel and Wolf, J. Phys. I 6 (1996) 5",
       {{"damping", unit::none, "z"}},
       [](P p) { return std::exp(-pi * p[0] / sqrt(1 - p[0] * p[0])); }},
      {"sliding.distance",
       unit::length,
       "way of a block that friction stops: v^2 / (2 mu g)",
       "Coulomb (1785)",
       {{"velocity", unit::velocity, "v"},
        {"friction", unit::none, "mu"},
        {"gravity", unit::acceleration, "g"}},
       [](P p) { return p[0] * p[0] / (2 * p[1] * p[2]); }},
      {"rolling.speed",
       unit::velocity,
       "speed of a disc that rolls down a slope after a time t: 2/3 g sin(angle) t",
       "rigid disc, rolling without sliding",
       {{"gravity", unit::acceleration, "g"},
        {"angle", unit::angle, "of the slope"},
        {"time", unit::time, "t"}},
       [](P p) { return 2.0 / 3.0 * p[0] * std::sin(p[1]) * p[2]; }},
  };
}

std::vector<Solution> cracks() {
  return {
      {"griffith.strength",
       unit::pressure,
       "far stress at which a crack of half length a runs in a plate of half width w, plane "
       "stress: "
       "sqrt(E G / (pi a)) sqrt(cos(pi a / (2 w)))",
       "Griffith, Phil. Trans. R. Soc. A 221 (1921) 163; Feddersen, ASTM STP 410 (1966) 77",
       {{"young", unit::pressure, "E"},
        {"energy", unit::surface_energy, "G"},
        {"half_length", unit::length, "a"},
        {"half_width", unit::length, "w"}},
       [](P p) {
         return sqrt(p[0] * p[1] / (pi * p[2])) * sqrt(std::cos(pi * p[2] / (2 * p[3])));
       }},
      {"dcb.opening",
       unit::length,
       "opening of a double cantilever with arms of height h under a force F, crack of length a: 8 "
       "F (a + 0.64 h)^3 / (E b h^3)",
       "Blackman et al., J. Mater. Sci. Lett. 10 (1991) 253",
       {{"force", unit::force, "F"},
        {"crack", unit::length, "a"},
        {"height", unit::length, "h"},
        {"thickness", unit::length, "b"},
        {"young", unit::pressure, "E"}},
       [](P p) { return 8 * p[0] * pow((p[1] + 0.64 * p[2]) / p[2], 3) / (p[4] * p[3]); }},
      {"dcb.energy",
       unit::surface_energy,
       "energy release rate of a double cantilever under a force F: 12 F^2 (a + 0.64 h)^2 / (E b^2 "
       "h^3)",
       "Blackman et al., J. Mater. Sci. Lett. 10 (1991) 253",
       {{"force", unit::force, "F"},
        {"crack", unit::length, "a"},
        {"height", unit::length, "h"},
        {"thickness", unit::length, "b"},
        {"young", unit::pressure, "E"}},
       [](P p) { return 12 * pow(p[0] * (p[1] + 0.64 * p[2]) / p[3], 2) / (p[4] * pow(p[2], 3)); }},
      {"ring.fragment",
       unit::length,
       "mean length of the pieces of a ring that is stretched at the rate r: 4.5 s0 / (1 + 4.5 (r "
       "/ r0)^(2/3)), "
       "s0 = E G / s^2, r0 = c s^3 / (E^2 G), c = sqrt(E / rho)",
       "Zhou, Molinari and Ramesh, Appl. Phys. Lett. 88 (2006) 261918",
       {{"rate", unit::frequency, "r"},
        {"young", unit::pressure, "E"},
        {"density", unit::density, "rho"},
        {"strength", unit::pressure, "s"},
        {"energy", unit::surface_energy, "G"}},
       [](P p) {
         const double length = p[1] * p[4] / (p[3] * p[3]);
         const double rate = sqrt(p[1] / p[2]) * pow(p[3], 3) / (p[1] * p[1] * p[4]);
         return 4.5 * length / (1 + 4.5 * pow(p[0] / rate, 2.0 / 3.0));
       }},
  };
}

}  // namespace

const std::vector<Solution>& solutions() {
  static const std::vector<Solution> all = [] {
    std::vector<Solution> list;
    for (const auto& part : {waves(), beams(), rounds(), contacts(), motions(), cracks()})
      list.insert(list.end(), part.begin(), part.end());
    return list;
  }();
  return all;
}

}  // namespace breccia
