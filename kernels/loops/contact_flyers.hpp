#pragma once
#include "loops/contact_lists.hpp"

namespace breccia {

/// Pieces of targets, and how each has moved since the last search. Any division of the targets
/// will do; the natural one are fragments.
template <int D>
struct ContactPieces {
  /// Columns of `numbers`: box of the places at the last search; then, now, displacement of the
  /// piece's first node, squares of the largest displacement, of that against the first node, of
  /// the largest speed and of that against the first node. SI.
  enum { lower = 0, upper = D, shift = 2 * D, way = 3 * D, spread, speed, turn, columns };
  Index count = 0;
  Array<Index> of_target;
  Array<Index> first;  ///< lowest target
  Kokkos::View<double * [3 * D + 4], Rows, Memory> numbers;
};

/// From the piece of each target: first targets and boxes.
template <int D>
void box_pieces(const ContactSurface<D>& surface, const ContactPieces<D>& pieces);

/// How they have moved.
template <int D>
void move_pieces(const ContactSurface<D>& surface, const ContactPieces<D>& pieces,
                 const ConstVectors<D>& x, const ConstVectors<D>& v);

/// Per piece: by how much its targets may lie below and above their places at the last search, m.
template <int D>
using PieceReach = Kokkos::View<double * [2 * D], Rows, Memory>;

/// True when the box of one of the n listed pieces touches that of a target of another piece.
template <int D>
bool pieces_near(const ContactSurface<D>& surface, const ContactPieces<D>& pieces,
                 const PieceReach<D>& reach, const Array<Index>& list, Index n);

extern template void box_pieces<2>(const ContactSurface<2>&, const ContactPieces<2>&);
extern template void box_pieces<3>(const ContactSurface<3>&, const ContactPieces<3>&);
extern template void move_pieces<2>(const ContactSurface<2>&, const ContactPieces<2>&,
                                    const ConstVectors<2>&, const ConstVectors<2>&);
extern template void move_pieces<3>(const ContactSurface<3>&, const ContactPieces<3>&,
                                    const ConstVectors<3>&, const ConstVectors<3>&);
extern template bool pieces_near<2>(const ContactSurface<2>&, const ContactPieces<2>&,
                                    const PieceReach<2>&, const Array<Index>&, Index);
extern template bool pieces_near<3>(const ContactSurface<3>&, const ContactPieces<3>&,
                                    const PieceReach<3>&, const Array<Index>&, Index);

}  // namespace breccia
