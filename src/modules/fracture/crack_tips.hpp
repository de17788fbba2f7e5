#pragma once
#include "loops/tip_onset.hpp"
#include "step/model.hpp"

namespace breccia {

/// The tips of a mesh in the plane: notches from the start, ends of cracks as they come and go. In
/// space one face never opens a node by itself, and there is nothing to find.
template <int D>
class CrackTips {
 public:
  /// Room, and the notches: points with more than kNotch of a half turn of solid around them.
  void prepare(const Model<D>& model);

  /// Looks again at the listed families, or at all where `count` is that of the families and the
  /// list is empty.
  void renew(const TipOnsetIn<D>& in, const ConstArray<Index>& families, Index count);

  /// Faces that are to be inserted; found() holds them.
  Index find(const TipOnsetIn<D>& in);
  const Array<Index>& found() const { return found_; }
  std::size_t bytes() const;

 private:
  Array<std::uint8_t> flag_;  ///< of families
  Array<Index> tips_, tip_of_, choice_, found_;
  Index count_ = 0;
};

}  // namespace breccia
