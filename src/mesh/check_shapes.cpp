#include "mesh/check_shapes.hpp"

#include "mesh/geometry.hpp"
#include "mesh/refusal.hpp"
#include "mesh/size_field.hpp"

#include <cmath>
#include <limits>

namespace breccia {
namespace {

std::string place_of(const BodyShape& body) {
  return "body \"" + body.name + "\"";
}

bool is_positive(double x) {
  return x > 0 && std::isfinite(x);
}

double turn(const Point<2>& a, const Point<2>& b, const Point<2>& c) {
  const auto u = minus(b, a);
  const auto v = minus(c, a);
  return u[0] * v[1] - u[1] * v[0];
}

/// Whether two segments cross at a point inside both.
bool cross_each_other(const Point<2>& a, const Point<2>& b, const Point<2>& c, const Point<2>& d) {
  return turn(a, b, c) * turn(a, b, d) < 0 && turn(c, d, a) * turn(c, d, b) < 0;
}

using Loop = std::vector<Point<2>>;

bool loops_cross(const Loop& a, const Loop& b) {
  for (std::size_t i = 0; i < a.size(); ++i) {
    for (std::size_t j = 0; j < b.size(); ++j) {
      const auto& next = a[(i + 1) % a.size()];
      if (cross_each_other(a[i], next, b[j], b[(j + 1) % b.size()])) return true;
    }
  }
  return false;
}

double loop_area(const Loop& loop) {
  double twice = 0;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const auto& a = loop[i];
    const auto& b = loop[(i + 1) % loop.size()];
    twice += a[0] * b[1] - a[1] * b[0];
  }
  return std::abs(0.5 * twice);
}

/// By the number of edges that a ray from x along the first axis crosses.
bool is_inside(const Point<2>& x, const Loop& loop) {
  bool inside = false;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const auto& a = loop[i];
    const auto& b = loop[(i + 1) % loop.size()];
    if ((a[1] > x[1]) == (b[1] > x[1])) continue;
    const double s = (x[1] - a[1]) / (b[1] - a[1]);
    if (a[0] + s * (b[0] - a[0]) > x[0]) inside = !inside;
  }
  return inside;
}

void check_loop(const BodyShape& body, const Loop& loop, const std::string& name) {
  if (loop.size() < 3) {
    refuse(place_of(body), name + " has " + std::to_string(loop.size()) + " points",
           "give at least three points; the last joins the first by itself");
  }
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const auto& next = loop[(i + 1) % loop.size()];
    if (loop[i] != next) continue;
    refuse(place_of(body), name + " repeats the point " + place_text(next),
           "give every corner once; the last joins the first by itself");
  }
  if (loops_cross(loop, loop)) {
    refuse(place_of(body), name + " crosses itself", "list the corners in order around it");
  }
  if (!is_positive(loop_area(loop))) {
    refuse(place_of(body), name + " encloses no area", "give corners that do not lie on one line");
  }
}

struct ShapeCheck {
  int dimension;
  const BodyShape& body;

  template <std::size_t D>
  void extent(const std::array<double, D>& lower, const std::array<double, D>& upper) const {
    for (std::size_t k = 0; k < D; ++k) {
      if (is_positive(upper[k] - lower[k])) continue;
      refuse(place_of(body), "its extent along " + std::string(1, "xyz"[k]) + " is not positive",
             "give lower and upper corners with lower < upper");
    }
  }
  void radius(double r) const {
    if (is_positive(r)) return;
    refuse(place_of(body), "its radius is " + short_number(r) + " m", "give a positive radius");
  }
  void belongs_to(int shape_dimension, const std::string& name) const {
    if (shape_dimension == dimension) return;
    refuse(place_of(body),
           "a " + name + " is a shape of dimension " + std::to_string(shape_dimension) +
               " in a scene of dimension " + std::to_string(dimension),
           dimension == 2 ? "use rectangle, disc, polygon or file"
                          : "use box, ball, cylinder or file");
  }

  void operator()(const Rectangle& r) const {
    belongs_to(2, "rectangle");
    extent(r.lower, r.upper);
  }
  void operator()(const Disc& d) const {
    belongs_to(2, "disc");
    radius(d.radius);
  }
  void operator()(const Polygon& p) const {
    belongs_to(2, "polygon");
    check_loop(body, p.outer, "its outline");
    for (std::size_t h = 0; h < p.holes.size(); ++h) {
      const std::string name = "hole " + std::to_string(h);
      check_loop(body, p.holes[h], name);
      if (loops_cross(p.holes[h], p.outer) || !is_inside(p.holes[h][0], p.outer)) {
        refuse(place_of(body), name + " is not inside the outline", "move or shrink the hole");
      }
    }
  }
  void operator()(const Box& b) const {
    belongs_to(3, "box");
    extent(b.lower, b.upper);
  }
  void operator()(const Ball& b) const {
    belongs_to(3, "ball");
    radius(b.radius);
  }
  void operator()(const Cylinder& c) const {
    belongs_to(3, "cylinder");
    radius(c.radius);
    if (is_positive(length(c.axis))) return;
    refuse(place_of(body), "its axis has no length",
           "give the vector from the centre of one end to the centre of the other");
  }
  void operator()(const MeshFile&) const {}
};

/// A slip of the unit must not end in a machine without memory.
void check_count(int dimension, const BodyShape& body) {
  constexpr double most = 5e8;
  const double count = std::pow(extent_of(body.shape) / body.size, dimension);
  if (!(count > most)) return;
  refuse(place_of(body),
         "with elements of " + short_number(body.size) + " m it would have about " +
             short_number(count) + " of them",
         "check the unit of the mesh size");
}

void check_sizes(int dimension, const BodyShape& body) {
  const bool file = std::holds_alternative<MeshFile>(body.shape);
  if (!file && !is_positive(body.size)) {
    refuse(place_of(body), "its element size is " + short_number(body.size) + " m",
           "give a positive mesh size");
  }
  if (!file) check_count(dimension, body);
  for (const Refinement& r : body.refinements) {
    if (file) {
      refuse(place_of(body), "a mesh file cannot be refined", "refine it where it was made");
    }
    if (is_positive(r.size) && r.radius >= 0 && r.transition >= 0) continue;
    refuse(place_of(body),
           "a refinement has size " + short_number(r.size) + " m, radius " +
               short_number(r.radius) + " m, transition " + short_number(r.transition) + " m",
           "give a positive size; radius and transition may be zero but not negative");
  }
}

void check_lines(int dimension, const BodyShape& body) {
  if (body.lines.empty()) return;
  if (dimension == 3) {
    refuse(place_of(body), "lines are embedded in plane bodies only",
           "remove the lines, or give a mesh file with a physical group of surfaces");
  }
  if (body.pattern || std::holds_alternative<MeshFile>(body.shape)) {
    refuse(place_of(body), "only a mesh made by Gmsh can follow embedded lines",
           "remove `pattern`, or put the line into the mesh file as a physical group");
  }
  for (const EmbeddedLine& line : body.lines) {
    bool good = line.points.size() >= 2;
    for (std::size_t i = 1; good && i < line.points.size(); ++i) {
      good = is_positive(length(minus(line.points[i], line.points[i - 1])));
    }
    if (good) continue;
    refuse(place_of(body), "the line \"" + line.name + "\" has no length or repeats a point",
           "give at least two different points");
  }
}

void check_pattern(const BodyShape& body) {
  if (!body.pattern) return;
  const bool box =
      std::holds_alternative<Rectangle>(body.shape) || std::holds_alternative<Box>(body.shape);
  if (!box) {
    refuse(place_of(body), "only a rectangle or a box can have a structured pattern",
           "remove `pattern`; Gmsh meshes the other shapes");
  }
  if (!body.refinements.empty()) {
    refuse(place_of(body), "a structured pattern has one size everywhere",
           "remove `pattern` or the refinements");
  }
}

}  // namespace

void check_part(int dimension, std::span<const BodyShape* const> part) {
  const auto* first_file = std::get_if<MeshFile>(&part[0]->shape);
  for (const BodyShape* body : part) {
    std::visit(ShapeCheck{dimension, *body}, body->shape);
    check_sizes(dimension, *body);
    check_lines(dimension, *body);
    check_pattern(*body);
    if (part.size() == 1) continue;
    const auto* file = std::get_if<MeshFile>(&body->shape);
    if ((file != nullptr) != (first_file != nullptr) || (file && file->path != first_file->path)) {
      refuse(place_of(*body), "it is part of \"" + body->part_of + "\" with bodies of other origin",
             "parts of one solid come from one mesh file, or all from shapes");
    }
    if (body->pattern) {
      refuse(place_of(*body), "a body with a structured pattern cannot be part of another",
             "remove `pattern` or `part_of`");
    }
  }
}

}  // namespace breccia
