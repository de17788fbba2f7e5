#pragma once
#include "loops/interface_tables.hpp"
#include "modules/fracture/fracture_fields.hpp"
#include "step/model.hpp"

#include <vector>

namespace breccia {

/// Which interfaces act and which elements they touch. Rebuilt when faces are inserted or leave,
/// always in the order of their numbers.
template <int D>
class InterfaceLists {
 public:
  void rebuild(const Model<D>& model, std::size_t laws);

  /// Interfaces of law l are list()[begin(l)] ... list()[begin(l + 1) - 1].
  const Array<Index>& list() const { return list_; }
  Index begin(std::size_t law) const { return begin_.empty() ? 0 : begin_[law]; }
  Index size() const { return begin_.empty() ? 0 : begin_.back(); }
  const Array<Index>& elements() const { return elements_; }
  Index element_count() const { return element_count_; }
  /// Nodes per place in list(), sources of forces per place in elements().
  const PairNodes<D>& nodes() const { return nodes_; }
  const PairSources<D>& sources() const { return sources_; }

 private:
  Array<Index> list_, elements_;
  Array<std::uint8_t> mark_, element_mark_;
  PairNodes<D> nodes_;
  PairSources<D> sources_;
  std::vector<Index> begin_;
  Index element_count_ = 0;
};

/// Makes room for n numbers; what is in the view is lost when it grows.
template <class View>
void make_room(View& view, const char* label, Index n) {
  if (static_cast<Index>(view.extent(0)) >= n) return;
  view = View();
  view = allocate<View>(label, static_cast<std::size_t>(n) + static_cast<std::size_t>(n) / 2);
}

/// Views of the inserted faces and of the faces between elements.
template <int D>
FaceMap<D> face_map(const Store& store);
template <int D>
InterfaceMap<D> interface_map(const Store& store);

}  // namespace breccia
