#include "modules/fracture/interface_lists.hpp"

#include "fields/interface_fields.hpp"
#include "loops/compact.hpp"

namespace breccia {

template <int D>
FaceMap<D> face_map(const Store& store) {
  return {store.get<FaceElements>(), store.get<FaceCode>(), store.get<ElementFaces<D>>()};
}

template <int D>
InterfaceMap<D> interface_map(const Store& store) {
  return {face_map<D>(store), store.get<FaceInterface>(), store.get<InterfaceActive<D>>(),
          store.get<InterfaceRecords>(), store.get<InterfaceLife>()};
}

namespace {

/// 1 where the interface acts and has this law.
template <int D>
void mark_law(const InterfaceMap<D>& map, Index law, Index count, const Array<std::uint8_t>& mark) {
  for_each(
      "breccia::fracture::mark_law", count, KOKKOS_LAMBDA(Index i) {
        bool acts = false;
        for (int c = 0; c < D; ++c) acts = acts || map.active(i, c) != 0;
        acts = acts && map.life(i) != interface_life::gone && map.record(i).law == law;
        mark(i) = acts ? 1 : 0;
      });
}

/// 1 at the elements of the listed interfaces.
void mark_elements(const ConstRanges& faces, const Array<InterfaceRecord>& record,
                   const Array<Index>& list, Index count, const Array<std::uint8_t>& mark) {
  for_each(
      "breccia::fracture::mark_elements", count, KOKKOS_LAMBDA(Index k) {
        const Index face = record(list(k)).face;
        raise(mark, faces(face, 0));
        raise(mark, faces(face, 1));
      });
}

}  // namespace

template <int D>
void InterfaceLists<D>::rebuild(const Model<D>& model, std::size_t laws) {
  const Store& s = model.store;
  const Index count = s.count(Entity::interface);
  make_room(list_, "breccia::fracture::list", count);
  make_room(mark_, "breccia::fracture::mark", count);
  make_room(elements_, "breccia::fracture::elements", model.elements());
  make_room(element_mark_, "breccia::fracture::element_mark", model.elements());
  begin_.assign(1, 0);
  for (std::size_t l = 0; l < laws; ++l) {
    mark_law(interface_map<D>(s), static_cast<Index>(l), count, mark_);
    const auto rest = Kokkos::subview(
        list_, std::make_pair(static_cast<std::size_t>(begin_.back()), list_.extent(0)));
    begin_.push_back(begin_.back() + compact("breccia::fracture::list_law", mark_, count, rest));
  }
  Kokkos::deep_copy(element_mark_, std::uint8_t{0});
  mark_elements(s.get<FaceElements>(), s.get<InterfaceRecords>(), list_, size(), element_mark_);
  element_count_ =
      compact("breccia::fracture::list_elements", element_mark_, model.elements(), elements_);
  make_room(nodes_, "breccia::fracture::pair_nodes", size());
  make_room(sources_, "breccia::fracture::pair_sources", element_count_);
  const InterfaceTables<D> tables{interface_map<D>(s)};
  tables.fill_nodes(list_, size(), s.get<ElementNodes<D>>(), nodes_);
  tables.fill_sources(elements_, element_count_, sources_);
}

template class InterfaceLists<2>;
template class InterfaceLists<3>;
template FaceMap<2> face_map<2>(const Store&);
template FaceMap<3> face_map<3>(const Store&);
template InterfaceMap<2> interface_map<2>(const Store&);
template InterfaceMap<3> interface_map<3>(const Store&);

}  // namespace breccia
