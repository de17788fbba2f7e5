// The keys of what acts on bodies: gravity, boundaries, stress in the ground.
#include "core/text.hpp"
#include "scene/schema_rules.hpp"
#include "step/selection.hpp"

#include <algorithm>

namespace breccia {

namespace {

void declare_gravity(Schema& schema) {
  auto s = schema.section("gravity").effect("gravity").doc("A uniform acceleration of all bodies.");
  s.vector("acceleration", unit::acceleration)
      .required()
      .doc("The acceleration.")
      .example("[0, \"-9.81 m/s2\"]");
  s.number("ramp", unit::time)
      .above(0)
      .doc("Time of a smooth rise from zero to the full acceleration.")
      .example("10 ms");
}

void declare_plane(Schema& schema, const std::string& section) {
  auto plane = schema.section(section + ".plane").doc("Nodes and free faces on a plane.");
  plane.vector("point", unit::length)
      .required()
      .doc("A point of the plane.")
      .example("[0, \"10 mm\"]");
  plane.vector("normal", unit::none).required().doc("Its normal, of any length.").example("[0, 1]");
  plane.number("tolerance", unit::length)
      .above(0)
      .doc("Distance that still counts; a millionth of the scene's extent if absent.")
      .example("1 um");
}

void declare_box(Schema& schema, const std::string& section, const char* doc) {
  auto box = schema.section(section + ".box").doc(doc);
  box.vector("lower", unit::length).required().doc("Lowest corner.").example("[0, 0]");
  box.vector("upper", unit::length)
      .required()
      .doc("Highest corner.")
      .example("[\"1 mm\", \"50 mm\"]");
}

/// How a rigid body turns that a boundary moves or holds.
void declare_turning(SectionBuilder& s) {
  s.rotation("spin", unit::angular_velocity)
      .doc(
          "Of a rigid body that this boundary moves or holds: prescribed rotation about its centre "
          "of mass, times ramp or table. Without it such a body does not turn.")
      .example("2 rad/s");
  s.flag("pivot").doc(
      "true: a rigid body that this boundary moves or holds turns freely about its centre of "
      "mass.");
}

void declare_boundaries(Schema& schema) {
  auto s = schema.section("boundary[]")
               .effect("boundary")
               .doc("What holds, moves or loads a part of the scene.");
  s.text("name").unique().doc("A name, for [[sensor]] reaction and messages.").example("foot");
  s.text("where")
      .doc("A body, or a region of a mesh such as \"disc.rim\".")
      .example("upper platen");
  s.vector("velocity", unit::velocity)
      .components_may_be("free")
      .doc("Prescribed velocity; a free component moves as the forces tell.")
      .example("[0, \"-0.1 m/s\"]");
  s.vector("fixed", unit::length)
      .between(0, 0)
      .components_may_be("free")
      .doc("Components that do not move (0) and those that may (\"free\").")
      .example("[\"free\", 0]");
  declare_turning(s);
  s.vector("traction", unit::pressure)
      .doc("Force per reference area on the free faces there.")
      .example("[0, \"-2 MPa\"]");
  s.number("pressure", unit::pressure)
      .doc("Pressure on the free faces there, following them; positive pushes.")
      .example("3 MPa");
  s.flag("symmetry")
      .doc("true: the plane of a mirror; nothing moves through it. For a `plane` along two axes.");
  s.flag("non_reflecting")
      .doc("true: the free faces there let waves out, and hold the initial stress of the ground.");
  s.vector("input", unit::velocity)
      .doc("Motion that comes in through a non-reflecting boundary, as it would be far inside.")
      .example("[\"0.1 m/s\", 0]");
  s.flag("held").doc("true: the free faces there carry the traction of the initial stress.");
  s.flag("on_new_faces")
      .doc("true: the pressure also acts on faces that break open from where it acts.");
  auto source = schema.section("boundary[].source")
                    .doc("Where a pressure comes from: how it changes with the distance.");
  source.vector("point", unit::length).required().doc("Its place.").example("[0, 0]");
  source.number("speed", unit::velocity)
      .above(0)
      .doc("How fast its course spreads; everywhere at once if absent.")
      .example("2000 m/s");
  source.table("decay", unit::length, unit::none)
      .doc("Rows [distance, factor], linear between the rows.")
      .example("[[0, 1], [\"1 m\", 0.2]]");
  s.number("ramp", unit::time)
      .above(0)
      .doc("Time of a smooth rise from zero to the full value.")
      .example("0.1 ms");
  s.table("table", unit::time, unit::none)
      .doc("Rows [time, factor] that the value is multiplied by, linear between the rows.")
      .example("[[0, 0], [\"0.1 ms\", 1], [\"1 ms\", 0]]");
  s.exactly_one_of({"where", "plane", "box"});
  s.exactly_one_of(
      {"velocity", "fixed", "symmetry", "traction", "pressure", "non_reflecting", "held"});
  s.at_most_one_of({"ramp", "table"});
  s.at_most_one_of({"spin", "pivot"});
  declare_plane(schema, "boundary[]");
  declare_box(schema, "boundary[]", "Nodes and free faces inside a box.");
}

void declare_initial_stress(Schema& schema) {
  auto s =
      schema.section("initial_stress[]")
          .effect("solid")
          .doc("Stress that the ground carries before anything moves; everywhere, or in a part.");
  s.text("where").doc("A body, or a region with elements.").example("rock");
  s.numbers("stress", unit::pressure)
      .required()
      .doc(
          "Cauchy stress at `datum`, tension positive: [xx, yy, zz, xy], in space [xx, yy, zz, xy, "
          "yz, xz].")
      .example("[\"-5 MPa\", \"-10 MPa\", \"-5 MPa\", 0]");
  s.numbers("gradient", unit::interface_stiffness)
      .doc("Growth of each component along `axis`; none if absent.")
      .example("[\"13 kPa/m\", \"26 kPa/m\", \"13 kPa/m\", 0]");
  s.choice("axis", {"x", "y", "z"}).doc("Axis along which the stress grows.").example("y");
  s.number("datum", unit::length)
      .by_default("0 m")
      .doc("Coordinate along `axis` where the stress is `stress`.")
      .example("120 m");
  s.at_most_one_of({"where", "box"});
  declare_box(schema, "initial_stress[]", "Elements whose centroids lie in a box.");
}

void check_stress(const Settings& section, std::size_t dimension, Problems& problems) {
  const std::size_t wanted = dimension == 2 ? 4 : 6;
  for (const char* key : {"stress", "gradient"}) {
    if (!section.has(key) || section.vector(key).size() == wanted) continue;
    problems.add(section.error(key,
                               std::to_string(section.vector(key).size()) +
                                   " components; a stress has " + std::to_string(wanted) +
                                   (dimension == 2 ? " in the plane" : " in space"),
                               dimension == 2 ? "[xx, yy, zz, xy]" : "[xx, yy, zz, xy, yz, xz]"));
  }
  if (section.has("gradient") && !section.has("axis"))
    problems.add(section.error("gradient", "along which axis?", "add axis = \"y\""));
  if (section.has("axis") && !section.has("gradient"))
    problems.add(section.error("axis", "nothing grows along it", "add a gradient"));
  if (dimension == 2 && section.text_or("axis", "x") == "z")
    problems.add(section.error("axis", "there is no z in the plane", "x or y"));
}

void check_kind(const Settings& boundary, Problems& problems) {
  for (const char* key : {"symmetry", "non_reflecting", "held", "on_new_faces"})
    if (boundary.has(key) && !boundary.flag(key))
      problems.add(boundary.error(key, "false says nothing", "write true, or leave it out"));
  for (const char* key : {"source", "on_new_faces"})
    if (boundary.has(key) && !boundary.has("pressure"))
      problems.add(boundary.error(key, "is for a pressure"));
  if (boundary.has("input") && !boundary.has("non_reflecting"))
    problems.add(boundary.error("input", "comes in through a non-reflecting boundary only",
                                "add non_reflecting = true, or prescribe a velocity"));
  if (boundary.has("pivot") && !boundary.flag("pivot"))
    problems.add(boundary.error("pivot", "false says nothing", "write true, or leave it out"));
  for (const char* key : {"ramp", "table"})
    if (boundary.has(key) && (boundary.has("held") || boundary.has("symmetry") ||
                              (boundary.has("fixed") && !boundary.has("spin")) ||
                              (boundary.has("non_reflecting") && !boundary.has("input"))))
      problems.add(boundary.error(key, "there is nothing here that could rise"));
  if (!boundary.has("symmetry")) return;
  if (!boundary.has("plane")) {
    problems.add(boundary.error("symmetry", "needs a plane to mirror at",
                                "plane = { point = [0, 0], normal = [1, 0] }"));
    return;
  }
  const std::vector<double>& normal = boundary.at("plane").vector("normal");
  if (std::count(normal.begin(), normal.end(), 0.0) + 1 != static_cast<long>(normal.size()))
    problems.add(boundary.at("plane").error(
        "normal", "a mirror's normal must be along an axis",
        "turn the scene so that the plane of symmetry is along the axes"));
}

/// Who would not hold an initial stress as it is given.
void check_who_bears(const Settings& scene, const Settings& section, Problems& problems) {
  if (scene.at("run").text_or("plane", "strain") == "stress")
    problems.add(
        section.error("", "initial stress is for plane strain", "write run.plane = \"strain\""));
  for (const Settings& material : scene.children("material"))
    if (material.has("eos"))
      problems.add(section.error(
          "", "the equation of state of " + material.name() + " sets its pressure from its density",
          "leave one of the two out"));
}

}  // namespace

void declare_load_keys(Schema& schema) {
  declare_gravity(schema);
  declare_boundaries(schema);
  declare_initial_stress(schema);
}

void check_load_rules(const Settings& scene, Problems& problems) {
  for (const Settings& boundary : scene.list("boundary")) {
    if (boundary.has("plane")) check_direction(boundary.at("plane"), "normal", problems);
    check_box(boundary, problems);
    check_kind(boundary, problems);
  }
  const auto dimension = static_cast<std::size_t>(scene.at("run").integer("dimension"));
  for (const Settings& section : scene.list("initial_stress")) {
    check_box(section, problems);
    check_stress(section, dimension, problems);
    check_who_bears(scene, section, problems);
  }
}

}  // namespace breccia
