#pragma once
#include "loops/interface_tables.hpp"
#include "modules/fracture/fracture_fields.hpp"
#include "step/model.hpp"

#include <vector>

namespace breccia {

/// Which interfaces act, law by law in the order of their numbers, and which elements they touch.
/// New interfaces join at the end; those that are gone stay, without force, until they are many.
template <int D>
class InterfaceLists {
 public:
  /// Makes everything anew.
  void rebuild(const Model<D>& model, std::size_t laws);

  /// Takes interfaces [first, ...) in. Where that needs room, makes everything anew and returns
  /// false: the forces on corners are then to be booked.
  bool join(const Model<D>& model, Index first);

  /// Corners of the listed families, whose nodes or faces have changed.
  void renew(const Model<D>& model, const Array<Index>& families, Index count) const;

  /// Takes note that interfaces left; true when the lists are to be made anew.
  bool leave(Index count);

  /// Interfaces of law l are list(l)(0) ... list(l)(size(l) - 1).
  const Array<Index>& list(std::size_t law) const { return list_[law]; }
  Index size(std::size_t law) const { return size_[law]; }
  Index size() const;
  const Array<Index>& elements() const { return elements_; }
  Index element_count() const { return element_count_; }
  const PairNodes<D>& nodes() const { return nodes_; }
  const PairSources<D>& sources() const { return sources_; }
  std::size_t bytes() const;

 private:
  void append(const Model<D>& model, Index first);
  InterfaceTables<D> tables(const Model<D>& model) const;

  std::vector<Array<Index>> list_;  ///< per law
  std::vector<Index> size_;
  Array<Index> elements_;
  Array<std::uint8_t> element_mark_;
  PairNodes<D> nodes_;
  PairSources<D> sources_;
  Index element_count_ = 0;
  Index gone_ = 0;  ///< still in the lists
};

/// Makes room for n numbers; what is in the view is lost when it grows.
template <class View>
void make_room(View& view, const char* label, Index n) {
  if (static_cast<Index>(view.extent(0)) >= n) return;
  view = View();
  view = allocate<View>(label, static_cast<std::size_t>(n) + static_cast<std::size_t>(n) / 2);
}

/// Memory of views.
template <class... View>
std::size_t bytes_of(const View&... view) {
  return (std::size_t{0} + ... + (view.span() * sizeof(typename View::value_type)));
}

/// Views of the inserted faces and of the faces between elements.
template <int D>
FaceMap<D> face_map(const Store& store);
template <int D>
InterfaceMap<D> interface_map(const Store& store);

}  // namespace breccia
