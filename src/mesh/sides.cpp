#include "mesh/sides.hpp"

#include "mesh/face_table.hpp"
#include "mesh/geometry.hpp"
#include "mesh/refusal.hpp"
#include "mesh/region_builder.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

namespace breccia {
namespace {

template <int D>
struct Side {
  std::string name;
  std::function<bool(const Point<D>&)> holds;  ///< whether a point lies on the side
};

constexpr double kOnSide = 1e-7;

constexpr std::array<std::array<const char*, 2>, 3> kBoxSides = {
    {{"left", "right"}, {"bottom", "top"}, {"front", "back"}}};

template <int D>
std::vector<Side<D>> box_sides(const Point<D>& lower, const Point<D>& upper) {
  const double tolerance = kOnSide * length(minus(upper, lower));
  std::vector<Side<D>> sides;
  for (int k = 0; k < D; ++k) {
    for (int end = 0; end < 2; ++end) {
      const double plane = end == 0 ? lower[k] : upper[k];
      sides.push_back({kBoxSides[k][end],
                       [=](const Point<D>& x) { return std::abs(x[k] - plane) <= tolerance; }});
    }
  }
  return sides;
}

/// Whether x lies on the segment from a to b.
bool on_segment(const Point<2>& x, const Point<2>& a, const Point<2>& b, double tolerance) {
  const auto axis = minus(b, a);
  const double s = std::clamp(dot(minus(x, a), axis) / dot(axis, axis), 0.0, 1.0);
  return length(minus(x, along(a, s, axis))) <= tolerance;
}

double extent(std::span<const Point<2>> points) {
  double most = 0;
  for (const auto& x : points) most = std::max(most, length(minus(x, points[0])));
  return most;
}

bool on_loop(const Point<2>& x, const std::vector<Point<2>>& loop, double tolerance) {
  for (std::size_t i = 0; i < loop.size(); ++i) {
    if (on_segment(x, loop[i], loop[(i + 1) % loop.size()], tolerance)) return true;
  }
  return false;
}

std::vector<Side<2>> polygon_sides(const Polygon& polygon) {
  const double tolerance = kOnSide * extent(polygon.outer);
  std::vector<Side<2>> sides;
  for (std::size_t i = 0; i < polygon.outer.size(); ++i) {
    const auto a = polygon.outer[i];
    const auto b = polygon.outer[(i + 1) % polygon.outer.size()];
    sides.push_back({"side" + std::to_string(i),
                     [=](const Point<2>& x) { return on_segment(x, a, b, tolerance); }});
  }
  for (std::size_t h = 0; h < polygon.holes.size(); ++h) {
    const auto loop = polygon.holes[h];
    sides.push_back({"hole" + std::to_string(h),
                     [=](const Point<2>& x) { return on_loop(x, loop, tolerance); }});
  }
  return sides;
}

std::vector<Side<3>> cylinder_sides(const Cylinder& c) {
  const double height = length(c.axis);
  const double tolerance = kOnSide * (height + c.radius);
  const auto level = [=](const Point<3>& x) { return dot(minus(x, c.centre), c.axis) / height; };
  const auto radius = [=](const Point<3>& x) {
    return length(minus(x, along(c.centre, level(x) / height, c.axis)));
  };
  return {{"start", [=](const Point<3>& x) { return std::abs(level(x)) <= tolerance; }},
          {"end", [=](const Point<3>& x) { return std::abs(level(x) - height) <= tolerance; }},
          {"side", [=](const Point<3>& x) { return std::abs(radius(x) - c.radius) <= tolerance; }}};
}

std::vector<Side<2>> sides_of(const Shape& shape, std::integral_constant<int, 2>) {
  if (const auto* r = std::get_if<Rectangle>(&shape)) return box_sides<2>(r->lower, r->upper);
  if (const auto* p = std::get_if<Polygon>(&shape)) return polygon_sides(*p);
  if (const auto* d = std::get_if<Disc>(&shape)) {
    return {{"rim", [disc = *d](const Point<2>& x) {
               return std::abs(length(minus(x, disc.centre)) - disc.radius) <=
                      kOnSide * disc.radius;
             }}};
  }
  return {};
}

std::vector<Side<3>> sides_of(const Shape& shape, std::integral_constant<int, 3>) {
  if (const auto* b = std::get_if<Box>(&shape)) return box_sides<3>(b->lower, b->upper);
  if (const auto* c = std::get_if<Cylinder>(&shape)) return cylinder_sides(*c);
  if (const auto* s = std::get_if<Ball>(&shape)) {
    return {{"surface", [ball = *s](const Point<3>& x) {
               return std::abs(length(minus(x, ball.centre)) - ball.radius) <=
                      kOnSide * ball.radius;
             }}};
  }
  return {};
}

template <int D, class Holds>
bool all_points(const Mesh<D>& mesh, const ElementFace& face, Holds&& holds) {
  for (int i = 0; i < D; ++i) {
    const Index p = mesh.element[face.element][face_node<D>(face.face, i)];
    if (!holds(mesh.point[p])) return false;
  }
  return true;
}

/// The sides of a face that belong to the body.
std::vector<ElementFace> within(const std::vector<Index>& body_of, Index body,
                                std::span<const ElementFace> sides) {
  std::vector<ElementFace> own;
  for (const ElementFace& side : sides) {
    if (body_of[side.element] == body) own.push_back(side);
  }
  return own;
}

}  // namespace

template <int D>
void add_side_regions(Mesh<D>& mesh, Index body, const Shape& shape) {
  const auto sides = sides_of(shape, std::integral_constant<int, D>{});
  std::vector<RegionBuilder<D>> builder(sides.size());
  for_each_face(mesh, [&](std::span<const ElementFace> faces) {
    const auto own = within(mesh.body, body, faces);
    if (own.size() != 1) return;
    for (std::size_t s = 0; s < sides.size(); ++s) {
      if (all_points(mesh, own[0], sides[s].holds)) builder[s].add_face(mesh, own[0]);
    }
  });
  for (std::size_t s = 0; s < sides.size(); ++s) {
    mesh.regions.push_back(builder[s].finish(mesh.body_names[body] + "." + sides[s].name));
  }
}

void add_line_regions(Mesh<2>& mesh, Index body, std::span<const EmbeddedLine> lines) {
  if (lines.empty()) return;
  std::vector<RegionBuilder<2>> builder(lines.size());
  for_each_face(mesh, [&](std::span<const ElementFace> faces) {
    const auto own = within(mesh.body, body, faces);
    if (own.empty()) return;
    for (std::size_t n = 0; n < lines.size(); ++n) {
      const auto& points = lines[n].points;
      const double tolerance = kOnSide * extent(points);
      for (std::size_t i = 1; i < points.size(); ++i) {
        const auto on = [&](const Point<2>& x) {
          return on_segment(x, points[i - 1], points[i], tolerance);
        };
        if (!all_points(mesh, own[0], on)) continue;
        builder[n].add_face(mesh, own[0]);
        break;
      }
    }
  });
  for (std::size_t n = 0; n < lines.size(); ++n) {
    if (builder[n].empty()) {
      refuse("body \"" + mesh.body_names[body] + "\"",
             "the line \"" + lines[n].name + "\" does not run through it",
             "move the line into the body, or give it to the body that it crosses");
    }
    mesh.regions.push_back(builder[n].finish(mesh.body_names[body] + "." + lines[n].name));
  }
}

template void add_side_regions<2>(Mesh<2>&, Index, const Shape&);
template void add_side_regions<3>(Mesh<3>&, Index, const Shape&);

}  // namespace breccia
