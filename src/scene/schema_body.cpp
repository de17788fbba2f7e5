// The keys of [[body]]: what it is, its shape, its mesh.
#include "scene/schema_rules.hpp"

namespace breccia {

namespace {

void declare_plane_shapes(Schema& schema) {
  auto rectangle = schema.section("body[].shape.rectangle").only_in(2).doc("Along the axes.");
  rectangle.vector("corner", unit::length).required().doc("Lower left corner.").example("[0, 0]");
  rectangle.vector("size", unit::length)
      .above(0)
      .required()
      .doc("Extent along x and y.")
      .example("[\"50 mm\", \"10 mm\"]");
  auto disc = schema.section("body[].shape.disc").only_in(2).doc("A full circle.");
  disc.vector("centre", unit::length).required().doc("Its centre.").example("[0, 0]");
  disc.number("diameter", unit::length).above(0).required().doc("Its diameter.").example("50 mm");
  auto polygon = schema.section("body[].shape.polygon").only_in(2).doc("An outline with holes.");
  polygon.points("points", unit::length)
      .required()
      .doc("Corners in order, the first one not repeated.")
      .example("[[0, 0], [\"40 mm\", 0], [0, \"30 mm\"]]");
  polygon.lines("holes", unit::length)
      .doc("Outlines of holes, each as points.")
      .example("[[[0.01, 0.01], [0.02, 0.01], [0.01, 0.02]]]");
}

void declare_space_shapes(Schema& schema) {
  auto box = schema.section("body[].shape.box").only_in(3).doc("Along the axes.");
  box.vector("corner", unit::length).required().doc("Lowest corner.").example("[0, 0, 0]");
  box.vector("size", unit::length)
      .above(0)
      .required()
      .doc("Extent along x, y and z.")
      .example("[\"100 mm\", \"10 mm\", \"10 mm\"]");
  auto ball = schema.section("body[].shape.ball").only_in(3).doc("A full sphere.");
  ball.vector("centre", unit::length).required().doc("Its centre.").example("[0, 0, 0]");
  ball.number("diameter", unit::length).above(0).required().doc("Its diameter.").example("20 mm");
  auto cylinder = schema.section("body[].shape.cylinder").only_in(3).doc("A round bar.");
  cylinder.vector("centre", unit::length)
      .required()
      .doc("Centre of its first end.")
      .example("[0, 0, 0]");
  cylinder.vector("axis", unit::none)
      .required()
      .doc("Direction from that end.")
      .example("[0, 0, 1]");
  cylinder.number("diameter", unit::length)
      .above(0)
      .required()
      .doc("Its diameter.")
      .example("50 mm");
  cylinder.number("length", unit::length).above(0).required().doc("Its length.").example("100 mm");
}

void declare_shape(Schema& schema) {
  auto s = schema.section("body[].shape").required().doc("What the body looks like.");
  s.text("file")
      .names_file()
      .doc("A mesh (.msh of Gmsh, .h5 of breccia mesh) or Gmsh geometry (.geo) beside the scene.")
      .example("disc.msh");
  s.text("region").doc("Only this physical group, body or region of the file.").example("rock");
  s.exactly_one_of({"rectangle", "disc", "polygon", "box", "ball", "cylinder", "file"});
  declare_plane_shapes(schema);
  declare_space_shapes(schema);
}

void declare_mesh(Schema& schema) {
  auto s = schema.section("body[].mesh").always().doc("How the body is cut into elements.");
  s.choice("element", {"tri3", "tri6c", "tet4", "tet10c", "tet10c12"})
      .doc(
          "Kind of element. Simple ones: tri3 in the plane, tet4 in space, the same if absent. "
          "Composites, whose sub-elements share one pressure and follow curved boundaries: tri6c "
          "of 4 triangles, tet10c of 8 and tet10c12 of 12 tetrahedra.")
      .example("tri6c");
  s.number("size", unit::length).above(0).doc("Length of an element's edges.").example("0.5 mm");
  s.choice("generator", {"gmsh", "structured"})
      .by_default("gmsh")
      .doc("Gmsh for any shape; structured for rectangles and boxes, without Gmsh.");
  s.choice("arrangement", {"irregular", "regular"})
      .by_default("irregular")
      .doc(
          "Of Gmsh's triangles: edges in all directions alike, as fracture needs, or better "
          "triangles with edges mostly in three directions.");
  s.choice("pattern", {"cross", "right", "union-jack", "kuhn", "five"})
      .doc(
          "How a structured cell is cut: cross, right, union-jack in the plane (cross if absent), "
          "kuhn, five in space (kuhn if absent).")
      .example("cross");
  s.integers("cells")
      .at_least(1)
      .doc("Structured cells along each axis, instead of size.")
      .example("[100, 20]");
  s.number("jitter", unit::none)
      .between(0, 0.3)
      .doc("Random shift of the inner points of a structured mesh, in cells.")
      .example("0.2");
  s.at_most_one_of({"size", "cells"});

  auto refine = schema.section("body[].mesh.refine[]").doc("Smaller elements near a place.");
  refine.vector("at", unit::length).required().doc("The place.").example("[0, \"25 mm\"]");
  refine.number("size", unit::length)
      .above(0)
      .required()
      .doc("Element size there.")
      .example("0.2 mm");
  refine.number("radius", unit::length)
      .above(0)
      .required()
      .doc("How far it reaches.")
      .example("5 mm");
  refine.number("transition", unit::length)
      .above(0)
      .doc("Distance over which it grows to the body's size; growth by 0.3 per length if absent.")
      .example("10 mm");

  auto embed = schema.section("body[].mesh.embed[]")
                   .only_in(2)
                   .doc(
                       "A line that element edges must follow: a joint or a crack that is there "
                       "from the start.");
  embed.text("name").required().unique().doc("Its region is BODY.NAME.").example("flaw");
  embed.points("points", unit::length)
      .required()
      .doc("Points of the line in order.")
      .example("[[0, 0], [\"5 mm\", \"5 mm\"]]");
}

void declare_copies(Schema& schema) {
  auto s = schema.section("body[].copies")
               .doc(
                   "Copies of the body on a raster, whose first site is where the body is. All of "
                   "them have its name, material and mesh.");
  s.integers("count").at_least(1).required().doc("Sites along each axis.").example("[10, 10, 10]");
  s.vector("pitch", unit::length)
      .required()
      .doc("Distance of the sites along each axis.")
      .example("[\"12 mm\", \"12 mm\", \"12 mm\"]");
  s.integers("hollow")
      .at_least(0)
      .doc("Sites left out in the middle of the raster, along each axis.")
      .example("[4, 4, 4]");
  s.integer("every").at_least(1).by_default(1).doc(
      "Only sites whose numbers along the axes add up to offset, or that and a multiple of "
      "this: bodies of several shapes take turns.");
  s.integer("offset").at_least(0).by_default(0).doc("See every.");
  s.number("shift", unit::length)
      .at_least(0)
      .doc("Largest random shift along each axis; by run.seed.")
      .example("0.5 mm");
  s.flag("turned").by_default(false).doc(
      "true: each copy is turned at random, about the middle of its box; by run.seed.");
}

}  // namespace

void declare_body_keys(Schema& schema) {
  auto s = schema.section("body[]").required().doc("A solid body.");
  s.text("name").required().unique().doc("Its name, and that of its region.").example("disc");
  s.text("material").required().names_one_of("material").doc("Its material.").example("granite");
  s.text("part_of")
      .doc("Bodies with the same word here grow together: they share nodes where they touch.")
      .example("layered rock");
  s.vector("velocity", unit::velocity)
      .doc("Velocity at the start; none if absent.")
      .example("[\"1 m/s\", 0]");
  s.rotation("spin", unit::angular_velocity)
      .doc("Rotation at the start about the body's centre of mass; none if absent.")
      .example("100 rad/s");
  s.number("expansion", unit::frequency)
      .doc(
          "Rate of stretching at the start, alike in all directions and about the body's centre of "
          "mass; none if absent.")
      .example("1e4 1/s");
  s.flag("rigid").by_default(false).doc(
      "true: it does not deform; it moves and turns as a whole, with the mass and inertia of its "
      "mesh's nodes.");
  auto towards = schema.section("body[].towards")
                     .doc("A velocity at the start towards a place, of each copy by itself.");
  towards.vector("place", unit::length).required().doc("The place.").example("[0, 0, 0]");
  towards.number("speed", unit::velocity)
      .required()
      .doc("How fast; negative: away from it.")
      .example("100 m/s");
  declare_copies(schema);
  declare_shape(schema);
  declare_mesh(schema);
}

}  // namespace breccia
