#include "loops/face_onset.hpp"

#include "loops/compact.hpp"
#include "loops/face_traction.hpp"

namespace breccia {

namespace {

constexpr std::uint8_t kBonded = 0, kInserted = 1;  // fields/common_fields.hpp

template <int D>
KOKKOS_FUNCTION
const CohesiveOnset& onset_of(const FaceOnsetIn<D>& in, Index face) {
  return in.laws(in.law_of(face)).onset;
}

template <int D>
KOKKOS_FUNCTION
Index family_at(const FaceOnsetIn<D>& in, Index face, int corner) {
  const auto at = in.faces.left(face, corner);
  return in.family(in.stress.nodes(at.element, at.node));
}

template <int D>
struct StrainedLoop {
  FaceOnsetIn<D> in;
  ConstArray<Index> elements;

  KOKKOS_FUNCTION
  void operator()(Index k, Index& found) const {
    const Index e = elements(k / (D + 1));
    const Index face = in.faces.of_element(e, static_cast<int>(k % (D + 1)));
    if (face == kNone || in.status(face) != kInserted) return;
    const Index i = in.of_face(face);
    bool locked[D], any = false;
    for (int c = 0; c < D; ++c) any = (locked[c] = in.active(i, c) == 0) || any;
    if (!any) return;
    const FaceTraction<D> t = face_traction(in.faces, in.stress, face);
    const CohesiveOnset onset = onset_of(in, face).scaled(in.record(i).dynamic_share);
    if (onset.measure(t.traction, t.normal) < 1) return;
    for (int c = 0; c < D; ++c) {
      if (!locked[c]) continue;
      raise(in.strained, family_at(in, face, c));
      ++found;
    }
  }
};

template <int D>
struct OnsetLoop {
  FaceOnsetIn<D> in;
  ConstArray<Index> elements;
  Array<std::uint8_t> mark;

  KOKKOS_FUNCTION
  void operator()(Index k) const {
    const Index e = elements(k / (D + 1));
    const Index face = in.faces.of_element(e, static_cast<int>(k % (D + 1)));
    mark(k) = 0;
    if (face == kNone || in.status(face) != kBonded) return;
    // The left element asks where both are hot, so that a face is found once.
    const Index left = in.faces.elements(face, 0);
    if (e != left && is_raised(in.hot, left)) return;
    const CohesiveOnset& onset = onset_of(in, face);
    bool joins = false;
    for (int c = 0; c < D; ++c) joins = joins || in.strained(family_at(in, face, c)) != 0;
    const double share = joins && kJoining < onset.alpha ? kJoining : onset.alpha;
    const FaceTraction<D> t = face_traction(in.faces, in.stress, face);
    // Strength only grows with the rate, so that a face below it at rest need not ask.
    if (onset.measure(t.traction, t.normal) < share) return;
    const double grown = dynamic_share(in.faces, in.stress, in.velocity, face, onset);
    if (onset.scaled(grown).measure(t.traction, t.normal) >= share) mark(k) = 1;
  }
};

}  // namespace

template <int D>
Index flag_strained(const FaceOnsetIn<D>& in, const ConstArray<Index>& elements, Index count) {
  Index found = 0;
  count_launch();
  Kokkos::parallel_reduce("breccia::fracture::strained",
                          Kokkos::RangePolicy<Exec, Kokkos::IndexType<Index>>(0, count * (D + 1)),
                          StrainedLoop<D>{in, elements}, found);
  return found;
}

template <int D>
Index find_onset(const FaceOnsetIn<D>& in, const ConstArray<Index>& elements, Index count,
                 const Array<std::uint8_t>& mark, const Array<Index>& found) {
  for_each("breccia::fracture::onset", count * (D + 1), OnsetLoop<D>{in, elements, mark});
  const auto faces = in.faces;
  return scan(
      "breccia::fracture::list_onset", count * (D + 1),
      KOKKOS_LAMBDA(Index k, Index & at, bool last) {
        if (mark(k) == 0) return;
        if (last)
          found(at) = faces.of_element(elements(k / (D + 1)), static_cast<int>(k % (D + 1)));
        ++at;
      });
}

template Index flag_strained<2>(const FaceOnsetIn<2>&, const ConstArray<Index>&, Index);
template Index flag_strained<3>(const FaceOnsetIn<3>&, const ConstArray<Index>&, Index);
template Index find_onset<2>(const FaceOnsetIn<2>&, const ConstArray<Index>&, Index,
                             const Array<std::uint8_t>&, const Array<Index>&);
template Index find_onset<3>(const FaceOnsetIn<3>&, const ConstArray<Index>&, Index,
                             const Array<std::uint8_t>&, const Array<Index>&);

}  // namespace breccia
