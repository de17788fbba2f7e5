#pragma once
#include "harness/mapped_grid.hpp"
#include "harness/scenes.hpp"
#include "harness/temp_folder.hpp"
#include "mesh/composite.hpp"
#include "mesh/geometry.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>

namespace breccia {

// Plane bodies of one kind of element, loaded and brought to rest (V-013 to V-016).

/// Number of triangles along each side of a composite: with half the cells a mesh of composites has
/// the nodes of a mesh of triangles.
inline int cells_of(const std::string& element, int segments) {
  return element == "tri6c" ? segments / 2 : segments;
}

/// A mapped grid with `sx` times `sy` segments along its sides, whatever the elements.
struct StaticBody {
  StaticBody(const BlockScene& scene, const std::string& element, int sx, int sy,
             const Mapping& map) {
    put_text(folder / "body.msh",
             mapped_grid(cells_of(element, sx), cells_of(element, sy), map, element == "tri6c"));
    BlockScene s = scene;
    s.file = folder / "body.msh";
    s.body = "mesh = { element = \"" + element + "\" }\n";
    world = std::make_unique<SceneWorld<2>>(s.text());
    world->simulation.start();
  }

  /// Steps until rest.
  void settle(int most = 1'000'000) {
    for (int i = 0; i < most && !world->model().rest.reached; ++i) world->step();
    EXPECT_TRUE(world->model().rest.reached) << "unbalance " << world->model().rest.unbalance
                                             << ", motion " << world->model().rest.motion;
  }

  /// Displacement of the node that started nearest to x, m.
  Vec<2> displacement(const Vec<2>& x) {
    const auto& point = world->model().mesh.point;
    std::size_t nearest = 0;
    for (std::size_t n = 0; n < point.size(); ++n)
      if (norm2(vector_of<2>(point[n]) - x) < norm2(vector_of<2>(point[nearest]) - x)) nearest = n;
    const auto now = world->host<NodePosition<2>>();
    return row<2>(now, static_cast<Index>(nearest)) - vector_of<2>(point[nearest]);
  }

  /// Pressure of every composite, or element, from its change of volume (plane strain), Pa.
  std::vector<double> pressures() {
    const auto& mesh = world->model().mesh;
    const auto composite = composite_of_elements(mesh);
    const auto now = world->host<NodePosition<2>>();
    std::vector<double> start(static_cast<std::size_t>(composite.back()) + 1, 0.0), end = start;
    for (Index e = 0; e < mesh.elements(); ++e) {
      Simplex<2> x;
      for (std::size_t a = 0; a < 3; ++a) {
        const Vec<2> place = row<2>(now, mesh.element[static_cast<std::size_t>(e)][a]);
        x[a] = {place[0], place[1]};
      }
      const auto c = static_cast<std::size_t>(composite[static_cast<std::size_t>(e)]);
      start[c] += signed_volume<2>(corners(mesh, e));
      end[c] += signed_volume<2>(x);
    }
    const auto lame = world->host<MaterialLame>();
    const double bulk = lame(0, 0) + 2 * lame(0, 1) / 3;
    for (std::size_t c = 0; c < start.size(); ++c)
      start[c] = -bulk * std::log(end[c] / start[c]) * start[c] / end[c];
    return start;
  }

  /// RMS of the difference to the mean of the neighbours, over the RMS of the pressure (V-016), of
  /// those that have neighbours all around.
  double checkerboard() {
    const auto& mesh = world->model().mesh;
    const auto composite = composite_of_elements(mesh);
    const auto p = pressures();
    std::vector<double> sum(p.size(), 0.0), count = sum;
    const double whole = 3.0 * (mesh.group_of_body(0) == 4 ? 2 : 1);  // faces of one inside
    for (const SharedFace& face : world->model().topology.shared) {
      const auto l = static_cast<std::size_t>(composite[static_cast<std::size_t>(face.left)]);
      const auto r = static_cast<std::size_t>(composite[static_cast<std::size_t>(face.right)]);
      if (l == r) continue;
      sum[l] += p[r];
      sum[r] += p[l];
      ++count[l];
      ++count[r];
    }
    double off = 0, size = 0;
    for (std::size_t c = 0; c < p.size(); ++c) {
      if (count[c] < whole) continue;
      off += std::pow(p[c] - sum[c] / count[c], 2);
      size += p[c] * p[c];
    }
    return std::sqrt(off / size);
  }

  TempFolder folder;
  std::unique_ptr<SceneWorld<2>> world;
};

}  // namespace breccia
