#include "mesh/fracture_faces.hpp"

#include "core/log.hpp"
#include "mesh/face_table.hpp"
#include "mesh/geometry.hpp"
#include "mesh/refusal.hpp"
#include "mesh/region_builder.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>

namespace breccia {
namespace {

constexpr double kOnPiece = 1e-6;   // of the extent of the body
constexpr double kCovered = 0.999;  // of a piece
constexpr int kBins = 24;           // per axis

template <int D>
Point<3> lifted(const Point<D>& x) {
  Point<3> y{};
  std::copy(x.begin(), x.end(), y.begin());
  return y;
}

/// Which pieces may be near a place.
class PieceBins {
 public:
  PieceBins(const std::vector<FracturePiece>& pieces, const Point<3>& lower, const Point<3>& upper,
            double tolerance)
      : lower_(lower), bins_(kBins * kBins * kBins) {
    for (int d = 0; d < 3; ++d) width_[d] = std::max(upper[d] - lower[d], tolerance) / kBins;
    for (std::size_t n = 0; n < pieces.size(); ++n) {
      std::array<int, 3> from{}, to{};
      for (int d = 0; d < 3; ++d) {
        double low = 1e300, high = -1e300;
        for (const auto& x : pieces[n]) low = std::min(low, x[d]), high = std::max(high, x[d]);
        from[d] = bin(low - tolerance, d);
        to[d] = bin(high + tolerance, d);
      }
      for (int i = from[0]; i <= to[0]; ++i)
        for (int j = from[1]; j <= to[1]; ++j)
          for (int k = from[2]; k <= to[2]; ++k) bins_[(i * kBins + j) * kBins + k].push_back(n);
    }
  }

  const std::vector<std::size_t>& at(const Point<3>& x) const {
    return bins_[(bin(x[0], 0) * kBins + bin(x[1], 1)) * kBins + bin(x[2], 2)];
  }

 private:
  int bin(double x, int d) const {
    return static_cast<int>(std::clamp((x - lower_[d]) / width_[d], 0.0, kBins - 1.0));
  }
  Point<3> lower_, width_{};
  std::vector<std::vector<std::size_t>> bins_;
};

template <int D>
struct BodyBox {
  Point<3> lower{1e300, 1e300, 1e300}, upper{-1e300, -1e300, -1e300};
  BodyBox(const Mesh<D>& mesh, Index body) {
    for (Index e = 0; e < mesh.elements(); ++e) {
      if (mesh.body[e] != body) continue;
      for (const Index p : mesh.element[e]) {
        const auto x = lifted<D>(mesh.point[p]);
        for (int d = 0; d < 3; ++d) {
          lower[d] = std::min(lower[d], x[d]);
          upper[d] = std::max(upper[d], x[d]);
        }
      }
    }
  }
};

void tell_cover(const std::string& place, const FractureNet& net,
                const std::vector<double>& covered, bool made_for_them) {
  std::size_t trimmed = 0, outside = 0;
  double whole = 0, inside = 0;
  for (std::size_t n = 0; n < net.pieces.size(); ++n) {
    const double all = measure_of(net.pieces[n]);
    whole += all;
    inside += covered[n];
    if (covered[n] >= kCovered * all) continue;
    ++trimmed;
    if (covered[n] == 0) ++outside;
    const std::string piece = "fracture \"" + net.name + "\", piece " + std::to_string(n) +
                              " from " + place_text(net.pieces[n][0]);
    if (!made_for_them)
      refuse(
          place,
          piece + ": only " + short_number(covered[n]) + " of " + short_number(all) +
              " lie on faces of this mesh",
          "let Gmsh mesh the body (no file, no structured generator), or mesh the file along it");
    if (covered[n] == 0 && !net.drawn)
      refuse(place, piece + " does not run through it",
             "move it into the body, or name the body that it crosses");
  }
  if (trimmed == 0) return;
  log::info(place + ": fracture \"" + net.name + "\": " + std::to_string(trimmed) + " of " +
            std::to_string(net.pieces.size()) + " pieces leave the body and are cut off there, " +
            std::to_string(outside) + " are gone; " + short_number(inside) + " of " +
            short_number(whole) + " are left");
}

/// The star of a point: its elements, joined where they share a face that is not cut.
template <int D>
class Stars {
 public:
  Stars(const Mesh<D>& mesh, const Region& region) : mesh_(mesh), root_(mesh.points()) {
    for (const Index p : region.points) root_[p].emplace_back();
    std::set<ElementFace> cut(region.faces.begin(), region.faces.end());
    for (Index e = 0; e < mesh.elements(); ++e)
      for (const Index p : mesh.element[e])
        if (!root_[p].empty()) root_[p].push_back({e, e});
    for_each_face(mesh, [&](std::span<const ElementFace> sides) {
      if (sides.size() != 2 || cut.contains(sides[0]) || cut.contains(sides[1])) return;
      for (int i = 0; i < D; ++i) {
        const Index p = mesh.element[sides[0].element][face_node<D>(sides[0].face, i)];
        if (!root_[p].empty()) join(p, sides[0].element, sides[1].element);
      }
    });
  }

  /// Elements of each part of the star of p, the one with the smallest element first.
  std::vector<std::vector<Index>> parts(Index p) {
    std::vector<std::vector<Index>> parts;
    std::vector<Index> of;
    for (std::size_t i = 1; i < root_[p].size(); ++i) {
      const Index root = find(p, root_[p][i].element);
      const auto at = std::find(of.begin(), of.end(), root) - of.begin();
      if (at == static_cast<std::ptrdiff_t>(of.size())) {
        of.push_back(root);
        parts.emplace_back();
      }
      parts[static_cast<std::size_t>(at)].push_back(root_[p][i].element);
    }
    return parts;
  }

 private:
  struct Link {
    Index element = kNone, up = kNone;
  };

  Link& link(Index p, Index e) {
    return *std::find_if(root_[p].begin() + 1, root_[p].end(),
                         [e](const Link& l) { return l.element == e; });
  }
  Index find(Index p, Index e) {
    while (link(p, e).up != e) e = link(p, e).up;
    return e;
  }
  void join(Index p, Index a, Index b) {
    a = find(p, a);
    b = find(p, b);
    link(p, std::max(a, b)).up = std::min(a, b);
  }

  const Mesh<D>& mesh_;
  std::vector<std::vector<Link>> root_;  ///< empty but for points of the region; the first is idle
};

/// Region lists after elements got new points.
template <int D>
void renew_regions(Mesh<D>& mesh, const std::vector<ElementFace>& surface) {
  for (Region& region : mesh.regions) {
    RegionBuilder<D> builder;
    for (const Index p : region.points) builder.add_point(p);
    for (const Index e : region.elements) builder.add_element(mesh, e);
    for (const ElementFace& face : region.faces) builder.add_face(mesh, face);
    const Index body = find_body(mesh, region.name);
    for (const ElementFace& face : surface)
      if (mesh.body[face.element] == body) builder.add_face(mesh, face);
    region = builder.finish(region.name);
  }
}

}  // namespace

template <int D>
void add_fracture_region(Mesh<D>& mesh, Index body, const FractureNet& net, bool made_for_them) {
  const BodyBox<D> box(mesh, body);
  const double tolerance = kOnPiece * length(minus(box.upper, box.lower));
  const PieceBins bins(net.pieces, box.lower, box.upper, tolerance);
  std::vector<double> covered(net.pieces.size(), 0.0);
  RegionBuilder<D> builder;
  for_each_face(mesh, [&](std::span<const ElementFace> sides) {
    if (sides.size() != 2) return;
    const bool first = mesh.body[sides[0].element] == body;
    if (!first && mesh.body[sides[1].element] != body) return;
    const ElementFace& face = first ? sides[0] : sides[1];
    std::array<Point<3>, D> x;
    for (int i = 0; i < D; ++i)
      x[i] = lifted<D>(mesh.point[mesh.element[face.element][face_node<D>(face.face, i)]]);
    for (const std::size_t n : bins.at(x[0])) {
      const bool on = std::all_of(x.begin(), x.end(), [&](const Point<3>& y) {
        return distance_to(net.pieces[n], y) <= tolerance;
      });
      if (!on) continue;
      covered[n] += measure_of(FracturePiece(x.begin(), x.end()));
      builder.add_face(mesh, face);
      break;
    }
  });
  const std::string& name = mesh.body_names[body];
  tell_cover("body \"" + name + "\"", net, covered, made_for_them);
  mesh.regions.push_back(builder.finish(name + "." + net.name));
}

template <int D>
void cut_open(Mesh<D>& mesh, const std::string& name) {
  const Region region = *find_region(mesh, name);
  std::vector<ElementFace> surface;
  const std::set<ElementFace> cut(region.faces.begin(), region.faces.end());
  for_each_face(mesh, [&](std::span<const ElementFace> sides) {
    if (sides.size() != 2 || (!cut.contains(sides[0]) && !cut.contains(sides[1]))) return;
    surface.insert(surface.end(), sides.begin(), sides.end());
  });
  Stars<D> stars(mesh, region);
  const auto old = mesh.element;
  std::set<Index> changed;
  for (const Index p : region.points) {
    const auto parts = stars.parts(p);
    for (std::size_t n = 1; n < parts.size(); ++n) {
      const auto fresh = static_cast<Index>(mesh.point.size());
      mesh.point.push_back(mesh.point[p]);
      for (const Index e : parts[n]) {
        std::replace(mesh.element[e].begin(), mesh.element[e].end(), p, fresh);
        changed.insert(e);
      }
    }
  }
  for (const Index e : changed)
    for (int a = 0; a <= D; ++a)
      for (int b = 0; b < a; ++b) {
        const auto found = mesh.curved.find(edge_of(old[e][a], old[e][b]));
        if (found != mesh.curved.end())
          mesh.curved[edge_of(mesh.element[e][a], mesh.element[e][b])] = Point<D>(found->second);
      }
  // A face between points of the rim alone has not opened.
  const auto points_of = [&mesh](const ElementFace& face) {
    std::set<Index> points;
    for (int i = 0; i < D; ++i)
      points.insert(mesh.element[face.element][face_node<D>(face.face, i)]);
    return points;
  };
  std::vector<ElementFace> opened;
  for (std::size_t i = 0; i < surface.size(); i += 2) {
    if (points_of(surface[i]) == points_of(surface[i + 1])) continue;
    opened.insert(opened.end(), {surface[i], surface[i + 1]});
  }
  renew_regions(mesh, opened);
}

template void add_fracture_region<2>(Mesh<2>&, Index, const FractureNet&, bool);
template void add_fracture_region<3>(Mesh<3>&, Index, const FractureNet&, bool);
template void cut_open<2>(Mesh<2>&, const std::string&);
template void cut_open<3>(Mesh<3>&, const std::string&);

}  // namespace breccia
