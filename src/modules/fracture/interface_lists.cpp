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

/// Appends interfaces [first, end) of this law that are not gone; returns how many.
template <int D>
Index append_law(const InterfaceMap<D>& map, Index law, Index first, Index end,
                 const Array<Index>& list, Index at_first) {
  return scan(
      "breccia::fracture::list_law", end - first, KOKKOS_LAMBDA(Index k, Index & at, bool last) {
        const Index i = first + k;
        if (map.life(i) == interface_life::gone || map.record(i).law != law) return;
        if (last) list(at_first + at) = i;
        ++at;
      });
}

/// 1 at the elements of interfaces [first, end) that are not gone.
template <int D>
void mark_elements(const InterfaceMap<D>& map, Index first, Index end,
                   const Array<std::uint8_t>& mark) {
  for_each(
      "breccia::fracture::mark_elements", first, end, KOKKOS_LAMBDA(Index i) {
        if (map.life(i) == interface_life::gone) return;
        const Index face = map.record(i).face;
        raise(mark, map.faces.elements(face, 0));
        raise(mark, map.faces.elements(face, 1));
      });
}

}  // namespace

template <int D>
Index InterfaceLists<D>::size() const {
  Index sum = 0;
  for (const Index n : size_) sum += n;
  return sum;
}

template <int D>
InterfaceTables<D> InterfaceLists<D>::tables(const Model<D>& model) const {
  const Store& s = model.store;
  return {interface_map<D>(s), s.get<ElementNodes<D>>(), nodes_, sources_};
}

template <int D>
void InterfaceLists<D>::append(const Model<D>& model, Index first) {
  const Store& s = model.store;
  const InterfaceMap<D> map = interface_map<D>(s);
  const Index end = s.count(Entity::interface);
  for (std::size_t l = 0; l < list_.size(); ++l)
    size_[l] += append_law(map, static_cast<Index>(l), first, end, list_[l], size_[l]);
  mark_elements(map, first, end, element_mark_);
  element_count_ =
      compact("breccia::fracture::list_elements", element_mark_, model.elements(), elements_);
}

template <int D>
void InterfaceLists<D>::rebuild(const Model<D>& model, std::size_t laws) {
  const Store& s = model.store;
  const Index count = s.count(Entity::interface);
  list_.resize(laws);
  size_.assign(laws, 0);
  gone_ = 0;
  for (Array<Index>& list : list_) make_room(list, "breccia::fracture::list", count);
  make_room(nodes_, "breccia::fracture::pair_nodes", count);
  make_room(elements_, "breccia::fracture::elements", model.elements());
  make_room(element_mark_, "breccia::fracture::element_mark", model.elements());
  make_room(sources_, "breccia::fracture::pair_sources", count > 0 ? model.elements() : 0);
  Kokkos::deep_copy(element_mark_, std::uint8_t{0});
  append(model, 0);
  if (count > 0) tables(model).fill(count, model.elements());
}

template <int D>
bool InterfaceLists<D>::join(const Model<D>& model, Index first) {
  const auto count = static_cast<std::size_t>(model.store.count(Entity::interface));
  bool fits = sources_.extent(0) > 0 && nodes_.extent(0) >= count;
  for (const Array<Index>& list : list_) fits = fits && list.extent(0) >= count;
  if (fits)
    append(model, first);
  else
    rebuild(model, list_.size());
  return fits;
}

template <int D>
void InterfaceLists<D>::renew(const Model<D>& model, const Array<Index>& families,
                              Index count) const {
  const Store& s = model.store;
  tables(model).renew(families, count, s.get<FamilyCorners>(), s.get<CornerList>(),
                      s.get<InterfacePairForce<D>>(), s.get<InterfaceForce<D>>());
}

template <int D>
bool InterfaceLists<D>::leave(Index count) {
  constexpr Index kShare = 8;
  gone_ += count;
  return gone_ > size() / kShare;
}

template <int D>
std::size_t InterfaceLists<D>::bytes() const {
  std::size_t sum = bytes_of(elements_, element_mark_, nodes_, sources_);
  for (const Array<Index>& list : list_) sum += bytes_of(list);
  return sum;
}

template class InterfaceLists<2>;
template class InterfaceLists<3>;
template FaceMap<2> face_map<2>(const Store&);
template FaceMap<3> face_map<3>(const Store&);
template InterfaceMap<2> interface_map<2>(const Store&);
template InterfaceMap<3> interface_map<3>(const Store&);

}  // namespace breccia
