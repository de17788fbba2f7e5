#include "loops/contact_release.hpp"

#include "base/simplex.hpp"
#include "loops/list_tools.hpp"
#include "point/simplex_geometry.hpp"

namespace breccia {

namespace {

template <int D>
struct SidesMeet {
  ReleasedFaces<D> in;
  ConstVectors<D> x, v;
  double time;

  KOKKOS_FUNCTION
  bool operator()(Index face) const {
    const Index left = in.elements(face, 0), right = in.elements(face, 1);
    const int i = in.code(face) & 3, j = (in.code(face) >> 2) & 3, turn = in.code(face) >> 4;
    Vec<D> side[D], gap[D], rate[D];
    for (int k = 0; k < D; ++k) {
      const Index a = in.element_nodes(left, face_node<D>(i, k));
      const Index b = in.element_nodes(right, face_node<D>(j, opposite_face_node<D>(turn, k)));
      side[k] = row<D>(x, a);
      gap[k] = row<D>(x, b) - side[k];
      rate[k] = row<D>(v, b) - row<D>(v, a);
    }
    Vec<D> normal = face_normal(side);
    normal *= 1 / norm(normal);
    for (int q = 0; q < kFacePoints<D>; ++q) {
      Vec<D> g = Vec<D>::zero(), r = Vec<D>::zero();
      for (int k = 0; k < D; ++k) {
        g += gap[k] * face_weight<D>(q, k, in.own_weight);
        r += rate[k] * face_weight<D>(q, k, in.own_weight);
      }
      if (!(dot(g, normal) > norm(r) * time)) return true;
    }
    return false;
  }
};

}  // namespace

template <int D>
void mark_known_releases(const ReleasedFaces<D>& in, const ContactSurface<D>& surface,
                         Array<std::uint8_t>& known) {
  if (static_cast<Index>(known.extent(0)) < in.faces)
    known = allocate<Array<std::uint8_t>>("breccia::contact::known_releases",
                                          static_cast<std::size_t>(in.faces));
  const Array<std::uint8_t> to = known;
  for_each(
      "breccia::contact::known_releases", in.faces, KOKKOS_LAMBDA(Index face) {
        bool is = in.status(face) == in.released;
        if (is) {
          const Index facet = in.elements(face, 0) * (D + 1) + (in.code(face) & 3);
          is = find_in(surface.facet, surface.facets, facet) != kNone;
        }
        to(face) = is ? 1 : 0;
      });
}

template <int D>
Index list_new_releases(const ReleasedFaces<D>& in, const Array<std::uint8_t>& known,
                        Array<Index>& list) {
  return list_where(
      "breccia::contact::new_releases", in.faces,
      KOKKOS_LAMBDA(Index face) { return in.status(face) == in.released && known(face) == 0; },
      list);
}

template <int D>
bool sides_meet(const ReleasedFaces<D>& in, const Array<Index>& list, Index n,
                const ConstVectors<D>& x, const ConstVectors<D>& v, double time) {
  const SidesMeet<D> meet{in, x, v, time};
  return count_where(
             "breccia::contact::sides_meet", n, KOKKOS_LAMBDA(Index k) { return meet(list(k)); }) >
         0;
}

template <int D>
void find_whole_pieces(const ReleasedFaces<D>& in, const Array<Index>& piece,
                       const Array<std::uint8_t>& cut, const ContactSurface<D>& surface) {
  for_each(
      "breccia::contact::cut_pieces", in.faces, KOKKOS_LAMBDA(Index f) {
        const Index p = in.status(f) == 0 ? kNone : piece(in.elements(f, 0));
        if (p != kNone) Kokkos::atomic_store(&cut(p), std::uint8_t{1});
      });
  for_each(
      "breccia::contact::pieces", surface.targets, KOKKOS_LAMBDA(Index t) {
        const Index p = piece(surface.target(t));
        surface.piece(t) = p != kNone && cut(p) == 0 ? p : kNone;
      });
}

template void find_whole_pieces<2>(const ReleasedFaces<2>&, const Array<Index>&,
                                   const Array<std::uint8_t>&, const ContactSurface<2>&);
template void find_whole_pieces<3>(const ReleasedFaces<3>&, const Array<Index>&,
                                   const Array<std::uint8_t>&, const ContactSurface<3>&);
template void mark_known_releases<2>(const ReleasedFaces<2>&, const ContactSurface<2>&,
                                     Array<std::uint8_t>&);
template void mark_known_releases<3>(const ReleasedFaces<3>&, const ContactSurface<3>&,
                                     Array<std::uint8_t>&);
template Index list_new_releases<2>(const ReleasedFaces<2>&, const Array<std::uint8_t>&,
                                    Array<Index>&);
template Index list_new_releases<3>(const ReleasedFaces<3>&, const Array<std::uint8_t>&,
                                    Array<Index>&);
template bool sides_meet<2>(const ReleasedFaces<2>&, const Array<Index>&, Index,
                            const ConstVectors<2>&, const ConstVectors<2>&, double);
template bool sides_meet<3>(const ReleasedFaces<3>&, const Array<Index>&, Index,
                            const ConstVectors<3>&, const ConstVectors<3>&, double);

}  // namespace breccia
