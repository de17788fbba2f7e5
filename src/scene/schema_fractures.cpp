// The keys of [[fractures]]: where fractures lie that are there before the start. Their laws are
// the fracture module's.
#include "core/text.hpp"
#include "scene/schema_rules.hpp"
#include "step/friction_keys.hpp"

namespace breccia {

namespace {

void declare_set(Schema& schema) {
  auto s = schema.section("fractures[].set").doc("Fractures at random places.");
  s.integer("number").at_least(1).at_most(1000000).doc("How many.").example("20");
  s.number("intensity", unit::none / unit::length)
      .above(0)
      .doc("Length per area (plane) or area per volume (space) inside the body.")
      .example("0.5 1/m");
  s.exactly_one_of({"number", "intensity"});
  s.number("shortest", unit::length).above(0).required().doc("Least length.").example("2 m");
  s.number("longest", unit::length)
      .above(0)
      .required()
      .doc("Greatest length; in space of the diameter of discs.")
      .example("4 m");
  s.choice("lengths", {"uniform", "power_law"})
      .by_default("uniform")
      .doc("How often a length is found between these two.");
  s.number("exponent", unit::none)
      .between(0, 10)
      .by_default(2.5)
      .doc("power_law: the density of lengths falls with length to this power.");
  s.choice("orientation", {"parallel", "scattered", "uniform"})
      .by_default("parallel")
      .doc(
          "All along the mean, scattered about it (von Mises in the plane, Fisher in space), or in "
          "all directions alike.");
  s.number("concentration", unit::none)
      .above(0)
      .at_most(1e4)
      .by_default(20.0)
      .doc("scattered: kappa; the angles are about 1/sqrt(kappa) rad.");
  s.number("dip", unit::angle)
      .only_in(2)
      .by_default("0 deg")
      .doc("Mean angle of the traces from the x axis.")
      .example("35 deg");
  s.vector("normal", unit::none).only_in(3).doc("Mean normal.").example("[0, 0, 1]");
  s.integer("seed").between(0, 2147483647).doc("Of this set; run.seed if absent.").example("3");
}

void declare_planes(Schema& schema) {
  auto s = schema.section("fractures[].planes").doc("Parallel layers through the whole body.");
  s.number("spacing", unit::length)
      .above(0)
      .required()
      .doc("From one to the next.")
      .example("3 mm");
  s.number("dip", unit::angle)
      .only_in(2)
      .by_default("0 deg")
      .doc("Angle of the traces from the x axis.")
      .example("30 deg");
  s.vector("normal", unit::none).only_in(3).doc("Their normal.").example("[0, 0, 1]");
  s.vector("through", unit::length).required().doc("A point of one of them.").example("[0, 0]");
}

void declare_grains(Schema& schema) {
  auto s = schema.section("fractures[].grains")
               .only_in(2)
               .doc("Boundaries of Voronoi grains that fill the body.");
  s.number("size", unit::length).above(0).required().doc("Across a grain.").example("3 mm");
  s.number("jitter", unit::none)
      .between(0, 0.45)
      .by_default(0.35)
      .doc("Random shift of their centres from a triangular lattice, in sizes; 0 gives hexagons.");
  s.integer("seed").between(0, 2147483647).doc("run.seed if absent.").example("3");
}

void check_stress_length(const Settings& s, int dimension, Problems& problems) {
  const std::size_t wanted = dimension == 2 ? 4 : 6;
  if (s.has("stress") && s.vector("stress").size() != wanted)
    problems.add(s.error("stress", std::to_string(s.vector("stress").size()) + " components",
                         dimension == 2 ? "[xx, yy, zz, xy]" : "[xx, yy, zz, xy, yz, xz]"));
}

void check_kind(const Settings& s, int dimension, Problems& problems) {
  const std::string kind = s.text("kind");
  for (const auto& [section, of] : {std::pair("law", "healed"), std::pair("friction", "closed")}) {
    if (kind == of && !s.has(section))
      problems.add(s.error(section,
                           std::string("is missing: the ") +
                               (kind == "healed" ? "strength of healed" : "friction of closed") +
                               " fractures",
                           std::string("add [fractures.") + section + "] below it"));
    if (kind != of && s.has(section))
      problems.add(s.at(section).error("", std::string("is for kind = \"") + of + "\"",
                                       "leave it out, or change kind"));
  }
  if (kind != "closed" && !s.list("patch").empty())
    problems.add(s.list("patch")[0].error("", "only a closed fracture has patches"));
  if (s.has("friction")) {
    check_friction(s.at("friction"), "coefficient", problems);
    check_stress_length(s.at("friction"), dimension, problems);
  }
  for (const Settings& patch : s.list("patch")) check_stress_length(patch, dimension, problems);
}

void check_orientation(const Settings& s, const char* section, int dimension, Problems& problems) {
  if (!s.has(section) || dimension != 3) return;
  const Settings& inner = s.at(section);
  if (inner.has("normal"))
    check_direction(inner, "normal", problems);
  else if (inner.text_or("orientation", "parallel") != "uniform")
    problems.add(inner.error("normal", "is missing", "for example: normal = [0, 0, 1]"));
}

}  // namespace

void declare_fracture_shape_keys(Schema& schema) {
  auto s = schema.section("fractures[]")
               .doc(
                   "Fractures that are there before the start: element faces lie on them. Gmsh "
                   "embeds them; other meshes must have faces there.");
  s.text("name").required().unique().doc("Their region is BODY.NAME.").example("flaw");
  s.text("body").required().names_one_of("body").doc("The body they are in.").example("block");
  s.choice("kind", {"open", "closed", "healed"})
      .required()
      .doc(
          "open: the mesh is cut there, contact acts if the scene has it; closed: no strength, but "
          "friction (fractures.friction); healed: a strength of their own (fractures.law).")
      .example("closed");
  s.lines("lines", unit::length)
      .doc("Polylines in the plane, flat convex polygons in space, each as a list of points.")
      .example("[[[0, 0], [\"5 mm\", \"5 mm\"]]]");
  s.text("file").names_file().doc("Polylines or polygons, .csv or .dxf.").example("faults.csv");
  s.number("scale", unit::none)
      .above(0)
      .by_default(1.0)
      .doc("Metres per unit of the file.")
      .example("0.001");
  s.number("size", unit::length)
      .above(0)
      .doc("Element size along them; the body's if absent.")
      .example("0.5 mm");
  s.number("growth", unit::none)
      .above(0)
      .at_most(1)
      .by_default(0.3)
      .doc("How fast that size grows with the distance.");
  auto disc = schema.section("fractures[].disc[]").only_in(3).doc("A round fracture.");
  disc.vector("centre", unit::length).required().doc("Its centre.").example("[0, 0, 0]");
  disc.vector("normal", unit::none).required().doc("Its normal.").example("[0, 0, 1]");
  disc.number("diameter", unit::length).above(0).required().doc("Its diameter.").example("10 mm");
  declare_set(schema);
  declare_planes(schema);
  declare_grains(schema);
  s.exactly_one_of({"lines", "file", "disc", "set", "planes", "grains"});
}

void check_fracture_rules(const Settings& scene, Problems& problems) {
  const int dimension = static_cast<int>(scene.at("run").integer("dimension"));
  for (const Settings& s : scene.list("fractures")) {
    check_kind(s, dimension, problems);
    check_orientation(s, "set", dimension, problems);
    check_orientation(s, "planes", dimension, problems);
    if (s.has("set") && s.at("set").number("shortest") > s.at("set").number("longest"))
      problems.add(s.at("set").error("shortest", "is longer than the longest"));
    for (const Settings& disc : s.list("disc")) check_direction(disc, "normal", problems);
    for (const Settings& patch : s.list("patch"))
      for (std::size_t d = 0; d < patch.vector("lower").size(); ++d) {
        if (patch.vector("lower")[d] <= patch.vector("upper")[d]) continue;
        problems.add(patch.error("upper", std::string("is below lower along ") + "xyz"[d]));
        break;
      }
  }
}

}  // namespace breccia
