#include "harness/fracture_world.hpp"

namespace breccia {

std::string block_scene(int dimension, const std::string& pattern, const std::string& cells,
                        const std::string& size, const std::string& law, const std::string& rest) {
  const bool plane = dimension == 2;
  const std::string zero = plane ? "[0, 0]" : "[0, 0, 0]";
  const std::string far = plane ? "[1, 0]" : "[1, 0, 0]";
  const std::string one = plane ? "[1, 1]" : "[1, 1, 1]";
  const std::string shape = plane ? "rectangle" : "box";
  const std::string mesh = "{ generator = \"structured\", pattern = \"" + pattern + "\", cells = ";
  const std::string elastic = "density = 2650\nelastic = { young = 60e9, poisson = 0.25 }\n";
  return "title = \"test\"\nreference = \"none\"\nexpected = \"none\"\n"
         "[run]\nduration = 1\ndimension = " +
         std::to_string(dimension) +
         "\n[[body]]\nname = \"block\"\nmaterial = \"rock\"\nshape = { " + shape +
         " = { corner = " + zero + ", size = " + size + " } }\nmesh = " + mesh + cells +
         " }\n[[body]]\nname = \"spare\"\nmaterial = \"other\"\nshape = { " + shape +
         " = { corner = " + far + ", size = [1e-3, 1e-3" + (plane ? "" : ", 1e-3") +
         "] } }\nmesh = " + mesh + one + " }\n[material.rock]\n" + elastic + "[material.other]\n" +
         elastic + law + rest;
}

}  // namespace breccia
