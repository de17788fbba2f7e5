#include "mesh/gmsh_geometry.hpp"

#if BRECCIA_WITH_GMSH

#include "mesh/geometry.hpp"
#include "mesh/refusal.hpp"
#include "mesh/size_field.hpp"

#include <gmsh.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace breccia {
namespace {

namespace occ = gmsh::model::occ;
using Tag = GmshTag;
using Tags = std::vector<Tag>;
using Owners = std::map<Tag, std::vector<std::size_t>>;

/// Adds shapes to the geometry, scaled.
struct ShapeMaker {
  double scale;

  /// A segment or a polygon.
  Tag piece(const FracturePiece& corners) const {
    std::vector<int> points, curves;
    for (const auto& x : corners)
      points.push_back(occ::addPoint(scale * x[0], scale * x[1], scale * x[2]));
    if (points.size() == 2) return {1, occ::addLine(points[0], points[1])};
    for (std::size_t i = 0; i < points.size(); ++i)
      curves.push_back(occ::addLine(points[i], points[(i + 1) % points.size()]));
    return {2, occ::addPlaneSurface({occ::addCurveLoop(curves)})};
  }

  int point(const Point<2>& x) const { return occ::addPoint(scale * x[0], scale * x[1], 0); }

  Tag surface(const std::vector<std::vector<Point<2>>>& loops) const {
    std::vector<int> wires;
    for (const auto& loop : loops) {
      std::vector<int> points, curves;
      for (const auto& x : loop) points.push_back(point(x));
      for (std::size_t i = 0; i < points.size(); ++i) {
        curves.push_back(occ::addLine(points[i], points[(i + 1) % points.size()]));
      }
      wires.push_back(occ::addCurveLoop(curves));
    }
    return {2, occ::addPlaneSurface(wires)};
  }

  Tag operator()(const Rectangle& r) const {
    return surface({{r.lower, {r.upper[0], r.lower[1]}, r.upper, {r.lower[0], r.upper[1]}}});
  }
  Tag operator()(const Polygon& p) const {
    auto loops = p.holes;
    loops.insert(loops.begin(), p.outer);
    return surface(loops);
  }
  // Four arcs put points on the poles, where a platen touches.
  Tag operator()(const Disc& d) const {
    const int centre = point(d.centre);
    const double x = d.centre[0], y = d.centre[1], r = d.radius;
    const std::vector<Point<2>> poles = {{x + r, y}, {x, y + r}, {x - r, y}, {x, y - r}};
    std::vector<int> points, arcs;
    for (const auto& pole : poles) points.push_back(point(pole));
    for (int i = 0; i < 4; ++i) {
      arcs.push_back(occ::addCircleArc(points[i], centre, points[(i + 1) % 4]));
    }
    const Tag surface{2, occ::addPlaneSurface({occ::addCurveLoop(arcs)})};
    occ::remove({{0, centre}});
    return surface;
  }
  Tag operator()(const Box& b) const {
    const auto e = minus(b.upper, b.lower);
    return {3, occ::addBox(scale * b.lower[0], scale * b.lower[1], scale * b.lower[2], scale * e[0],
                           scale * e[1], scale * e[2])};
  }
  Tag operator()(const Ball& b) const {
    return {3, occ::addSphere(scale * b.centre[0], scale * b.centre[1], scale * b.centre[2],
                              scale * b.radius)};
  }
  Tag operator()(const Cylinder& c) const {
    return {3, occ::addCylinder(scale * c.centre[0], scale * c.centre[1], scale * c.centre[2],
                                scale * c.axis[0], scale * c.axis[1], scale * c.axis[2],
                                scale * c.radius)};
  }
  Tag operator()(const MeshFile&) const { throw std::logic_error("a file is not a Gmsh shape"); }
};

void add_owner(Owners& owners, const Tag& tag, std::size_t body) {
  auto& list = owners[tag];
  if (std::find(list.begin(), list.end(), body) == list.end()) list.push_back(body);
}

void add_boundaries(Owners& owners, const Tag& piece, std::size_t body) {
  Tags level = {piece};
  while (!level.empty() && level[0].first > 0) {
    Tags below;
    gmsh::model::getBoundary(level, below, false, false, false);
    for (const Tag& tag : below) add_owner(owners, tag, body);
    level = below;
  }
}

}  // namespace

double gmsh_scale(std::span<const BodyShape* const> bodies) {
  double extent = 0;
  for (const BodyShape* body : bodies) extent = std::max(extent, extent_of(body->shape));
  return std::exp2(std::round(std::log2(128 / extent)));
}

GmshAssembly gmsh_assemble(int dimension, std::span<const BodyShape* const> bodies, double scale) {
  const ShapeMaker maker{scale};
  Tags shapes, lines;
  std::vector<std::size_t> line_body;
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    shapes.push_back(std::visit(maker, bodies[b]->shape));
    for (const EmbeddedLine& line : bodies[b]->lines) {
      for (std::size_t i = 1; i < line.points.size(); ++i) {
        const int from = maker.point(line.points[i - 1]);
        lines.emplace_back(1, occ::addLine(from, maker.point(line.points[i])));
        line_body.push_back(b);
      }
    }
    for (const FractureNet& net : bodies[b]->fractures)
      for (const FracturePiece& piece : net.pieces) {
        lines.push_back(maker.piece(piece));
        line_body.push_back(b);
      }
  }
  Tags all;
  std::vector<Tags> parts;
  if (shapes.size() + lines.size() > 1) {
    occ::fragment(shapes, lines, all, parts);
  } else {
    parts = {shapes};
  }
  occ::synchronize();
  std::map<Tag, std::size_t> last;  // the later of two overlapping bodies takes the common part
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    for (const Tag& tag : parts[b]) last[tag] = b;
  }
  GmshAssembly assembly{{}, std::vector<Tags>(bodies.size())};
  for (const auto& [tag, b] : last) {
    if (tag.first != dimension) continue;
    assembly.pieces[b].push_back(tag);
    assembly.owners[tag] = {b};
    add_boundaries(assembly.owners, tag, b);
  }
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    if (!assembly.pieces[b].empty()) continue;
    refuse("body \"" + bodies[b]->name + "\"", "later bodies of its part cover it wholly",
           "list it after them, or remove it");
  }
  for (std::size_t n = 0; n < lines.size(); ++n) {
    for (const Tag& tag : parts[bodies.size() + n]) {
      add_owner(assembly.owners, tag, line_body[n]);
      add_boundaries(assembly.owners, tag, line_body[n]);
    }
  }
  return assembly;
}

}  // namespace breccia

#endif
