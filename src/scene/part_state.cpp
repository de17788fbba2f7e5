#include "scene/part_state.hpp"

#include "fields/interface_fields.hpp"
#include "modules/contact/contact_fields.hpp"
#include "modules/fracture/fracture_fields.hpp"
#include "scene/state_numbers.hpp"
#include "scene/state_rows.hpp"

#include <cstring>
#include <optional>

namespace breccia {

namespace {

/// Contact points of an element.
template <int D>
constexpr Index kElementPoints = kFacePoints<D>*(D + 1);

/// Of the whole scene's rows those of a part.
template <int D>
class Taker {
 public:
  Taker(const StateRows& whole, const Model<D>& local) : whole_(whole), local_(local) {}

  StateRows take() {
    number_nodes();
    if (has_rows(whole_, FaceStatus::info.name)) list_interfaces();
    if (has_rows(whole_, ContactPoint::info.name)) list_points();
    StateRows rows;
    for (const auto& [name, field] : whole_)
      if (const std::vector<Index>* from = list_of(field.entity))
        rows.emplace(name, picked(field, *from));
      else
        rows.emplace(name, field);
    table_->put(rows);
    forget_masses(rows);
    renumber(rows);
    return rows;
  }

 private:
  const std::vector<Index>* list_of(Entity entity) const {
    switch (entity) {
      case Entity::node:
        return &nodes_;
      case Entity::element:
        return &local_.part.element;
      case Entity::face:
        return &local_.part.face;
      case Entity::interface:
        return &interfaces_;
      case Entity::contact_point:
        return &points_;
      default:
        return nullptr;
    }
  }

  void number_nodes() {
    const std::vector<Index> name = first_corners<D>(whole_);
    const Index* nodes = indices_of<ElementNodes<D>>(whole_);
    std::vector<Index> at_corner, named;
    for (const Index e : local_.part.element)
      for (int a = 0; a <= D; ++a)
        at_corner.push_back(name[static_cast<std::size_t>(e * (D + 1) + a)]);
    table_.emplace(at_corner, local_.topology.family_start, local_.topology.family_corner, named);
    for (const Index first : named) nodes_.push_back(nodes[first]);
  }

  void list_interfaces() {
    const FieldRows& field = whole_.at(std::string(InterfaceRecords::info.name));
    const auto* record = field.as<InterfaceRecord>();
    for (std::size_t i = 0; i < field.data.size() / field.row_bytes; ++i)
      if (place_in(local_.part.face, record[i].face) != kNone)
        interfaces_.push_back(static_cast<Index>(i));
  }

  void list_points() {
    const FieldRows& field = whole_.at(std::string(ContactPoint::info.name));
    for (std::size_t i = 0; i < field.data.size() / sizeof(Index); ++i)
      if (place_in(local_.part.element, field.as<Index>()[i] / kElementPoints<D>) != kNone)
        points_.push_back(static_cast<Index>(i));
  }

  /// Nodes of others have no mass here.
  void forget_masses(StateRows& rows) const {
    auto* mass = rows.at(std::string(NodeMass::info.name)).as<double>();
    for (std::size_t n = 0; n < table_->node_family.size(); ++n) {
      const auto family = static_cast<std::size_t>(table_->node_family[n]);
      if (local_.part.family_owner[family] != local_.part.world->rank()) mass[n] = 0;
    }
  }

  void renumber(StateRows& rows) const {
    const std::vector<Index>& element = local_.part.element;
    if (has_rows(rows, FaceInterface::info.name)) {
      auto* record = rows.at(std::string(InterfaceRecords::info.name)).as<InterfaceRecord>();
      auto* of_face = rows.at(std::string(FaceInterface::info.name)).as<Index>();
      for (std::size_t f = 0; f < local_.part.face.size(); ++f) of_face[f] = kNone;
      for (std::size_t i = 0; i < interfaces_.size(); ++i) {
        record[i].face = place_in(local_.part.face, record[i].face);
        of_face[record[i].face] = static_cast<Index>(i);
      }
    }
    if (!has_rows(rows, ContactPoint::info.name)) return;
    auto* point = rows.at(std::string(ContactPoint::info.name)).as<Index>();
    auto* target = rows.at(std::string(ContactElement::info.name)).as<Index>();
    for (std::size_t p = 0; p < points_.size(); ++p) {
      point[p] = place_in(element, point[p] / kElementPoints<D>) * kElementPoints<D> +
                 point[p] % kElementPoints<D>;
      for (int slot = 0; slot < kContactSlots; ++slot) {
        Index& e = target[p * kContactSlots + static_cast<std::size_t>(slot)];
        e = e == kNone ? kNone : place_in(element, e);
      }
    }
  }

  const StateRows& whole_;
  const Model<D>& local_;
  std::optional<NodeTable<D>> table_;
  std::vector<Index> nodes_, interfaces_, points_;  ///< numbers in the whole
};

}  // namespace

template <int D>
void take_state(Simulation<D>& whole, Simulation<D>& local) {
  Model<D>& model = local.model();
  put_rows(Taker<D>(rows_of(whole.model().store), model).take(), model.store);
  const Index boundaries = whole.model().store.count(Entity::boundary);
  if (model.store.count(Entity::boundary) != boundaries)
    model.store.set_size(Entity::boundary, boundaries, boundaries);
  StateNumbers numbers;
  NumbersWriter writer(numbers);
  whole.archive(writer);
  if (!model.part.leads()) numbers.forget_parts();
  NumbersReader reader(numbers);
  local.archive(reader);
  local.resume();
}

template void take_state(Simulation<2>&, Simulation<2>&);
template void take_state(Simulation<3>&, Simulation<3>&);

}  // namespace breccia
