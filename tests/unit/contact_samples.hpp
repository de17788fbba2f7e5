#pragma once
#include "core/random.hpp"
#include "harness/contact_world.hpp"
#include "mesh/structured.hpp"

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

namespace breccia {

inline Mesh<2> block(Point<2> lower, Point<2> upper, Index nx, Index ny,
                     Pattern pattern = Pattern::cross, double jitter = 0, std::uint64_t seed = 1,
                     const std::string& name = "block") {
  Grid<2> grid;
  grid.lower = lower;
  grid.upper = upper;
  grid.cells = {nx, ny};
  grid.pattern = pattern;
  grid.jitter = jitter;
  grid.seed = seed;
  grid.body = name;
  return structured_mesh(grid);
}

/// A disc of rings of triangles about a hub; ring r has as many nodes as the rim.
inline Mesh<2> ring_disc(Vec<2> centre, double radius, int sides, int rings, double turn,
                         const std::string& name) {
  Mesh<2> mesh;
  mesh.body_names = {name};
  for (int r = 0; r < rings; ++r)
    for (int i = 0; i < sides; ++i) {
      const double angle = turn + 2 * std::numbers::pi * (i + 0.5 * r) / sides;
      const double reach = radius * (1 - static_cast<double>(r) / rings);
      mesh.point.push_back(
          {centre[0] + reach * std::cos(angle), centre[1] + reach * std::sin(angle)});
    }
  mesh.point.push_back({centre[0], centre[1]});
  const Index hub = rings * sides;
  for (int r = 0; r < rings; ++r)
    for (int i = 0; i < sides; ++i) {
      const Index a = r * sides + i, b = r * sides + (i + 1) % sides;
      if (r + 1 == rings) {
        mesh.element.push_back({a, b, hub});
        continue;
      }
      mesh.element.push_back({a, b, a + sides});
      mesh.element.push_back({b, b + sides, a + sides});
    }
  mesh.body.assign(mesh.element.size(), 0);
  return mesh;
}

/// Joins bodies without their regions.
template <int D>
Mesh<D> join(std::vector<Mesh<D>> bodies) {
  Mesh<D> all;
  for (Mesh<D>& body : bodies) {
    body.regions.clear();
    body.body_names = {"body" + std::to_string(all.body_names.size())};
    append(all, body);
  }
  return all;
}

template <int D>
void move_body(ContactWorld<D>& world, Index body, const Vec<D>& by) {
  std::vector<char> moved(world.x.size(), 0);
  for (std::size_t e = 0; e < world.mesh.element.size(); ++e)
    if (world.mesh.body[e] == body)
      for (const Index n : world.mesh.element[e]) {
        if (!moved[n]) world.x[n] += by;
        moved[n] = 1;
      }
}

}  // namespace breccia
