#include "modules/boundary/boundary.hpp"

#include "step/selection.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace breccia {

namespace {

bool is_motion(const Settings& section) {
  return section.has("velocity") || section.has("fixed") || section.has("symmetry");
}

/// Whether some section loads faces; a part of the mesh may have none of them.
bool presses(const Settings& scene) {
  const auto& sections = scene.list("boundary");
  return std::any_of(sections.begin(), sections.end(),
                     [](const Settings& section) { return !is_motion(section); });
}

}  // namespace

template <int D>
void Boundary<D>::declare(Model<D>& model) {
  read(model);
  Index rows = 0;
  if (moves_) {
    std::vector<Index> row_of_node;
    make_rows(row_of_node);
    rows = static_cast<Index>(rows_.size());
  }
  model.store.set_size(Entity::boundary, rows, rows);
  if (moves_) {
    model.store.template add<BoundaryVelocity<D>>(key());
    model.store.template add<NodeReaction<D>>(key());
  }
  if (loads_) model.store.template add<LoadForce<D>>(key());
  if (absorbing_.empty()) return;
  std::set<Index> elements;
  for (const auto& [face, law] : absorbing_) elements.insert(face.element);
  const auto absorbers = static_cast<Index>(elements.size());
  model.store.set_size(Entity::absorber, absorbers, absorbers);
  model.store.template add<ElementAbsorber>(key());
  model.store.template add<AbsorberDamping<D>>(key());
}

template <int D>
void Boundary<D>::read(const Model<D>& model) {
  node_sources_.assign(model.mesh.point.size(), Sources{});
  for (Sources& s : node_sources_) s.fill(kNone);
  read_laws(model);
  const std::vector<Settings>& sections = model.scene->list("boundary");
  for (std::size_t i = 0; i < sections.size(); ++i) {
    const Region region = select_region(sections[i], model.mesh, model.topology);
    const auto law = static_cast<Index>(i);
    if (is_motion(sections[i])) {
      moves_ = true;
      hold(model, sections[i], law, region);
    } else {
      load(model, law, region, sections[i]);
    }
  }
  loads_ = !face_loads_.empty() || (model.mesh.partial && presses(*model.scene));
}

template <int D>
void Boundary<D>::read_laws(const Model<D>& model) {
  for (const Settings& section : model.scene->list("boundary")) {
    BoundaryLaw<D> law{Vec<D>::zero(), 0, {}};
    if (section.has("velocity")) {
      const Components& velocity = section.components("velocity");
      for (int d = 0; d < D; ++d) law.value[d] = velocity[d].value_or(0.0);
    }
    if (section.has("pressure")) law.pressure = section.number("pressure");
    if (section.has("ramp")) law.ramp.ramp = section.number("ramp");
    law.ramp.begin = static_cast<Index>(tables_.size());
    if (section.has("table"))
      for (const auto& row : section.points("table")) tables_.push_back({row[0], row[1]});
    law.ramp.end = static_cast<Index>(tables_.size());
    laws_.push_back(law);
  }
  constant_ = static_cast<Index>(laws_.size());
  laws_.push_back({Vec<D>::zero(), 0, {}});
}

namespace {

/// Whether a section prescribes component d.
template <int D>
bool holds(const Settings& section, int d) {
  if (section.has("velocity")) return section.components("velocity")[d].has_value();
  if (section.has("fixed")) return section.components("fixed")[d].has_value();
  const std::vector<double>& normal = section.at("plane").vector("normal");
  return normal[static_cast<std::size_t>(d)] != 0;
}

}  // namespace

template <int D>
void Boundary<D>::hold(const Model<D>& model, const Settings& section, Index law,
                       const Region& region) {
  for (int d = 0; d < D; ++d) {
    if (!holds<D>(section, d)) continue;
    for (const Index n : region.points) {
      Index& source = node_sources_[static_cast<std::size_t>(n)][static_cast<std::size_t>(d)];
      if (source != kNone && source != law) {
        const BoundaryLaw<D>&a = laws_[source], &b = laws_[law];
        if (a.value[d] != b.value[d] || (a.value[d] != 0 && a.ramp.ramp != b.ramp.ramp))
          throw section.error(
              section.has("velocity") ? "velocity"
              : section.has("fixed")  ? "fixed"
                                      : "symmetry",
              fmt::format("component {} of node {} is prescribed twice, with different values",
                          "xyz"[d], n),
              fmt::format("make this boundary and the one at {} apart, or free the component in "
                          "one of them",
                          model.scene->list("boundary")[source].place()));
      }
      source = law;
    }
  }
}

template <int D>
void Boundary<D>::make_rows(std::vector<Index>& row_of_node) {
  std::map<Sources, Index> known;
  rows_.clear();
  row_of_node.assign(node_sources_.size(), kNone);
  Sources none;
  none.fill(kNone);
  for (std::size_t n = 0; n < node_sources_.size(); ++n) {
    if (node_sources_[n] == none) continue;
    const auto [row, fresh] = known.try_emplace(node_sources_[n], static_cast<Index>(rows_.size()));
    if (fresh) rows_.push_back(node_sources_[n]);
    row_of_node[n] = row->second;
  }
}

template <int D>
void Boundary<D>::bind(Model<D>& model) {
  resume(model);
  const auto flags = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{},
                                                         model.store.template get<NodeFlags>());
  std::vector<Index> row_of_node;
  make_rows(row_of_node);
  for (std::size_t n = 0; n < row_of_node.size(); ++n) {
    if (row_of_node[n] == kNone) continue;
    flags(n) |= static_cast<std::uint32_t>(row_of_node[n]) << node_flag::boundary_shift;
    for (int d = 0; d < D; ++d)
      if (node_sources_[n][d] != kNone) flags(n) |= node_flag::fixed_x << d;
  }
  const auto mark = [&](const ElementFace& face, std::uint32_t bit) {
    for (int j = 0; j < D; ++j)
      flags(model.mesh.element[face.element][face_node<D>(face.face, j)]) |= bit;
  };
  for (const auto& [face, loads] : face_loads_) mark(face, node_flag::load);
  for (const auto& [face, law] : absorbing_) mark(face, node_flag::absorb);
  Kokkos::deep_copy(model.store.template get<NodeFlags>(), flags);
}

template <int D>
void Boundary<D>::resume(Model<D>& model) {
  motion_.law = to_device("breccia::boundary::law", laws_);
  Kokkos::View<double* [2], Rows, Memory> table("breccia::boundary::table", tables_.size());
  const auto host_table = Kokkos::create_mirror_view(table);
  for (std::size_t i = 0; i < tables_.size(); ++i)
    for (int j = 0; j < 2; ++j) host_table(i, j) = tables_[i][j];
  Kokkos::deep_copy(table, host_table);
  motion_.table = table;
  Kokkos::View<Index* [D], Rows, Memory> source("breccia::boundary::source", rows_.size());
  const auto host_source = Kokkos::create_mirror_view(source);
  for (std::size_t i = 0; i < rows_.size(); ++i)
    for (int d = 0; d < D; ++d) host_source(i, d) = rows_[i][d];
  Kokkos::deep_copy(source, host_source);
  motion_.source = source;
  load_.law = motion_.law;
  load_.table = motion_.table;
  load_.thickness = model.thickness;
  if (model.store.template has<FaceStatus>()) spread(model);
  make_faces();
  if (!absorbing_.empty()) make_absorbers(model);
}

template <int D>
void Boundary<D>::enlist(Model<D>& model, Plan& plan) {
  if (!spreading_.empty())
    plan.add(Stage::search, "boundary::spread", key(), [this, &model](const Clock&) {
      if (!spread(model)) return;
      make_faces();
      mark_loaded(model);
    });
  if (loads_)
    plan.add(Stage::node_force, "boundary::surface_load", key(),
             [this, &model](const Clock& clock) {
               load_.x = model.store.template get<NodePosition<D>>();
               load_.nodes = model.store.template get<ElementNodes<D>>();
               load_.share = model.store.template get_or_empty<ElementShare>();
               load_.time = clock.time;
               surface_load(load_, model.store.template get<LoadForce<D>>());
             })
        .template reading<NodePosition<D>, ElementNodes<D>>()
        .template writing<LoadForce<D>>();
  if (moves_)
    plan.add(Stage::node_force, "boundary::motion", key(),
             [this, &model](const Clock& clock) {
               motion_.time = clock.middle();
               boundary_motion(motion_, model.store.template get<BoundaryVelocity<D>>());
             })
        .template writing<BoundaryVelocity<D>>();
}

/// The numbers of rows are in the flags of the nodes.
template <int D>
void Boundary<D>::archive(Archive& archive) {
  std::vector<std::int64_t> numbers;
  for (const Sources& row : rows_) numbers.insert(numbers.end(), row.begin(), row.end());
  archive.integers("boundary.rows", numbers);
  rows_.resize(numbers.size() / D);
  for (std::size_t i = 0; i < numbers.size(); ++i)
    rows_[i / D][i % D] = static_cast<Index>(numbers[i]);
}

template class Boundary<2>;
template class Boundary<3>;

}  // namespace breccia
