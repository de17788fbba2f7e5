#pragma once
#include "fields/common_fields.hpp"
#include "fields/store.hpp"
#include "loops/interface_views.hpp"

#include <map>
#include <string>
#include <vector>

namespace breccia {

/// A field on the host, row by row.
struct FieldRows {
  Entity entity;
  std::size_t row_bytes = 0;
  std::vector<char> data;

  template <class T>
  T* as() {
    return reinterpret_cast<T*>(data.data());
  }
  template <class T>
  const T* as() const {
    return reinterpret_cast<const T*>(data.data());
  }
};

/// The restart fields of a store by name.
using StateRows = std::map<std::string, FieldRows, std::less<>>;

StateRows rows_of(const Store& store);
/// Rows from(0), from(1), ... of a field.
FieldRows picked(const FieldRows& field, const std::vector<Index>& from);
/// The inverse; entities have the counts that the rows have, and at least that much room.
void put_rows(const StateRows& rows, Store& store);

template <class Field>
const Index* indices_of(const StateRows& rows) {
  return rows.at(std::string(Field::info.name)).template as<Index>();
}

/// How the nodes of a mesh hang together, as the fields of a store say it.
template <int D>
struct NodeTable {
  Index nodes = 0;
  std::vector<Index> element_nodes;  ///< (element, local node)
  std::vector<Index> node_corners;   ///< (node, begin or end)
  std::vector<Index> corner_list;
  std::vector<Index> node_family;

  /// From the name of the node at each corner, which is the first of its corners in the whole
  /// scene. The first node of a family has the family's number, further ones follow behind.
  /// `named` gives the name of each node.
  NodeTable(const std::vector<Index>& name_at_corner, const std::vector<Index>& family_start,
            const std::vector<Index>& family_corner, std::vector<Index>& named);

  void put(StateRows& rows) const;
};

/// The node at each corner by its name: the first of its corners, as it is numbered there.
template <int D>
std::vector<Index> first_corners(const StateRows& rows);

inline bool has_rows(const StateRows& rows, std::string_view name) {
  return rows.find(name) != rows.end();
}

/// The same state with nodes, interfaces and contact points in an order that depends neither on
/// when they came nor on who computed them.
template <int D>
StateRows in_order(const StateRows& rows, const std::vector<Index>& family_start,
                   const std::vector<Index>& family_corner);

/// Place of a number in an ascending list, or none.
Index place_in(const std::vector<Index>& list, Index number);

extern template struct NodeTable<2>;
extern template struct NodeTable<3>;

}  // namespace breccia
