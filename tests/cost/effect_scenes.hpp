#pragma once
#include "harness/scenes.hpp"

#include <string>
#include <vector>

namespace breccia {

/// How a scene of one block "b" of material "m", [0, 1] in each direction, names an effect.
struct EffectCase {
  std::string name;      ///< of the effect
  std::string section;   ///< what the scene says
  bool tasks = true;     ///< whether it works in a step
  bool launches = true;  ///< whether it launches kernels of its own
  bool memory = true;    ///< whether it has memory of its own
};

inline std::vector<EffectCase> effect_cases(int dimension) {
  const bool plane = dimension == 2;
  const std::string zero = plane ? "[0, 0]" : "[0, 0, 0]";
  const std::string in = plane ? "[0.4, 0.4]" : "[0.4, 0.4, 0.4]";
  const std::string rigid_shape =
      plane ? "shape = { rectangle = { corner = [0, 2], size = [1, 1] } }\n"
              "mesh = { generator = \"structured\", cells = [2, 2] }\n"
            : "shape = { box = { corner = [0, 2, 0], size = [1, 1, 1] } }\n"
              "mesh = { generator = \"structured\", cells = [2, 2, 2] }\n";
  return {{"gravity",
           plane ? "[gravity]\nacceleration = [0, -9.81]\n"
                 : "[gravity]\nacceleration = [0, -9.81, 0]\n",
           false, false, false},
          {"boundary", "[[boundary]]\nwhere = \"b.left\"\nfixed = " + zero +
                           "\n[[boundary]]\nwhere = \"b.right\"\npressure = \"1 kPa\"\n"},
          {"fracture",
           "[fracture.m]\ntensile_strength = \"10 MPa\"\ncohesion = \"20 MPa\"\n"
           "friction_angle = \"40 deg\"\nenergy_tension = \"10 kJ/m2\"\n"
           "energy_shear = \"30 kJ/m2\"\nalpha = 1\n"},
          {"contact", "[contact]\nfriction = 0.3\n"},
          {"sensor", "[[sensor]]\nname = \"s\"\npoint = " + in + "\n", false},
          // Complete before a step is looked at: while it lasts, each step asks for an energy.
          {"excavation", "[[excavate]]\nbox = { lower = " + zero + ", upper = " +
                             (plane ? "[0.3, 0.3]" : "[0.3, 0.3, 0.3]") + " }\nrelease = 1e-3\n"},
          {"rigid", "[[body]]\nname = \"r\"\nmaterial = \"m\"\nrigid = true\n" + rigid_shape},
          {"rest", "[run.rest]\nafter = 0.5\n"}};
}

/// What a material may do within the effect "solid", and the field that only it needs.
struct PartCase {
  std::string name, material, field;
};
inline const std::vector<PartCase> kPartCases = {
    {"damping", "damping = 0.02", ""},
    {"bulk viscosity", "bulk_viscosity = [1.5, 0.06]", "element_modulus"},
    {"yielding", "j2 = { yield = \"100 MPa\" }", "element_history"}};

inline BlockScene cost_block(int dimension, const std::string& sections) {
  BlockScene scene;
  scene.dimension = dimension;
  scene.size = dimension == 2 ? "[1, 1]" : "[1, 1, 1]";
  scene.cells = dimension == 2 ? "[4, 4]" : "[4, 4, 4]";
  scene.more = sections;
  return scene;
}

/// About 20 000 elements (10 000 tetrahedra) that turn, a little.
inline BlockScene turning_block(int dimension, const std::string& sections) {
  BlockScene scene = cost_block(dimension, sections);
  scene.cells = dimension == 2 ? "[70, 70]" : "[12, 12, 12]";
  scene.jitter = 0.1;
  scene.body = dimension == 2 ? "spin = 1.0" : "spin = [0, 0, 1.0]";
  return scene;
}

}  // namespace breccia
