#include "scene/state_rows.hpp"

#include "fields/interface_fields.hpp"
#include "modules/fracture/fracture_fields.hpp"

#include <algorithm>
#include <array>
#include <cstring>
#include <numeric>

namespace breccia {

StateRows rows_of(const Store& store) {
  std::map<std::string, std::size_t, std::less<>> row_bytes;
  for (const Store::Block& block : store.blocks())
    row_bytes[std::string(block.info.name)] = block.bytes_per_entity;
  StateRows rows;
  store.save([&](const FieldInfo& info, const void* data, std::size_t bytes) {
    FieldRows& field = rows[std::string(info.name)];
    field.entity = info.entity;
    field.row_bytes = row_bytes.at(std::string(info.name));
    const auto* begin = static_cast<const char*>(data);
    field.data.assign(begin, begin + bytes);
  });
  return rows;
}

void put_rows(const StateRows& rows, Store& store) {
  for (const auto& [name, field] : rows) {
    const auto count = static_cast<Index>(field.data.size() / field.row_bytes);
    if (store.count(field.entity) == count) continue;
    if (count > store.capacity(field.entity))
      store.set_size(field.entity, count, count + count / 4);
    store.set_count(field.entity, count);
  }
  store.load([&](const FieldInfo& info, void* data, std::size_t bytes) {
    const FieldRows& field = rows.at(std::string(info.name));
    std::memcpy(data, field.data.data(), std::min(bytes, field.data.size()));
  });
}

FieldRows picked(const FieldRows& field, const std::vector<Index>& from) {
  FieldRows rows{field.entity, field.row_bytes, std::vector<char>(from.size() * field.row_bytes)};
  for (std::size_t i = 0; i < from.size(); ++i)
    std::memcpy(rows.data.data() + i * field.row_bytes,
                field.data.data() + static_cast<std::size_t>(from[i]) * field.row_bytes,
                field.row_bytes);
  return rows;
}

template <int D>
NodeTable<D>::NodeTable(const std::vector<Index>& name_at_corner,
                        const std::vector<Index>& family_start,
                        const std::vector<Index>& family_corner, std::vector<Index>& named)
    : element_nodes(name_at_corner.size()), corner_list(family_corner.size()) {
  const std::size_t families = family_start.size() - 1;
  auto next = static_cast<Index>(families);
  named.assign(families, kNone);
  node_corners.assign(2 * families, 0);
  for (std::size_t f = 0; f < families; ++f) node_family.push_back(static_cast<Index>(f));
  std::vector<std::array<Index, 2>> star;  // name, corner
  for (std::size_t f = 0; f < families; ++f) {
    star.clear();
    for (Index k = family_start[f]; k < family_start[f + 1]; ++k) {
      const Index corner = family_corner[static_cast<std::size_t>(k)];
      star.push_back({name_at_corner[static_cast<std::size_t>(corner)], corner});
    }
    std::sort(star.begin(), star.end());
    auto node = static_cast<Index>(f);
    for (std::size_t i = 0; i < star.size(); ++i) {
      const bool first = i == 0 || star[i][0] != star[i - 1][0];
      if (first && i > 0) {
        node = next++;
        named.push_back(kNone);
        node_family.push_back(static_cast<Index>(f));
        node_corners.insert(node_corners.end(), {0, 0});
      }
      const auto n = static_cast<std::size_t>(node);
      const Index place = family_start[f] + static_cast<Index>(i);
      if (first) {
        named[n] = star[i][0];
        node_corners[2 * n] = place;
      }
      node_corners[2 * n + 1] = place + 1;
      corner_list[static_cast<std::size_t>(place)] = star[i][1];
      element_nodes[static_cast<std::size_t>(star[i][1])] = node;
    }
  }
  nodes = next;
}

template <int D>
void NodeTable<D>::put(StateRows& rows) const {
  const auto set = [&rows](std::string_view name, Entity entity, std::size_t per_row,
                           const std::vector<Index>& values) {
    FieldRows& field = rows[std::string(name)];
    field.entity = entity;
    field.row_bytes = per_row * sizeof(Index);
    field.data.resize(values.size() * sizeof(Index));
    std::memcpy(field.data.data(), values.data(), field.data.size());
  };
  set(ElementNodes<D>::info.name, Entity::element, D + 1, element_nodes);
  set(NodeCorners::info.name, Entity::node, 2, node_corners);
  set(CornerList::info.name, Entity::corner, 1, corner_list);
  set(NodeFamily::info.name, Entity::node, 1, node_family);
}

template <int D>
std::vector<Index> first_corners(const StateRows& rows) {
  const std::size_t corners =
      rows.at(std::string(ElementNodes<D>::info.name)).data.size() / sizeof(Index);
  const Index* nodes = indices_of<ElementNodes<D>>(rows);
  const Index* range = indices_of<NodeCorners>(rows);
  const Index* list = indices_of<CornerList>(rows);
  std::vector<Index> name(corners);
  for (std::size_t c = 0; c < corners; ++c)
    name[c] = list[range[2 * static_cast<std::size_t>(nodes[c])]];
  return name;
}

template <int D>
StateRows in_order(const StateRows& rows, const std::vector<Index>& family_start,
                   const std::vector<Index>& family_corner) {
  std::vector<Index> named, nodes, interfaces;
  const NodeTable<D> table(first_corners<D>(rows), family_start, family_corner, named);
  const Index* at_corner = indices_of<ElementNodes<D>>(rows);
  for (const Index corner : named) nodes.push_back(at_corner[corner]);
  if (has_rows(rows, InterfaceRecords::info.name)) {
    const FieldRows& field = rows.at(std::string(InterfaceRecords::info.name));
    interfaces.resize(field.data.size() / field.row_bytes);
    std::iota(interfaces.begin(), interfaces.end(), 0);
    const auto* record = field.as<InterfaceRecord>();
    std::sort(interfaces.begin(), interfaces.end(),
              [record](Index a, Index b) { return record[a].face < record[b].face; });
  }
  StateRows ordered;
  for (const auto& [name, field] : rows) {
    if (field.entity == Entity::node)
      ordered.emplace(name, picked(field, nodes));
    else if (field.entity == Entity::interface)
      ordered.emplace(name, picked(field, interfaces));
    else
      ordered.emplace(name, field);
  }
  table.put(ordered);
  if (has_rows(rows, FaceInterface::info.name)) {
    auto* of_face = ordered.at(std::string(FaceInterface::info.name)).as<Index>();
    const auto* record = ordered.at(std::string(InterfaceRecords::info.name)).as<InterfaceRecord>();
    for (std::size_t i = 0; i < interfaces.size(); ++i)
      of_face[record[i].face] = static_cast<Index>(i);
  }
  return ordered;
}

Index place_in(const std::vector<Index>& list, Index number) {
  const auto found = std::lower_bound(list.begin(), list.end(), number);
  return found != list.end() && *found == number ? static_cast<Index>(found - list.begin()) : kNone;
}

template std::vector<Index> first_corners<2>(const StateRows&);
template std::vector<Index> first_corners<3>(const StateRows&);
template StateRows in_order<2>(const StateRows&, const std::vector<Index>&,
                               const std::vector<Index>&);
template StateRows in_order<3>(const StateRows&, const std::vector<Index>&,
                               const std::vector<Index>&);
template struct NodeTable<2>;
template struct NodeTable<3>;

}  // namespace breccia
