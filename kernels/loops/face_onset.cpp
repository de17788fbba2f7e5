#include "loops/face_onset.hpp"

#include "loops/face_traction.hpp"

namespace breccia {

namespace {

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
    if (face == kNone || in.status(face) != 0) return;
    // The left element asks where both are hot, so that a face is found once.
    const Index left = in.faces.elements(face, 0), right = in.faces.elements(face, 1);
    if (e != left && in.hot(left) != 0) return;
    const Index law =
        in.law_of(in.stress.material(left) * in.materials + in.stress.material(right));
    const FaceTraction<D> t = face_traction(in.faces, in.stress, face);
    if (in.laws(law).onset.reached(t.traction, t.normal)) mark(k) = 1;
  }
};

}  // namespace

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

template Index find_onset<2>(const FaceOnsetIn<2>&, const ConstArray<Index>&, Index,
                             const Array<std::uint8_t>&, const Array<Index>&);
template Index find_onset<3>(const FaceOnsetIn<3>&, const ConstArray<Index>&, Index,
                             const Array<std::uint8_t>&, const Array<Index>&);

}  // namespace breccia
