#include "mesh/composite.hpp"
#include "modules/fracture/existing_laws.hpp"
#include "modules/fracture/face_grades.hpp"
#include "modules/fracture/interface_laws.hpp"

#include <algorithm>

namespace breccia {

namespace {

/// What is taken out does not break, and neither does what it hangs on by.
template <int D>
std::vector<std::uint8_t> excavated(const Model<D>& model) {
  std::vector<std::uint8_t> taken(model.mesh.element.size(), 0);
  for (const Block& block : model.blocks)
    if (block.excavation != kNone)
      std::fill(taken.begin() + block.begin, taken.begin() + block.end, std::uint8_t{1});
  return taken;
}

}  // namespace

template <int D>
std::vector<Index> law_of_faces(const InterfaceLaws& laws, const Model<D>& model) {
  const auto composite = composite_of_elements(model.mesh);
  const std::vector<std::uint8_t> taken = excavated(model);
  const FaceGrades grades(laws);
  std::vector<Index> law;
  law.reserve(model.topology.shared.size());
  for (const SharedFace& face : model.topology.shared) {
    const bool inside = composite[face.left] == composite[face.right];
    const bool tied = inside || taken[face.left] || taken[face.right];
    const Index first = tied ? kNone
                             : laws.between(model.body_material[model.mesh.body[face.left]],
                                            model.body_material[model.mesh.body[face.right]]);
    law.push_back(first == kNone
                      ? kNone
                      : first + grades.of<D>(first, model.part.face_number(Index(law.size())),
                                             model.mesh, {face.left, face.left_face}));
  }
  put_existing_laws(laws, model, law);
  for (std::size_t f = 0; f < law.size(); ++f) {
    const SharedFace& face = model.topology.shared[f];
    if (taken[face.left] || taken[face.right] || composite[face.left] == composite[face.right])
      law[f] = kNone;
  }
  return law;
}

template std::vector<Index> law_of_faces(const InterfaceLaws&, const Model<2>&);
template std::vector<Index> law_of_faces(const InterfaceLaws&, const Model<3>&);

}  // namespace breccia
