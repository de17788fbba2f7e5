#include "scene/initial_velocity.hpp"

#include "base/mat.hpp"

#include <algorithm>

namespace breccia {

namespace {

/// Per point of a body, the piece that it belongs to; the others keep kNone. One piece, or where
/// the body has copies as many as hang together.
template <int D>
std::vector<Index> piece_of_points(const Model<D>& model, Index body, bool copies) {
  const Mesh<D>& mesh = model.mesh;
  std::vector<Index> root(mesh.point.size(), kNone);
  Index any = kNone;
  for (Index e = 0; e < mesh.elements(); ++e)
    if (mesh.body[e] == body)
      for (const Index p : mesh.element[e]) {
        any = any == kNone ? p : any;
        root[p] = copies ? p : any;
      }
  if (!copies) return root;
  const auto find = [&](Index p) {
    while (root[p] != p) p = root[p] = root[root[p]];
    return p;
  };
  for (Index e = 0; e < mesh.elements(); ++e)
    if (mesh.body[e] == body)
      for (const Index p : mesh.element[e]) {
        const Index a = find(mesh.element[e][0]), b = find(p);
        root[std::max(a, b)] = std::min(a, b);
      }
  for (Index p = 0; p < mesh.points(); ++p)
    if (root[p] != kNone) root[p] = find(p);
  return root;
}

/// Centres of mass of the pieces, at the place of their first point.
template <int D>
std::vector<Vec<D>> centres(const Model<D>& model, Index body, const std::vector<Index>& piece) {
  std::vector<Vec<D>> centre(piece.size(), Vec<D>::zero());
  std::vector<double> volume(piece.size(), 0.0);
  for (Index e = 0; e < model.elements(); ++e) {
    if (model.mesh.body[e] != body) continue;
    const auto& nodes = model.mesh.element[e];
    Mat<D> g;
    Vec<D> middle = Vec<D>::zero();
    for (int a = 0; a <= D; ++a)
      for (int d = 0; d < D; ++d) middle[d] += model.mesh.point[nodes[a]][d] / (D + 1);
    for (int j = 0; j < D; ++j)
      for (int d = 0; d < D; ++d)
        g(d, j) = model.mesh.point[nodes[j + 1]][d] - model.mesh.point[nodes[0]][d];
    centre[piece[nodes[0]]] += middle * determinant(g);
    volume[piece[nodes[0]]] += determinant(g);
  }
  for (std::size_t p = 0; p < piece.size(); ++p)
    if (volume[p] > 0) centre[p] *= 1 / volume[p];
  return centre;
}

template <int D>
Vec<3> spin_of(const Settings& body) {
  Vec<3> spin = Vec<3>::zero();
  if (!body.has("spin")) return spin;
  const auto& given = body.vector("spin");
  if (D == 2)
    spin[2] = given[0];
  else
    std::copy_n(given.begin(), 3, spin.v);
  return spin;
}

/// Velocity of a piece whose centre is there.
template <int D>
Vec<D> velocity_of(const Settings& body, const Vec<D>& centre) {
  Vec<D> v = Vec<D>::zero();
  for (int d = 0; d < D && body.has("velocity"); ++d) v[d] = body.vector("velocity")[d];
  if (!body.has("towards")) return v;
  const Settings& towards = body.at("towards");
  Vec<D> way = Vec<D>::zero() - centre;
  for (int d = 0; d < D; ++d) way[d] += towards.vector("place")[d];
  if (norm(way) > 0) v += way * (towards.number("speed") / norm(way));
  return v;
}

}  // namespace

template <int D>
std::vector<double> initial_velocity(const Settings& scene, const Model<D>& model) {
  std::vector<double> velocity;
  for (const Settings& body : scene.list("body")) {
    if (!body.has("velocity") && !body.has("spin") && !body.has("expansion") &&
        !body.has("towards"))
      continue;
    const double expansion = body.has("expansion") ? body.number("expansion") : 0.0;
    velocity.resize(model.mesh.point.size() * D, 0.0);
    const Index number = find_body(model.mesh, body.name());
    const std::vector<Index> piece = piece_of_points(model, number, body.has("copies"));
    const std::vector<Vec<D>> centre = centres(model, number, piece);
    const Vec<3> spin = spin_of<D>(body);
    for (const Index n : find_region(model.mesh, body.name())->points) {
      Vec<3> arm = Vec<3>::zero();
      for (int d = 0; d < D; ++d) arm[d] = model.mesh.point[n][d] - centre[piece[n]][d];
      const Vec<3> turning = cross(spin, arm);
      const Vec<D> whole = velocity_of(body, centre[piece[n]]);
      for (int d = 0; d < D; ++d)
        velocity[static_cast<std::size_t>(n) * D + d] = turning[d] + expansion * arm[d] + whole[d];
    }
  }
  return velocity;
}

template std::vector<double> initial_velocity(const Settings&, const Model<2>&);
template std::vector<double> initial_velocity(const Settings&, const Model<3>&);

}  // namespace breccia
