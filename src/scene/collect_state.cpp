// The state of all ranks in one place.
#include "fields/interface_fields.hpp"
#include "modules/contact/contact_fields.hpp"
#include "modules/fracture/fracture_fields.hpp"
#include "scene/part_state.hpp"
#include "scene/state_numbers.hpp"
#include "scene/state_rows.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <sstream>

namespace breccia {

namespace {

/// Contact points of an element.
template <int D>
constexpr Index kElementPoints = kFacePoints<D>*(D + 1);

/// What a rank owns, by numbers of the whole scene: its rows of each entity, and the names of the
/// nodes at the corners of its elements.
struct OwnState {
  std::vector<Index> element, node, face, interface, point;  ///< an interface by its face
  std::vector<Index> name_at_corner;
  StateRows rows;

  std::vector<Index>* list_of(Entity entity) {
    switch (entity) {
      case Entity::node:
        return &node;
      case Entity::element:
        return &element;
      case Entity::face:
        return &face;
      case Entity::interface:
        return &interface;
      case Entity::contact_point:
        return &point;
      default:
        return nullptr;
    }
  }
};

/// Bytes of vectors, one behind the other.
class Packer {
 public:
  template <class T>
  void put(const std::vector<T>& values) {
    const std::uint64_t n = values.size();
    append(&n, sizeof n);
    append(values.data(), n * sizeof(T));
  }
  std::vector<char> bytes;

 private:
  void append(const void* data, std::size_t n) {
    const auto* begin = static_cast<const char*>(data);
    bytes.insert(bytes.end(), begin, begin + n);
  }
};

class Unpacker {
 public:
  explicit Unpacker(const std::vector<char>& bytes) : at_(bytes.data()) {}
  template <class T>
  void get(std::vector<T>& values) {
    std::uint64_t n = 0;
    std::memcpy(&n, at_, sizeof n);
    at_ += sizeof n;
    values.resize(n);
    std::memcpy(values.data(), at_, n * sizeof(T));
    at_ += n * sizeof(T);
  }

 private:
  const char* at_;
};

/// Rows [of a local list] that the rank owns, with what they refer to by its number in the whole.
template <int D>
class Giver {
 public:
  explicit Giver(const Model<D>& local) : local_(local), rows_(rows_of(local.store)) {}

  OwnState give() {
    const Part& part = local_.part;
    std::vector<Index> elements, nodes, faces, interfaces, points;
    for (Index e = 0; e < local_.elements(); ++e)
      if (part.owns_element(e)) elements.push_back(e);
    list_nodes(nodes);
    for (std::size_t f = 0; f < part.face.size(); ++f)
      if (part.owns_element(local_.topology.shared[f].left)) faces.push_back(static_cast<Index>(f));
    if (has_rows(rows_, InterfaceRecords::info.name)) list_interfaces(interfaces);
    if (has_rows(rows_, ContactPoint::info.name)) list_points(points);
    for (const Index e : elements) own_.element.push_back(part.element[e]);
    for (const Index f : faces) own_.face.push_back(part.face[f]);
    own_.rows = std::move(rows_);
    keep(Entity::element, elements);
    keep(Entity::node, nodes);
    keep(Entity::face, faces);
    keep(Entity::interface, interfaces);
    keep(Entity::contact_point, points);
    for (const auto& derived : {CornerList::info.name, NodeCorners::info.name,
                                NodeFamily::info.name, ElementNodes<D>::info.name})
      own_.rows.erase(std::string(derived));
    return std::move(own_);
  }

 private:
  Index corner_in_whole(Index corner) const {
    return local_.part.element[corner / (D + 1)] * (D + 1) + corner % (D + 1);
  }

  void list_nodes(std::vector<Index>& nodes) {
    const std::vector<Index> name = first_corners<D>(rows_);
    const Index* family = indices_of<NodeFamily>(rows_);
    const Index* range = indices_of<NodeCorners>(rows_);
    const Index* list = indices_of<CornerList>(rows_);
    for (Index e = 0; e < local_.elements(); ++e)
      for (int a = 0; local_.part.owns_element(e) && a <= D; ++a)
        own_.name_at_corner.push_back(corner_in_whole(name[e * (D + 1) + a]));
    for (Index n = 0; n < local_.nodes(); ++n) {
      if (local_.part.family_owner[family[n]] != local_.part.world->rank()) continue;
      nodes.push_back(n);
      own_.node.push_back(corner_in_whole(list[range[2 * static_cast<std::size_t>(n)]]));
    }
  }

  void list_interfaces(std::vector<Index>& interfaces) {
    FieldRows& field = rows_.at(std::string(InterfaceRecords::info.name));
    auto* record = field.as<InterfaceRecord>();
    for (std::size_t i = 0; i < field.data.size() / field.row_bytes; ++i) {
      const Index face = record[i].face;
      record[i].face = local_.part.face[face];
      if (!local_.part.owns_element(local_.topology.shared[face].left)) continue;
      interfaces.push_back(static_cast<Index>(i));
      own_.interface.push_back(record[i].face);
    }
  }

  void list_points(std::vector<Index>& points) {
    FieldRows& field = rows_.at(std::string(ContactPoint::info.name));
    Index* point = field.as<Index>();
    Index* target = rows_.at(std::string(ContactElement::info.name)).as<Index>();
    for (std::size_t p = 0; p < field.data.size() / sizeof(Index); ++p) {
      const Index e = point[p] / kElementPoints<D>;
      for (int slot = 0; slot < kContactSlots; ++slot) {
        Index& t = target[p * kContactSlots + static_cast<std::size_t>(slot)];
        if (t != kNone) t = local_.part.element[t];
      }
      point[p] = local_.part.element[e] * kElementPoints<D> + point[p] % kElementPoints<D>;
      if (!local_.part.owns_element(e)) continue;
      points.push_back(static_cast<Index>(p));
      own_.point.push_back(point[p]);
    }
  }

  void keep(Entity entity, const std::vector<Index>& list) {
    for (auto& [name, field] : own_.rows) {
      if (field.entity != entity) continue;
      std::vector<char> kept(list.size() * field.row_bytes);
      for (std::size_t i = 0; i < list.size(); ++i)
        std::memcpy(kept.data() + i * field.row_bytes,
                    field.data.data() + static_cast<std::size_t>(list[i]) * field.row_bytes,
                    field.row_bytes);
      field.data = std::move(kept);
    }
  }

  const Model<D>& local_;
  StateRows rows_;
  OwnState own_;
};

std::vector<char> packed(const OwnState& own) {
  Packer to;
  for (const auto* list :
       {&own.element, &own.node, &own.face, &own.interface, &own.point, &own.name_at_corner})
    to.put(*list);
  for (const auto& [name, field] : own.rows) to.put(field.data);
  return std::move(to.bytes);
}

/// `like`: from this rank, which has the same fields.
OwnState unpacked(const std::vector<char>& bytes, const OwnState& like) {
  OwnState own;
  Unpacker from(bytes);
  for (auto* list :
       {&own.element, &own.node, &own.face, &own.interface, &own.point, &own.name_at_corner})
    from.get(*list);
  for (const auto& [name, field] : like.rows) {
    FieldRows& rows = own.rows[name];
    rows.entity = field.entity;
    rows.row_bytes = field.row_bytes;
    from.get(rows.data);
  }
  return own;
}

/// Numbers of things that are few, by their place among all in ascending order.
std::vector<Index> all_of(std::vector<OwnState>& parts, Entity entity) {
  std::vector<Index> all;
  for (OwnState& part : parts)
    all.insert(all.end(), part.list_of(entity)->begin(), part.list_of(entity)->end());
  std::sort(all.begin(), all.end());
  return all;
}

/// Puts the rows of all ranks where they belong in the whole scene.
template <int D>
StateRows joined(std::vector<OwnState>& parts, const Model<D>& whole) {
  std::vector<Index> name_at_corner(whole.mesh.element.size() * (D + 1)), named;
  for (const OwnState& part : parts)
    for (std::size_t i = 0; i < part.name_at_corner.size(); ++i)
      name_at_corner[static_cast<std::size_t>(part.element[i / (D + 1)]) * (D + 1) + i % (D + 1)] =
          part.name_at_corner[i];
  const NodeTable<D> table(name_at_corner, whole.topology.family_start,
                           whole.topology.family_corner, named);
  const std::vector<Index> interfaces = all_of(parts, Entity::interface);
  const std::vector<Index> points = all_of(parts, Entity::contact_point);
  const auto count_of = [&](Entity entity) -> std::size_t {
    switch (entity) {
      case Entity::node:
        return static_cast<std::size_t>(table.nodes);
      case Entity::element:
        return whole.mesh.element.size();
      case Entity::face:
        return whole.topology.shared.size();
      case Entity::interface:
        return interfaces.size();
      default:
        return points.size();
    }
  };
  const auto place_of = [&](Entity entity, Index number) -> Index {
    if (entity == Entity::node) return table.element_nodes[static_cast<std::size_t>(number)];
    if (entity == Entity::interface) return place_in(interfaces, number);
    if (entity == Entity::contact_point) return place_in(points, number);
    return number;
  };
  StateRows rows = parts.front().rows;
  for (auto& [name, field] : rows) {
    if (parts.front().list_of(field.entity) == nullptr) continue;
    field.data.assign(count_of(field.entity) * field.row_bytes, 0);
    for (OwnState& part : parts) {
      const FieldRows& from = part.rows.at(name);
      const std::vector<Index>& list = *part.list_of(field.entity);
      for (std::size_t i = 0; i < list.size(); ++i)
        std::memcpy(field.data.data() +
                        static_cast<std::size_t>(place_of(field.entity, list[i])) * field.row_bytes,
                    from.data.data() + i * field.row_bytes, field.row_bytes);
    }
  }
  table.put(rows);
  if (has_rows(rows, FaceInterface::info.name)) {
    auto* of_face = rows.at(std::string(FaceInterface::info.name)).as<Index>();
    std::fill(of_face, of_face + whole.topology.shared.size(), kNone);
    for (std::size_t i = 0; i < interfaces.size(); ++i)
      of_face[interfaces[i]] = static_cast<Index>(i);
  }
  return rows;
}

/// What rank 0 has, for everybody.
void share(const World& world, StateRows& rows) {
  std::string names;
  for (const auto& [name, field] : rows)
    names += fmt::format("{} {} {}\n", name, static_cast<int>(field.entity), field.row_bytes);
  world.share(names, 0);
  std::istringstream lines(names);
  std::string name;
  int entity = 0;
  std::size_t row_bytes = 0;
  while (lines >> name >> entity >> row_bytes) {
    FieldRows& field = rows[name];
    field.entity = static_cast<Entity>(entity);
    field.row_bytes = row_bytes;
    world.share(field.data, 0);
  }
}

}  // namespace

template <int D>
void collect_state(Simulation<D>& local, Simulation<D>* whole, bool everywhere) {
  const World& world = *local.model().part.world;
  OwnState own = Giver<D>(local.model()).give();
  const std::vector<std::vector<char>> all = world.collect(packed(own));
  StateNumbers numbers;
  NumbersWriter writer(numbers);
  local.archive(writer);
  const std::vector<std::vector<char>> all_numbers = world.collect(numbers.packed());
  StateRows rows;
  if (world.speaks()) {
    std::vector<OwnState> parts;
    for (const std::vector<char>& bytes : all) parts.push_back(unpacked(bytes, own));
    rows = joined<D>(parts, whole->model());
    for (std::size_t r = 1; r < all_numbers.size(); ++r)
      numbers.add(StateNumbers::unpacked(all_numbers[r]));
  }
  if (everywhere) {
    share(world, rows);
    std::vector<char> bytes = world.speaks() ? numbers.packed() : std::vector<char>();
    world.share(bytes, 0);
    for (auto& [name, entry] : StateNumbers::unpacked(bytes).entries) numbers.entries[name] = entry;
  } else if (!world.speaks()) {
    return;
  }
  put_rows(rows, whole->model().store);
  NumbersReader reader(numbers);
  whole->archive(reader);
}

template void collect_state(Simulation<2>&, Simulation<2>*, bool);
template void collect_state(Simulation<3>&, Simulation<3>*, bool);

}  // namespace breccia
