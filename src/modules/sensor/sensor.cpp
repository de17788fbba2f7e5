#include "modules/sensor/sensor.hpp"

#include "base/mat.hpp"
#include "loops/sampling.hpp"
#include "mesh/geometry.hpp"
#include "step/selection.hpp"
#include "step/stress_view.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <map>

namespace breccia {

namespace {

constexpr std::string_view kAxes = "xyz";

/// Barycentric coordinates of `p` in an element of the reference mesh.
template <int D>
std::array<double, D + 1> barycentric(const Mesh<D>& mesh, Index element,
                                      const std::vector<double>& p) {
  const auto& nodes = mesh.element[element];
  Mat<D> g;
  Vec<D> from_first;
  for (int i = 0; i < D; ++i) {
    from_first[i] = p[i] - mesh.point[nodes[0]][i];
    for (int j = 0; j < D; ++j) g(i, j) = mesh.point[nodes[j + 1]][i] - mesh.point[nodes[0]][i];
  }
  const Vec<D> rest = inverse(g) * from_first;
  std::array<double, D + 1> bary{};
  bary[0] = 1;
  for (int j = 0; j < D; ++j) {
    bary[j + 1] = rest[j];
    bary[0] -= rest[j];
  }
  return bary;
}

template <int D>
Sym<D> stress_at(const Model<D>& model, Index element, const std::vector<double>& shares) {
  const Store& s = model.store;
  StressPoint<D> at{element, {}};
  for (int a = 0; a <= D; ++a) at.shares[a] = shares[static_cast<std::size_t>(a)];
  return sample_stress(stress_of(model), s.get<NodeCorners>(), s.get<CornerList>(), at);
}

}  // namespace

template <int D>
void Sensor<D>::bind(Model<D>& model) {
  resume(model);
}

template <int D>
void Sensor<D>::resume(Model<D>& model) {
  probes_.clear();
  splits_ = -1;
  for (const Settings& section : model.scene->list("sensor")) {
    if (section.has("point"))
      probes_.push_back(point(model, section));
    else if (section.has("surface"))
      probes_.push_back(surface(model, section));
    else
      probes_.push_back(reaction(model, section));
  }
}

template <int D>
auto Sensor<D>::point(const Model<D>& model, const Settings& section) const -> Probe {
  const std::vector<double>& at = section.vector("point");
  Probe probe{section.name(), Kind::point, kNone, {}, {}, {}, {}};
  double deepest = -std::numeric_limits<double>::infinity();
  for (Index e = 0; e < model.elements(); ++e) {
    if (!model.part.owns_element(e)) continue;
    const auto bary = barycentric(model.mesh, e, at);
    const double depth = *std::min_element(bary.begin(), bary.end());
    if (depth > deepest) {
      deepest = depth;
      probe.element = e;
      probe.shares.assign(bary.begin(), bary.end());
    }
  }
  const double inside = model.part.largest(deepest);
  if (inside < -1e-6)
    throw section.error("point", "the point lies in no body",
                        "move it into a body; `breccia check` prints the extent of every body");
  // Of elements as deep the first of the whole mesh has the point; its owner speaks for it.
  const double number = deepest == inside ? model.part.element_number(probe.element)
                                          : std::numeric_limits<double>::infinity();
  if (number != model.part.least(number)) {
    probe.element = kNone;
    probe.shares.clear();
    return probe;
  }
  const auto& nodes = model.mesh.element[probe.element];
  probe.families.assign(nodes.begin(), nodes.end());
  return probe;
}

/// Share of each point of a region in its mean: by volume in a body, by area on a surface. Points
/// of other ranks are left out.
template <int D>
std::map<Index, double> shares_of(const Region& region, const Mesh<D>& mesh, const Part& part) {
  std::map<Index, double> share;
  for (const Index n : region.points) share[n] = 0;
  for (const Index e : region.elements)
    for (const Index n : mesh.element[e]) share[n] += signed_volume<D>(corners(mesh, e));
  if (region.elements.empty())
    for (const ElementFace& f : region.faces)
      for (int j = 0; j < D; ++j)
        share[mesh.element[f.element][face_node<D>(f.face, j)]] +=
            length(face_normal_area<D>(corners(mesh, f.element), f.face));
  for (auto at = share.begin(); at != share.end();)
    at = part.owns_family(at->first) ? std::next(at) : share.erase(at);
  double total = 0;
  for (const auto& [n, s] : share) total += s;
  total = part.sum(total);
  const double points = part.sum(static_cast<double>(share.size()));
  for (auto& [n, s] : share) s = total > 0 ? s / total : 1.0 / points;
  return share;
}

template <int D>
auto Sensor<D>::surface(const Model<D>& model, const Settings& section) const -> Probe {
  const Region& region = named_region(section, "surface", section.text("surface"), model.mesh);
  Probe probe{section.name(), Kind::surface, kNone, {}, {}, {}, {}};
  for (const auto& [point, share] : shares_of(region, model.mesh, model.part)) {
    probe.families.push_back(point);
    probe.shares.push_back(share);
  }
  return probe;
}

template <int D>
auto Sensor<D>::reaction(const Model<D>& model, const Settings& section) const -> Probe {
  const std::string& name = section.text("reaction");
  Probe probe{section.name(), Kind::reaction, kNone, {}, {}, {}, {}};
  for (const Settings& boundary : model.scene->list("boundary")) {
    const bool named = boundary.has("name") && boundary.text("name") == name;
    if (!named && !(boundary.has("where") && boundary.text("where") == name)) continue;
    const Region region = select_region(boundary, model.mesh, model.topology);
    probe.families.insert(probe.families.end(), region.points.begin(), region.points.end());
  }
  if (probe.families.empty())
    probe.families = named_region(section, "reaction", name, model.mesh).points;
  std::sort(probe.families.begin(), probe.families.end());
  probe.families.erase(std::unique(probe.families.begin(), probe.families.end()),
                       probe.families.end());
  const auto flags = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{},
                                                         model.store.template get<NodeFlags>());
  const bool held = std::any_of(probe.families.begin(), probe.families.end(),
                                [&](Index n) { return (flags(n) & node_flag::fixed_any) != 0; });
  if (!held && !model.mesh.partial)
    throw section.error("reaction",
                        fmt::format("nothing holds or moves '{}', so it has no reaction", name),
                        "name a [[boundary]] with `velocity` or `fixed`, or a body that has one");
  const auto others = [&](Index n) { return !model.part.owns_family(n); };
  probe.families.erase(std::remove_if(probe.families.begin(), probe.families.end(), others),
                       probe.families.end());
  probe.shares.assign(probe.families.size(), 1.0);
  return probe;
}

template <int D>
void Sensor<D>::place_at_corners(const Model<D>& model, Probe& probe) const {
  const auto nodes = Kokkos::create_mirror_view_and_copy(
      Kokkos::HostSpace{}, model.store.template get<ElementNodes<D>>());
  std::vector<Index> list;
  for (int a = 0; a <= D && probe.element != kNone; ++a) list.push_back(nodes(probe.element, a));
  probe.nodes = to_device("breccia::sensor::nodes", list);
  probe.weights = to_device("breccia::sensor::weights", probe.shares);
}

template <int D>
void Sensor<D>::find_copies(const Model<D>& model) {
  if (splits_ == model.splits) return;
  splits_ = model.splits;
  const auto family = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{},
                                                          model.store.template get<NodeFamily>());
  const auto mass = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{},
                                                        model.store.template get<NodeMass>());
  std::vector<std::vector<Index>> copies(model.mesh.point.size());
  for (Index n = 0; n < model.nodes(); ++n) copies[family(n)].push_back(n);
  for (Probe& probe : probes_) {
    if (probe.kind == Kind::point) {
      place_at_corners(model, probe);
      continue;
    }
    std::vector<Index> list;
    std::vector<double> weights;
    for (std::size_t i = 0; i < probe.families.size(); ++i) {
      // A point that has split hands its share on to its copies, by their masses.
      double whole = 0;
      for (const Index n : copies[probe.families[i]]) whole += mass(n);
      for (const Index n : copies[probe.families[i]]) {
        list.push_back(n);
        weights.push_back(probe.kind == Kind::reaction ? 1.0 : probe.shares[i] * mass(n) / whole);
      }
    }
    probe.nodes = to_device("breccia::sensor::nodes", list);
    probe.weights = to_device("breccia::sensor::weights", weights);
  }
}

template <int D>
void Sensor<D>::observe(Model<D>& model, const Clock& clock, Moment moment, Row& row) {
  if (moment == Moment::before) find_copies(model);
  for (const Probe& probe : probes_) {
    if (moment == Moment::before)
      before(model, probe, row);
    else
      after(model, probe, clock, row);
  }
}

template <int D>
void Sensor<D>::before(Model<D>& model, const Probe& probe, Row& row) const {
  const Store& s = model.store;
  if (probe.kind == Kind::reaction) {
    for (int d = 0; d < D; ++d) row.set(probe.name + "." + kAxes[d], 0, Merge::sum);
    return;
  }
  const Vec<D> u = sample<D>(s.get<NodePosition<D>>(), probe.nodes, probe.weights) -
                   sample<D>(s.get<NodeReference<D>>(), probe.nodes, probe.weights);
  const Vec<D> v = sample<D>(s.get<NodeVelocity<D>>(), probe.nodes, probe.weights);
  for (int d = 0; d < D; ++d) row.set(probe.name + ".u" + kAxes[d], u[d], Merge::sum);
  for (int d = 0; d < D; ++d) row.set(probe.name + ".v" + kAxes[d], v[d], Merge::sum);
  if (probe.kind != Kind::point) return;
  const Sym<D> sigma =
      probe.element == kNone ? Sym<D>::zero() : stress_at(model, probe.element, probe.shares);
  for (int i = 0; i < D; ++i)
    for (int j = i; j < D; ++j)
      row.set(probe.name + ".s" + kAxes[i] + kAxes[j], sigma(i, j), Merge::sum);
}

template <int D>
void Sensor<D>::after(Model<D>& model, const Probe& probe, const Clock& clock, Row& row) const {
  const Store& s = model.store;
  if (probe.kind == Kind::reaction) {
    const Vec<D> force = sample<D>(s.get<NodeReaction<D>>(), probe.nodes, probe.weights);
    for (int d = 0; d < D; ++d) row.set(probe.name + "." + kAxes[d], force[d]);
    return;
  }
  const Vec<D> v = sample<D>(s.get<NodeVelocity<D>>(), probe.nodes, probe.weights);
  // v at t^n lies between the two half steps in the ratio of their lengths: at the start it is the
  // velocity before the kick, at the end of the run the one after.
  const double before_kick = clock.dt / (clock.dt_before + clock.dt);
  for (int d = 0; d < D; ++d) {
    const std::string column = probe.name + ".v" + kAxes[d];
    row.set(column, before_kick * row.get(column) + (1 - before_kick) * v[d]);
  }
}

template class Sensor<2>;
template class Sensor<3>;

}  // namespace breccia
