#include "scene/fragments.hpp"

#include "base/mat.hpp"
#include "base/views.hpp"
#include "core/disjoint_sets.hpp"
#include "point/principal.hpp"

#include <algorithm>
#include <cmath>

namespace breccia {

namespace {

/// The smallest element of each connected piece, for every element.
template <int D>
std::vector<Index> roots(const Model<D>& model) {
  DisjointSets pieces(model.mesh.element.size());
  std::vector<std::uint8_t> broken(model.topology.shared.size(), 0);
  if (model.store.template has<FaceStatus>()) {
    const auto status =
        to_host(model.store.template get<FaceStatus>(), model.store.count(Entity::face));
    const auto ends = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{},
                                                          model.store.template get<FaceElements>());
    // Faces of the store may be fewer than those of the mesh: the others can never break.
    std::vector<std::pair<std::pair<Index, Index>, std::uint8_t>> released;
    for (std::size_t f = 0; f < status.size(); ++f)
      if (status[f] == face_status::released)
        released.push_back({{ends(f, 0), ends(f, 1)}, status[f]});
    std::sort(released.begin(), released.end());
    for (std::size_t f = 0; f < broken.size(); ++f) {
      const SharedFace& face = model.topology.shared[f];
      const auto key = std::make_pair(std::make_pair(face.left, face.right), std::uint8_t{0});
      const auto found = std::lower_bound(released.begin(), released.end(), key);
      broken[f] = found != released.end() && found->first == key.first;
    }
  }
  for (std::size_t f = 0; f < broken.size(); ++f)
    if (!broken[f]) pieces.join(model.topology.shared[f].left, model.topology.shared[f].right);
  std::vector<Index> root(model.mesh.element.size());
  for (std::size_t e = 0; e < root.size(); ++e) root[e] = pieces.root(static_cast<Index>(e));
  return root;
}

/// Sums over the elements of a piece. Positions and velocities are linear in each, so that a
/// product of two has the integral m / ((D+1)(D+2)) (sum_a f_a g_a + sum_a f_a sum_b g_b).
template <int D>
struct Moments {
  double mass = 0;
  Vec<D> place = Vec<D>::zero(), velocity = Vec<D>::zero();  ///< kg m, kg m/s
  Mat<D> second = Mat<D>::zero();                            ///< x x, kg m2
  Mat<D> turning = Mat<D>::zero();                           ///< x v, kg m2/s

  void add(double m, const Vec<D> (&x)[D + 1], const Vec<D> (&v)[D + 1]) {
    Vec<D> sum_x = Vec<D>::zero(), sum_v = Vec<D>::zero();
    for (int a = 0; a <= D; ++a) {
      sum_x += x[a];
      sum_v += v[a];
    }
    mass += m;
    place += sum_x * (m / (D + 1));
    velocity += sum_v * (m / (D + 1));
    const double share = m / ((D + 1) * (D + 2));
    for (int i = 0; i < D; ++i)
      for (int j = 0; j < D; ++j) {
        for (int a = 0; a <= D; ++a) {
          second(i, j) += share * x[a][i] * x[a][j];
          turning(i, j) += share * x[a][i] * v[a][j];
        }
        second(i, j) += share * sum_x[i] * sum_x[j];
        turning(i, j) += share * sum_x[i] * sum_v[j];
      }
  }

  void describe(Fragments::Piece& piece) const {
    Sym<D> spread;  // about the centre of mass
    for (int i = 0; i < D; ++i) {
      piece.place[i] = place[i] / mass;
      piece.velocity[i] = velocity[i] / mass;
      for (int j = i; j < D; ++j) spread(i, j) = second(i, j) - place[i] * place[j] / mass;
    }
    const Principal<D> axes = principal_of(spread);
    double most = axes.value[0], least = axes.value[0];
    for (int i = 1; i < D; ++i) {
      most = std::max(most, axes.value[i]);
      least = std::min(least, axes.value[i]);
    }
    piece.length = std::sqrt(12 * std::max(0.0, most) / mass);  // m L^2 / 12 along an edge
    piece.width = std::sqrt(12 * std::max(0.0, least) / mass);
    const auto angular = [&](int i, int j) {
      return turning(i, j) - turning(j, i) -
             (place[i] * velocity[j] - place[j] * velocity[i]) / mass;
    };
    if constexpr (D == 2) {
      piece.spin[2] = angular(0, 1) / trace(spread);
    } else {
      Mat<D> inertia;
      for (int i = 0; i < D; ++i)
        for (int j = 0; j < D; ++j) inertia(i, j) = (i == j ? trace(spread) : 0) - spread(i, j);
      const Vec<D> spin = inverse(inertia) * Vec<D>{angular(1, 2), angular(2, 0), angular(0, 1)};
      for (int d = 0; d < D; ++d) piece.spin[d] = spin[d];
    }
  }
};

}  // namespace

template <int D>
Fragments find_fragments(const Model<D>& model) {
  const std::vector<Index> root = roots(model);
  const auto x = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{},
                                                     model.store.template get<NodePosition<D>>());
  const auto v = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{},
                                                     model.store.template get<NodeVelocity<D>>());
  const auto nodes = Kokkos::create_mirror_view_and_copy(
      Kokkos::HostSpace{}, model.store.template get<ElementNodes<D>>());
  const auto reference = Kokkos::create_mirror_view_and_copy(
      Kokkos::HostSpace{}, model.store.template get<ElementReference<D>>());

  std::vector<Fragments::Piece> pieces(root.size());
  std::vector<Moments<D>> moments(root.size());
  for (Index e = 0; e < model.elements(); ++e) {
    Mat<D> inverse_edges;
    for (int i = 0; i < D; ++i)
      for (int j = 0; j < D; ++j) inverse_edges(i, j) = reference(e, i, j);
    const double volume = model.thickness / (determinant(inverse_edges) * (D == 2 ? 2 : 6));
    const double mass = volume * model.material_of_body(model.mesh.body[e]).density;
    Fragments::Piece& piece = pieces[root[e]];
    ++piece.elements;
    piece.mass += mass;
    piece.volume += volume;
    Vec<D> at[D + 1], moving[D + 1];
    for (int a = 0; a <= D; ++a) {
      at[a] = row<D>(x, nodes(e, a));
      moving[a] = row<D>(v, nodes(e, a));
    }
    moments[root[e]].add(mass, at, moving);
  }
  std::vector<Index> order;
  for (std::size_t r = 0; r < pieces.size(); ++r)
    if (pieces[r].elements > 0) order.push_back(static_cast<Index>(r));
  std::stable_sort(order.begin(), order.end(),
                   [&](Index a, Index b) { return pieces[a].mass > pieces[b].mass; });

  Fragments out;
  std::vector<Index> number(pieces.size(), kNone);
  for (const Index r : order) {
    number[r] = static_cast<Index>(out.pieces.size());
    Fragments::Piece piece = pieces[r];
    moments[r].describe(piece);
    out.pieces.push_back(piece);
  }
  out.of_element.resize(root.size());
  for (std::size_t e = 0; e < root.size(); ++e) out.of_element[e] = number[root[e]];
  return out;
}

template Fragments find_fragments(const Model<2>&);
template Fragments find_fragments(const Model<3>&);

}  // namespace breccia
