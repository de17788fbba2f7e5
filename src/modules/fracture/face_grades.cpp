#include "modules/fracture/face_grades.hpp"

#include "base/simplex.hpp"
#include "mesh/geometry.hpp"
#include "modules/fracture/strength_grades.hpp"

namespace breccia {

namespace {

template <int D>
std::array<double, 3> middle_of(const Mesh<D>& mesh, const ElementFace& face) {
  const Simplex<D> x = corners<D>(mesh, face.element);
  std::array<double, 3> middle{};
  for (int c = 0; c < D; ++c)
    for (std::size_t d = 0; d < D; ++d) middle[d] += x[face_node<D>(face.face, c)][d] / D;
  return middle;
}

}  // namespace

FaceGrades::FaceGrades(const InterfaceLaws& laws) : laws_(laws) {
  for (const double length : laws.correlation)
    if (length > 0) fields_.try_emplace(length, laws.seed, length);
}

template <int D>
Index FaceGrades::of(Index law, std::size_t number, const Mesh<D>& mesh,
                     const ElementFace& face) const {
  const auto i = static_cast<std::size_t>(law);
  const Index grades = laws_.grades[i];
  if (grades == 1) return 0;
  if (laws_.correlation[i] == 0) return grade_of_face(laws_.seed, number, grades);
  return grade_at(fields_.at(laws_.correlation[i]).share(middle_of<D>(mesh, face)), grades);
}

template Index FaceGrades::of<2>(Index, std::size_t, const Mesh<2>&, const ElementFace&) const;
template Index FaceGrades::of<3>(Index, std::size_t, const Mesh<3>&, const ElementFace&) const;

}  // namespace breccia
