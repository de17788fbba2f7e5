#pragma once
#include "loops/element_stress.hpp"
#include "loops/interface_views.hpp"

namespace breccia {

/// Faces list[0] ... list[count - 1] become interfaces first ... first + count - 1.
template <int D>
struct FaceInsertionIn {
  FaceMap<D> faces;
  ConstConnectivity<D> element_nodes;
  ConstVectors<D> reference;         ///< m, of nodes
  ConstArray<Index> family;          ///< of nodes
  ElementStress<D> shape;            ///< volumes and materials
  ConstArray<InterfaceSide> side;    ///< per material
  ConstArray<std::uint16_t> law_of;  ///< law of each face that has one
  ConstArray<InterfaceLaw> laws;
  ConstVectors<D> velocity;  ///< m/s, of nodes
  ConstArray<Index> list;
  Index first;
};

template <int D>
struct FaceInsertionOut {
  Array<std::uint8_t> status;  ///< of faces
  Array<Index> of_face;
  Array<InterfaceRecord> record;
  Array<std::uint8_t> life;
  CornerFlags<D> active;
  PairForces<D> force;
  Array<std::uint8_t> touched;  ///< families of the faces' corners
};

/// Makes records of new interfaces whose corners are all locked (families have not split yet).
template <int D>
void insert_faces(Index count, const FaceInsertionIn<D>& in, const FaceInsertionOut<D>& out);

extern template void insert_faces<2>(Index, const FaceInsertionIn<2>&, const FaceInsertionOut<2>&);
extern template void insert_faces<3>(Index, const FaceInsertionIn<3>&, const FaceInsertionOut<3>&);

}  // namespace breccia
