#include "mesh/select.hpp"

#include "mesh/geometry.hpp"
#include "mesh/refusal.hpp"
#include "mesh/region_builder.hpp"

#include <cmath>

namespace breccia {
namespace {

/// Free faces all of whose nodes pass, and every point that passes.
template <int D, class Inside>
Region select_points(const Mesh<D>& mesh, const Topology<D>& topology, Inside&& inside) {
  Region region;
  std::vector<char> chosen(mesh.point.size());
  for (Index p = 0; p < mesh.points(); ++p) {
    chosen[p] = inside(mesh.point[p]) ? 1 : 0;
    if (chosen[p]) region.points.push_back(p);
  }
  for (const ElementFace& side : topology.free) {
    bool all = true;
    for (int i = 0; i < D; ++i) {
      all = all && chosen[mesh.element[side.element][face_node<D>(side.face, i)]];
    }
    if (all) region.faces.push_back(side);
  }
  return region;
}

}  // namespace

template <int D>
Region select(const Mesh<D>& mesh, const Topology<D>& topology, const PlaneSelector<D>& plane) {
  const double size = length(plane.normal);
  if (!(size > 0)) refuse("plane", "its normal is zero", "give a normal with a length");
  return select_points(mesh, topology, [&](const Point<D>& x) {
    return std::abs(dot(minus(x, plane.through), plane.normal)) <= plane.tolerance * size;
  });
}

template <int D>
Region select(const Mesh<D>& mesh, const Topology<D>& topology, const BoxSelector<D>& box) {
  const auto inside = [&](const Point<D>& x) {
    bool in = true;
    for (int k = 0; k < D; ++k) in = in && x[k] >= box.lower[k] && x[k] <= box.upper[k];
    return in;
  };
  Region region = select_points(mesh, topology, inside);
  for (Index e = 0; e < mesh.elements(); ++e) {
    if (inside(centroid<D>(corners(mesh, e)))) region.elements.push_back(e);
  }
  return region;
}

template Region select<2>(const Mesh<2>&, const Topology<2>&, const PlaneSelector<2>&);
template Region select<3>(const Mesh<3>&, const Topology<3>&, const PlaneSelector<3>&);
template Region select<2>(const Mesh<2>&, const Topology<2>&, const BoxSelector<2>&);
template Region select<3>(const Mesh<3>&, const Topology<3>&, const BoxSelector<3>&);

}  // namespace breccia
