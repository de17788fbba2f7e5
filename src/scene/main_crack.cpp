#include "scene/main_crack.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

namespace breccia {

namespace {

constexpr int kReleased = 2;

/// Faces of one crack share a point: points are compared on a grid far finer than any face.
struct Corner {
  long long at[3];
  auto operator<=>(const Corner&) const = default;
};

struct Joined {
  std::vector<std::size_t> parent;
  std::size_t root(std::size_t i) {
    while (parent[i] != i) i = parent[i] = parent[parent[i]];
    return i;
  }
};

/// The faces of the cluster of largest area.
std::vector<const CrackFace*> largest_cluster(const std::vector<const CrackFace*>& faces,
                                              int dimension) {
  double mean = 0;
  for (const CrackFace* face : faces)
    mean += std::hypot(face->point[1][0] - face->point[0][0], face->point[1][1] - face->point[0][1],
                       face->point[1][2] - face->point[0][2]) /
            static_cast<double>(faces.size());
  // Broken faces drift apart a little; a tenth of a face still counts as the same point.
  const double grid = 0.1 * mean;
  Joined joined;
  joined.parent.resize(faces.size());
  std::iota(joined.parent.begin(), joined.parent.end(), std::size_t{0});
  std::map<Corner, std::size_t> first;
  for (std::size_t i = 0; i < faces.size(); ++i)
    for (int c = 0; c < dimension; ++c)
      for (int shift = 0; shift < (1 << dimension); ++shift) {
        Corner corner{};
        for (int d = 0; d < dimension; ++d)
          corner.at[d] =
              std::llround(std::floor(faces[i]->point[c][d] / grid + 0.5 * (shift >> d & 1)));
        const auto [found, fresh] =
            first.try_emplace(Corner{{corner.at[0] * 8 + shift, corner.at[1], corner.at[2]}}, i);
        if (!fresh) joined.parent[joined.root(i)] = joined.root(found->second);
      }
  std::map<std::size_t, double> area;
  for (std::size_t i = 0; i < faces.size(); ++i) area[joined.root(i)] += faces[i]->area;
  const auto best = std::max_element(
      area.begin(), area.end(), [](const auto& a, const auto& b) { return a.second < b.second; });
  std::vector<const CrackFace*> cluster;
  for (std::size_t i = 0; i < faces.size(); ++i)
    if (joined.root(i) == best->first) cluster.push_back(faces[i]);
  return cluster;
}

}  // namespace

MainCrack find_main_crack(const std::vector<CrackFace>& all, int dimension) {
  std::vector<const CrackFace*> faces;
  for (const CrackFace& face : all)
    if (face.status == kReleased) faces.push_back(&face);
  MainCrack crack;
  if (faces.empty()) return crack;
  faces = largest_cluster(faces, dimension);
  const auto middle = [dimension](const CrackFace& face, int d) {
    double sum = 0;
    for (int c = 0; c < dimension; ++c) sum += face.point[c][d] / dimension;
    return sum;
  };
  for (const CrackFace* face : faces) {
    crack.area += face->area;
    for (int d = 0; d < dimension; ++d) crack.centre[d] += face->area * middle(*face, d);
  }
  for (double& c : crack.centre) c /= crack.area;
  double xx = 0, yy = 0, xy = 0;
  for (const CrackFace* face : faces) {
    const double dx = middle(*face, 0) - crack.centre[0], dy = middle(*face, 1) - crack.centre[1];
    xx += face->area * dx * dx;
    yy += face->area * dy * dy;
    xy += face->area * dx * dy;
  }
  crack.angle = 0.5 * std::atan2(2 * xy, xx - yy);
  double low = 0, high = 0;
  for (const CrackFace* face : faces)
    for (int c = 0; c < dimension; ++c) {
      const double along = (face->point[c][0] - crack.centre[0]) * std::cos(crack.angle) +
                           (face->point[c][1] - crack.centre[1]) * std::sin(crack.angle);
      low = std::min(low, along);
      high = std::max(high, along);
    }
  crack.length = high - low;
  return crack;
}

}  // namespace breccia
