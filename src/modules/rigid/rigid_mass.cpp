// Nodes, masses and inertia of rigid bodies, and what drives them.
#include "fields/rigid_fields.hpp"
#include "modules/rigid/rigid.hpp"
#include "point/principal.hpp"
#include "point/rigid_motion.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace breccia {

namespace {

/// Nodes that one loop iteration adds up.
constexpr std::size_t kPart = 32;

template <class View>
auto on_host(const View& view) {
  return Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{}, view);
}

const Settings& section_of(const Settings& scene, const std::string& body) {
  const auto& bodies = scene.list("body");
  return *std::find_if(bodies.begin(), bodies.end(),
                       [&](const Settings& section) { return section.name() == body; });
}

template <int D, class View>
Vec<3> in_space(const View& a, Index n) {
  Vec<3> r = Vec<3>::zero();
  for (int d = 0; d < D; ++d) r[d] = a(n, d);
  return r;
}

/// Mass, centre and principal axes of points with masses.
template <int D, class Masses, class Places>
void weigh(const std::vector<Index>& nodes, const Masses& mass, const Places& place,
           RigidBody<D>& body) {
  body.mass = 0;
  Vec<3> first = Vec<3>::zero();
  for (const Index n : nodes) {
    body.mass += mass(n);
    first += in_space<D>(place, n) * mass(n);
  }
  const Vec<3> centre = first * (1 / body.mass);
  for (int d = 0; d < D; ++d) body.origin[d] = centre[d];
  Sym<3> inertia = Sym<3>::zero();
  for (const Index n : nodes) {
    const Vec<3> r = in_space<D>(place, n) - centre;
    for (int i = 0; i < 3; ++i)
      for (int j = i; j < 3; ++j)
        inertia(i, j) += mass(n) * ((i == j ? norm2(r) : 0.0) - r[i] * r[j]);
  }
  body.axes = Mat<3>::identity();
  body.inverse_inertia = Vec<3>::zero();
  if (D == 2) {
    body.inverse_inertia[2] = 1 / inertia(2, 2);
    body.gyration = std::sqrt(inertia(2, 2) / body.mass);
    return;
  }
  const Principal<3> principal = principal_of(inertia);
  body.axes = principal.axes;
  if (determinant(body.axes) < 0)
    for (int i = 0; i < 3; ++i) body.axes(i, 2) = -body.axes(i, 2);
  double least = principal.value[0];
  for (int i = 0; i < 3; ++i) {
    body.inverse_inertia[i] = 1 / principal.value[i];
    least = std::min(least, principal.value[i]);
  }
  body.gyration = std::sqrt(least / body.mass);
}

}  // namespace

template <int D>
std::vector<std::vector<Index>> Rigid<D>::find_nodes(const Model<D>& model) const {
  const auto corner = on_host(model.store.template get<ElementNodes<D>>());
  std::vector<Index> owner(static_cast<std::size_t>(model.nodes()), kNone);
  std::vector<Index> number(model.mesh.body_names.size(), kNone);
  for (std::size_t b = 0; b < bodies_.size(); ++b)
    number[static_cast<std::size_t>(bodies_[b])] = static_cast<Index>(b);
  for (Index e = 0; e < model.elements(); ++e) {
    const Index b = number[static_cast<std::size_t>(model.mesh.body[e])];
    if (b == kNone) continue;
    for (int a = 0; a <= D; ++a) {
      Index& known = owner[static_cast<std::size_t>(corner(e, a))];
      if (known != kNone && known != b) {
        const std::string& other = model.mesh.body_names[static_cast<std::size_t>(bodies_[known])];
        const std::string& body = model.mesh.body_names[static_cast<std::size_t>(bodies_[b])];
        throw section_of(*model.scene, body)
            .error("rigid",
                   fmt::format("'{}' and '{}' are both rigid and share nodes", body, other),
                   "make them one body, or take them out of the same part_of");
      }
      known = b;
    }
  }
  std::vector<std::vector<Index>> nodes(bodies_.size());
  for (Index n = 0; n < model.nodes(); ++n)
    if (owner[static_cast<std::size_t>(n)] != kNone)
      nodes[static_cast<std::size_t>(owner[static_cast<std::size_t>(n)])].push_back(n);
  return nodes;
}

template <int D>
void Rigid<D>::refuse_digging(const Model<D>& model,
                              const std::vector<std::vector<Index>>& nodes) const {
  std::vector<char> dug(model.mesh.point.size(), 0);
  for (const Block& block : model.blocks)
    for (Index e = block.begin; e < block.end && block.excavation != kNone; ++e)
      for (const Index n : model.mesh.element[e]) dug[static_cast<std::size_t>(n)] = 1;
  for (std::size_t b = 0; b < nodes.size(); ++b)
    for (const Index n : nodes[b])
      if (dug[static_cast<std::size_t>(n)] != 0) {
        const std::string& name = model.mesh.body_names[static_cast<std::size_t>(bodies_[b])];
        throw section_of(*model.scene, name)
            .error("rigid", fmt::format("an [[excavate]] reaches '{}' or what holds to it", name),
                   "keep the excavation away from the body's nodes");
      }
}

template <int D>
auto Rigid<D>::drive_of(const Model<D>& model, std::size_t body,
                        const std::vector<Index>& nodes) const -> Drive {
  const auto flags = on_host(model.store.template get<NodeFlags>());
  const std::string& name = model.mesh.body_names[static_cast<std::size_t>(bodies_[body])];
  const auto refuse = [&](const std::string& what, const std::string& remedy) {
    throw section_of(*model.scene, name).error("rigid", what, remedy);
  };
  const std::uint32_t row = ~((1u << node_flag::boundary_shift) - 1);
  const std::uint32_t moved = flags(nodes.front()) & (node_flag::fixed_any | row);
  for (const Index n : nodes) {
    if ((flags(n) & node_flag::absorb) != 0)
      refuse(fmt::format("a face of '{}' lets waves out, but there are no waves in it", name),
             "keep non_reflecting to faces of deformable bodies");
    if ((flags(n) & (node_flag::fixed_any | row)) != moved)
      refuse(fmt::format("a boundary moves or holds a part of '{}' only", name),
             "a rigid body moves as a whole: say where = \"" + name + "\" in that boundary");
  }
  if ((moved & node_flag::fixed_any) == 0) return {};
  return {static_cast<std::int64_t>(moved >> node_flag::boundary_shift),
          static_cast<std::int64_t>(moved & node_flag::fixed_any)};
}

template <int D>
void Rigid<D>::read_turning(const Model<D>& model) {
  laws_.assign(bodies_.size(), {});
  for (const Settings& section : model.scene->list("boundary")) {
    if (!section.has("spin") && !section.has("pivot")) continue;
    const Index body = find_body(model.mesh, section.text("where"));
    const auto found = std::find(bodies_.begin(), bodies_.end(), body);
    RigidBody<D>& law = laws_[static_cast<std::size_t>(found - bodies_.begin())];
    law.pivots = section.has("pivot");
    law.spin = Vec<3>::zero();
    if (!section.has("spin")) continue;
    law.turning = RigidTurning::given;
    const std::vector<double>& spin = section.vector("spin");
    for (std::size_t d = 0; d < spin.size(); ++d)
      law.spin[D == 2 ? 2 : static_cast<int>(d)] = spin[d];
    if (section.has("ramp")) law.ramp.ramp = section.number("ramp");
    law.ramp.begin = static_cast<Index>(tables_.size());
    if (section.has("table"))
      for (const auto& row : section.points("table")) tables_.push_back({row[0], row[1]});
    law.ramp.end = static_cast<Index>(tables_.size());
  }
}

template <int D>
void Rigid<D>::measure(Model<D>& model, const std::vector<std::vector<Index>>& nodes) {
  const auto mass = on_host(model.store.template get<NodeMass>());
  const auto reference = on_host(model.store.template get<NodeReference<D>>());
  const auto origin = Kokkos::create_mirror_view(model.store.template get<RigidOrigin<D>>());
  std::vector<Index> list, body_of_part;
  std::vector<std::array<Index, 2>> parts, parts_of;
  for (std::size_t b = 0; b < nodes.size(); ++b) {
    RigidBody<D>& law = laws_[b];
    weigh(nodes[b], mass, reference, law);
    law.boundary = static_cast<Index>(drives_[b].boundary);
    law.driven = static_cast<std::uint32_t>(drives_[b].components);
    if (law.driven != 0 && law.turning == RigidTurning::free && !law.pivots)
      law.turning = RigidTurning::held;
    for (int d = 0; d < D; ++d) origin(b, d) = law.origin[d];
    const auto first = static_cast<Index>(parts.size());
    for (std::size_t k = 0; k < nodes[b].size(); k += kPart) {
      const auto begin = static_cast<Index>(list.size());
      const std::size_t end = std::min(k + kPart, nodes[b].size());
      list.insert(list.end(), nodes[b].begin() + static_cast<std::ptrdiff_t>(k),
                  nodes[b].begin() + static_cast<std::ptrdiff_t>(end));
      parts.push_back({begin, static_cast<Index>(list.size())});
      body_of_part.push_back(static_cast<Index>(b));
    }
    parts_of.push_back({first, static_cast<Index>(parts.size())});
  }
  Kokkos::deep_copy(model.store.template get<RigidOrigin<D>>(), origin);
  const auto pairs = [](const char* label, const auto& rows) {
    Kokkos::View<typename std::decay_t<decltype(rows)>::value_type::value_type* [2], Rows, Memory>
        view(label, rows.size());
    const auto host = Kokkos::create_mirror_view(view);
    for (std::size_t i = 0; i < rows.size(); ++i)
      for (int j = 0; j < 2; ++j) host(i, j) = rows[i][static_cast<std::size_t>(j)];
    Kokkos::deep_copy(view, host);
    return view;
  };
  force_.list = to_device("breccia::rigid::list", list);
  force_.body = to_device("breccia::rigid::body", body_of_part);
  force_.parts = pairs("breccia::rigid::parts", parts);
  motion_.body = to_device("breccia::rigid::law", laws_);
  motion_.parts_of = pairs("breccia::rigid::parts_of", parts_of);
  motion_.table = pairs("breccia::rigid::table", tables_);
  part_load_ = RigidLoads("breccia::rigid::part_load", parts.size());
}

template <int D>
void Rigid<D>::take_over(Model<D>& model, const std::vector<std::vector<Index>>& nodes) {
  const Store& s = model.store;
  const auto mass = on_host(s.get<NodeMass>());
  const auto x = on_host(s.get<NodePosition<D>>()), v = on_host(s.get<NodeVelocity<D>>());
  const auto centre = on_host(s.get<RigidCentre<D>>());
  const auto velocity = Kokkos::create_mirror_view(s.get<RigidVelocity<D>>());
  const auto momentum = Kokkos::create_mirror_view(s.get<RigidMomentum>());
  const auto spin = Kokkos::create_mirror_view(s.get<RigidSpin>());
  const auto turn = on_host(s.get<RigidTurn>());
  for (std::size_t b = 0; b < nodes.size(); ++b) {
    const RigidBody<D>& law = laws_[b];
    Vec<3> p = Vec<3>::zero(), l = Vec<3>::zero();
    const Vec<3> c = in_space<D>(centre, static_cast<Index>(b));
    for (const Index n : nodes[b]) {
      const Vec<3> mv = in_space<D>(v, n) * mass(n);
      p += mv;
      l += cross(in_space<D>(x, n) - c, mv);
    }
    const Vec<3> mean = p * (1 / law.mass);
    const Mat<3> axes = matrix_of({turn(b, 0), {turn(b, 1), turn(b, 2), turn(b, 3)}}) * law.axes;
    Vec<3> rates = transpose(axes) * l;
    for (int i = 0; i < 3; ++i) rates[i] *= law.inverse_inertia[i];
    const Vec<3> omega = axes * rates;
    for (int d = 0; d < D; ++d) velocity(b, d) = mean[d];
    for (int d = 0; d < 3; ++d) {
      momentum(b, d) = l[d];
      spin(b, d) = omega[d];
    }
    for (const Index n : nodes[b]) {
      const Vec<3> now = mean + cross(omega, in_space<D>(x, n) - c);
      for (int d = 0; d < D; ++d) v(n, d) = now[d];
    }
  }
  Kokkos::deep_copy(s.get<NodeVelocity<D>>(), v);
  Kokkos::deep_copy(s.get<RigidVelocity<D>>(), velocity);
  Kokkos::deep_copy(s.get<RigidMomentum>(), momentum);
  Kokkos::deep_copy(s.get<RigidSpin>(), spin);
}

/// Shared nodes may have split: copies that hold no rigid element any more go their own way, with
/// their mass.
template <int D>
void Rigid<D>::answer_split(Model<D>& model) {
  splits_seen_ = model.splits;
  const auto nodes = find_nodes(model);
  std::vector<char> rigid(static_cast<std::size_t>(model.nodes()), 0);
  Index many = 0;
  for (const auto& list : nodes)
    for (const Index n : list) {
      rigid[static_cast<std::size_t>(n)] = 1;
      ++many;
    }
  const auto flags = on_host(model.store.template get<NodeFlags>());
  bool left = many != static_cast<Index>(force_.list.extent(0));
  for (Index n = 0; n < model.nodes(); ++n) {
    if ((flags(n) & node_flag::rigid) == 0 || rigid[static_cast<std::size_t>(n)] != 0) continue;
    const std::uint32_t low = (1u << node_flag::boundary_shift) - 1;
    flags(n) &= low & ~(node_flag::rigid | node_flag::fixed_any);
    left = true;
  }
  if (!left) return;
  Kokkos::deep_copy(model.store.template get<NodeFlags>(), flags);
  const std::vector<RigidBody<D>> before = laws_;
  measure(model, nodes);
  const auto centre = on_host(model.store.template get<RigidCentre<D>>());
  const auto turn = on_host(model.store.template get<RigidTurn>());
  for (std::size_t b = 0; b < laws_.size(); ++b) {
    const Mat<3> r = matrix_of({turn(b, 0), {turn(b, 1), turn(b, 2), turn(b, 3)}});
    for (int i = 0; i < D; ++i)
      for (int j = 0; j < D; ++j)
        centre(b, i) += r(i, j) * (laws_[b].origin[j] - before[b].origin[j]);
  }
  Kokkos::deep_copy(model.store.template get<RigidCentre<D>>(), centre);
  take_over(model, nodes);
}

template class Rigid<2>;
template class Rigid<3>;

}  // namespace breccia
