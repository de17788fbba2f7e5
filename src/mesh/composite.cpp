#include "mesh/composite.hpp"

#include "base/composite.hpp"
#include "core/log.hpp"
#include "mesh/geometry.hpp"
#include "mesh/order.hpp"

#include <algorithm>
#include <stdexcept>

namespace breccia {
namespace {

constexpr int kMostNodes = 11;

/// A sub-element smaller than this part of its share would set the time step for all others.
constexpr double kLeastShare = 0.1;

/// Diagonals that differ by less are equal but for rounding.
constexpr double kEqualLengths = 1e-9;

/// The tables of base/composite.hpp with the group as an argument.
template <int D>
int node_of(int group, int sub, int corner) {
  if constexpr (D == 2) return composite_node<2, 4>(sub, corner);
  if constexpr (D == 3) {
    return group == 8 ? composite_node<3, 8>(sub, corner) : composite_node<3, 12>(sub, corner);
  }
}

template <int D>
int nodes_of(int group) {
  if constexpr (D == 2) return composite_nodes<2, 4>;
  if constexpr (D == 3) return group == 8 ? composite_nodes<3, 8> : composite_nodes<3, 12>;
}

template <int D>
constexpr int kMiddlesEnd = D == 2 ? 6 : 10;

/// Whether a node of the composite lies on the face opposite vertex `face`.
template <int D>
bool on_face(int node, int face) {
  if (node <= D) return node != face;
  if (node >= kMiddlesEnd<D>) return false;
  return composite_edge<D>(node, 0) != face && composite_edge<D>(node, 1) != face;
}

/// Where the nodes of one composite are.
template <int D>
using Places = std::array<Point<D>, kMostNodes>;

/// Volume of the smallest sub-element, in shares of the straight composite.
template <int D>
double least_share(const Places<D>& x, int group) {
  Simplex<D> parent;
  std::copy_n(x.begin(), D + 1, parent.begin());
  const double whole = signed_volume<D>(parent);
  double least = 1;
  for (int sub = 0; sub < group; ++sub) {
    Simplex<D> piece;
    for (int a = 0; a <= D; ++a) piece[a] = x[node_of<D>(group, sub, a)];
    const double straight = D == 2 ? 4 : (group == 12 && sub > D ? 16 : 8);
    const double share = signed_volume<D>(piece) * straight / whole;
    if (!(share >= least)) least = share;
  }
  return least;
}

/// Cuts the elements of a mesh that it copies.
template <int D>
class Refiner {
 public:
  Refiner(const Mesh<D>& from, std::span<const int> group_size)
      : from_(from), group_(group_size), curved_(from.curved) {
    if (group_size.size() != from.body_names.size() || !from.group_size.empty()) {
      throw std::logic_error("refined_to_composites: one group size per body of a simple mesh");
    }
    number_edges();
    for (Index e = 0; e < from_.elements(); ++e) {
      vertices_.push_back(from_.element[e]);
      turn(e);
    }
    straighten_where_needed();
    place_points();
    for (Index e = 0; e < from_.elements(); ++e) cut(e);
    to_.fields = fields_of(from_.fields, whole_);
    for (const Region& region : from_.regions) refine(region);
    to_.body_names = from_.body_names;
    to_.group_size.assign(group_size.begin(), group_size.end());
  }

  Mesh<D> result() { return reordered(to_, first_use_order(to_)); }

 private:
  int group(Index e) const { return group_[from_.body[e]]; }

  Edge edge(Index e, int node) const {
    return edge_of(vertices_[e][composite_edge<D>(node, 0)],
                   vertices_[e][composite_edge<D>(node, 1)]);
  }

  void number_edges() {
    for (Index e = 0; e < from_.elements(); ++e) {
      if (group(e) == 1) continue;
      for (int a = 0; a <= D; ++a) {
        for (int b = 0; b < a; ++b) {
          edges_.push_back(edge_of(from_.element[e][a], from_.element[e][b]));
        }
      }
    }
    std::sort(edges_.begin(), edges_.end());
    edges_.erase(std::unique(edges_.begin(), edges_.end()), edges_.end());
  }

  Point<D> middle(const Edge& edge) const {
    if (!curved_.empty()) {
      const auto found = curved_.find(edge);
      if (found != curved_.end()) return found->second;
    }
    Point<D> x;
    for (int k = 0; k < D; ++k) {
      x[k] = 0.5 * (from_.point[edge[0]][k] + from_.point[edge[1]][k]);
    }
    return x;
  }

  Places<D> places(Index e) const {
    Places<D> x{};
    for (int a = 0; a <= D; ++a) x[a] = from_.point[vertices_[e][a]];
    for (int m = D + 1; m < kMiddlesEnd<D>; ++m) {
      x[m] = middle(edge(e, m));
      if (D == 3) x[kMiddlesEnd<D>] = along(x[kMiddlesEnd<D>], 1.0 / 6, x[m]);
    }
    return x;
  }

  /// Turns the vertices so that m01-m23 is the shortest diagonal of the octahedron.
  void turn(Index e) {
    if constexpr (D == 3) {
      if (group(e) != 8) return;
      auto& v = vertices_[e];
      const auto given = v;
      // The two edges of each diagonal; positive turns that put the pair first.
      constexpr int turns[3][4] = {{0, 1, 2, 3}, {0, 2, 3, 1}, {0, 3, 1, 2}};
      double shortest = 0;
      Edge smallest{};
      for (const auto& t : turns) {
        const Edge one = edge_of(given[t[0]], given[t[1]]);
        const Edge other = edge_of(given[t[2]], given[t[3]]);
        const double size = length(minus(middle(one), middle(other)));
        const Edge first = std::min(one, other);
        const bool equal = std::abs(size - shortest) <= kEqualLengths * shortest;
        if (shortest > 0 && (equal ? first > smallest : size > shortest)) continue;
        shortest = size;
        smallest = first;
        for (int a = 0; a <= D; ++a) v[a] = given[t[a]];
      }
    }
  }

  void straighten_where_needed() {
    std::size_t straightened = 0;
    for (bool again = !curved_.empty(); again;) {
      again = false;
      for (Index e = 0; e < from_.elements(); ++e) {
        if (group(e) == 1 || least_share<D>(places(e), group(e)) >= kLeastShare) continue;
        std::size_t here = 0;
        for (int m = D + 1; m < kMiddlesEnd<D>; ++m) here += curved_.erase(edge(e, m));
        straightened += here;
        again = again || here > 0;
        turn(e);
      }
    }
    if (straightened == 0) return;
    log::info(std::to_string(straightened) +
              " curved edges are made straight: their composites would be too thin. A smaller "
              "mesh.size follows the boundary");
  }

  void place_points() {
    to_.point = from_.point;
    for (const Edge& edge : edges_) to_.point.push_back(middle(edge));
  }

  void cut(Index e) {
    first_.push_back(to_.elements());
    const int pieces = group(e);
    for (int sub = 0; sub < pieces; ++sub) {
      to_.body.push_back(from_.body[e]);
      whole_.push_back(e);
    }
    if (pieces == 1) {
      to_.element.push_back(vertices_[e]);
      return;
    }
    const auto node = numbers(e);
    if (pieces == 12) to_.point.push_back(places(e)[kMiddlesEnd<D>]);
    for (int sub = 0; sub < pieces; ++sub) {
      auto& nodes = to_.element.emplace_back();
      for (int a = 0; a <= D; ++a) nodes[a] = node[node_of<D>(pieces, sub, a)];
    }
  }

  /// Points of the composite about to be added; the node inside is the next new one.
  std::array<Index, kMostNodes> numbers(Index e) const {
    std::array<Index, kMostNodes> node{};
    for (int a = 0; a <= D; ++a) node[a] = vertices_[e][a];
    for (int m = D + 1; m < kMiddlesEnd<D>; ++m) node[m] = point_of(edge(e, m));
    node[kMiddlesEnd<D>] = to_.points();
    return node;
  }

  Index point_of(const Edge& edge) const {
    const auto place = std::lower_bound(edges_.begin(), edges_.end(), edge);
    return from_.points() + static_cast<Index>(place - edges_.begin());
  }

  void refine(const Region& region) {
    Region out{region.name, {}, {}, region.points};
    for (Index e : region.elements) {
      for (int sub = 0; sub < group(e); ++sub) {
        out.elements.push_back(first_[e] + sub);
        for (Index p : to_.element[first_[e] + sub]) out.points.push_back(p);
      }
    }
    for (const ElementFace& side : region.faces) refine_face(side, out);
    if (D == 3 && region.elements.empty() && region.faces.empty()) refine_curve(region, out);
    to_.regions.push_back(std::move(out));
  }

  void refine_face(const ElementFace& side, Region& out) {
    const Index e = side.element;
    if (group(e) == 1) {
      out.faces.push_back({first_[e], side.face});
      return;
    }
    const Index opposite = from_.element[e][side.face];
    const auto vertex = std::find(vertices_[e].begin(), vertices_[e].end(), opposite);
    const int face = static_cast<int>(vertex - vertices_[e].begin());
    for (int sub = 0; sub < group(e); ++sub) {
      for (int f = 0; f <= D; ++f) {
        bool on = true;
        for (int i = 0; i < D; ++i) {
          on = on && on_face<D>(node_of<D>(group(e), sub, face_node<D>(f, i)), face);
        }
        if (!on) continue;
        out.faces.push_back({first_[e] + sub, f});
        for (int i = 0; i < D; ++i) {
          out.points.push_back(to_.element[first_[e] + sub][face_node<D>(f, i)]);
        }
      }
    }
  }

  void refine_curve(const Region& region, Region& out) {
    std::vector<char> on(from_.point.size(), 0);
    for (Index p : region.points) on[p] = 1;
    for (const Edge& edge : edges_) {
      if (on[edge[0]] && on[edge[1]]) out.points.push_back(point_of(edge));
    }
  }

  const Mesh<D>& from_;
  std::span<const int> group_;
  std::map<Edge, Point<D>> curved_;
  std::vector<Edge> edges_;                         ///< of composites, sorted
  std::vector<std::array<Index, D + 1>> vertices_;  ///< of each element, turned
  std::vector<Index> first_;                        ///< first piece of each element
  std::vector<Index> whole_;                        ///< element of each piece
  Mesh<D> to_;
};

}  // namespace

template <int D>
Mesh<D> refined_to_composites(Mesh<D> mesh, std::span<const int> group_size) {
  if (std::all_of(group_size.begin(), group_size.end(), [](int g) { return g == 1; })) return mesh;
  return Refiner<D>(mesh, group_size).result();
}

template <int D>
std::vector<Index> composite_of_elements(const Mesh<D>& mesh) {
  std::vector<Index> composite(mesh.element.size());
  Index count = 0;
  for (Index e = 0; e < mesh.elements(); ++count) {
    const Index end = e + mesh.group_of_body(mesh.body[e]);
    while (e < end) composite[e++] = count;
  }
  return composite;
}

template Mesh<2> refined_to_composites<2>(Mesh<2>, std::span<const int>);
template Mesh<3> refined_to_composites<3>(Mesh<3>, std::span<const int>);
template std::vector<Index> composite_of_elements<2>(const Mesh<2>&);
template std::vector<Index> composite_of_elements<3>(const Mesh<3>&);

}  // namespace breccia
