#include "scene/main_crack.hpp"

#include "core/disjoint_sets.hpp"
#include "mesh/geometry.hpp"

#include <algorithm>
#include <cmath>
#include <map>

namespace breccia {

namespace {

constexpr int kReleased = 2;

/// The released faces of the cluster of largest area.
template <int D>
std::vector<CrackFace> largest_cluster(const std::vector<CrackFace>& all) {
  std::vector<CrackFace> faces;
  for (const CrackFace& face : all)
    if (face.status == kReleased) faces.push_back(face);
  const auto count = static_cast<Index>(faces.size());
  DisjointSets clusters(faces.size());
  std::map<Index, Index> first;  // face at each point of the mesh
  for (Index i = 0; i < count; ++i)
    for (int c = 0; c < D; ++c)
      clusters.join(i, first.try_emplace(faces[i].family[c], i).first->second);
  std::map<Index, double> area;
  for (Index i = 0; i < count; ++i) area[clusters.root(i)] += faces[i].area;
  const auto best = std::max_element(
      area.begin(), area.end(), [](const auto& a, const auto& b) { return a.second < b.second; });
  std::vector<CrackFace> cluster;
  for (Index i = 0; i < count; ++i)
    if (clusters.root(i) == best->first) cluster.push_back(faces[i]);
  return cluster;
}

/// How far the crack had come, and when.
struct Advance {
  double time, reach;
};

template <int D>
std::vector<Advance> advances(std::vector<CrackFace> faces, const std::vector<Point<D>>& point) {
  std::stable_sort(faces.begin(), faces.end(),
                   [](const CrackFace& a, const CrackFace& b) { return a.time < b.time; });
  Point<D> origin{};
  for (int c = 0; c < D; ++c)
    for (std::size_t d = 0; d < D; ++d) origin[d] += point[faces.front().family[c]][d] / D;
  std::vector<Advance> way{{faces.front().time, 0}};
  for (const CrackFace& face : faces)
    for (int c = 0; c < D; ++c) {
      const double reach = length(minus(point[face.family[c]], origin));
      if (reach > way.back().reach) way.push_back({face.time, reach});
    }
  return way;
}

/// Shares of its way over which the speed of a crack is taken: more than single faces, which
/// break in jumps.
constexpr double kWindow = 0.2;

double greatest_speed(const std::vector<Advance>& way) {
  const double window = kWindow * way.back().reach;
  double speed = 0;
  std::size_t from = 0;
  for (const Advance& to : way) {
    while (from + 1 < way.size() && way[from + 1].reach <= to.reach - window) ++from;
    const double passed = to.time - way[from].time, run = to.reach - way[from].reach;
    if (run >= window && passed > 0) speed = std::max(speed, run / passed);
  }
  return speed;
}

}  // namespace

template <int D>
MainCrack find_main_crack(const std::vector<CrackFace>& all, const std::vector<Point<D>>& point) {
  const std::vector<CrackFace> faces = largest_cluster<D>(all);
  MainCrack crack;
  const auto middle = [&point](const CrackFace& face, int d) {
    double sum = 0;
    for (int c = 0; c < D; ++c) sum += point[face.family[c]][d] / D;
    return sum;
  };
  for (const CrackFace& face : faces) {
    crack.area += face.area;
    for (int d = 0; d < D; ++d) crack.centre[d] += face.area * middle(face, d);
  }
  if (crack.area == 0) return crack;
  for (double& c : crack.centre) c /= crack.area;
  double xx = 0, yy = 0, xy = 0;
  for (const CrackFace& face : faces) {
    const double dx = middle(face, 0) - crack.centre[0], dy = middle(face, 1) - crack.centre[1];
    xx += face.area * dx * dx;
    yy += face.area * dy * dy;
    xy += face.area * dx * dy;
  }
  crack.angle = 0.5 * std::atan2(2 * xy, xx - yy);
  double low = 0, high = 0;
  for (const CrackFace& face : faces)
    for (int c = 0; c < D; ++c) {
      const Point<D>& x = point[face.family[c]];
      const double along = (x[0] - crack.centre[0]) * std::cos(crack.angle) +
                           (x[1] - crack.centre[1]) * std::sin(crack.angle);
      low = std::min(low, along);
      high = std::max(high, along);
    }
  crack.length = high - low;
  const std::vector<Advance> way = advances<D>(faces, point);
  crack.start = way.front().time;
  crack.speed = greatest_speed(way);
  return crack;
}

template MainCrack find_main_crack<2>(const std::vector<CrackFace>&, const std::vector<Point<2>>&);
template MainCrack find_main_crack<3>(const std::vector<CrackFace>&, const std::vector<Point<3>>&);

}  // namespace breccia
