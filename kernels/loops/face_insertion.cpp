#include "loops/face_insertion.hpp"

#include "loops/boundary.hpp"
#include "loops/compact.hpp"
#include "loops/face_traction.hpp"

namespace breccia {

namespace {

constexpr std::uint8_t kInserted = 1;  // face_status::inserted (fields/common_fields.hpp)

template <int D>
struct InsertionLoop {
  FaceInsertionIn<D> in;
  FaceInsertionOut<D> out;

  KOKKOS_FUNCTION
  void operator()(Index k) const {
    const Index face = in.list(k), i = in.first + k;
    const Index left = in.faces.elements(face, 0), right = in.faces.elements(face, 1);
    const Index ml = in.shape.material(left), mr = in.shape.material(right);
    Vec<D> x[D];
    for (int c = 0; c < D; ++c)
      x[c] = face_point(in.faces, in.element_nodes, in.reference, face, 0, c);
    const double area = norm(area_vector(x)) * in.shape.thickness;
    const double height = (in.shape.volume(left) + in.shape.volume(right)) / (2 * area);
    const Index law = in.law_of(face);
    const InterfaceLaw& l = in.laws(law);
    out.record(i) = {face, law, area,
                     springs_of(in.side(ml), in.side(mr), height, l.stiffness_factor, l.damping),
                     dynamic_share(in.faces, in.shape, in.velocity, face, l.onset)};
    out.status(face) = kInserted;
    out.of_face(face) = i;
    out.life(i) = interface_life::acting;
    for (int c = 0; c < D; ++c) {
      out.active(i, c) = 0;
      for (int d = 0; d < D; ++d) out.force(i, c, d) = 0;
      // Both sides are of one family, but at the rim of what a rank knows (mesh/part.hpp).
      for (const auto& at : {in.faces.left(face, c), in.faces.right(face, c)})
        raise(out.touched, in.family(in.element_nodes(at.element, at.node)));
    }
  }
};

}  // namespace

template <int D>
void insert_faces(Index count, const FaceInsertionIn<D>& in, const FaceInsertionOut<D>& out) {
  for_each("breccia::fracture::insert_faces", count, InsertionLoop<D>{in, out});
}

template void insert_faces<2>(Index, const FaceInsertionIn<2>&, const FaceInsertionOut<2>&);
template void insert_faces<3>(Index, const FaceInsertionIn<3>&, const FaceInsertionOut<3>&);

}  // namespace breccia
