#pragma once
#include "modules/fracture/correlated_field.hpp"
#include "modules/fracture/interface_laws.hpp"

#include <map>

namespace breccia {

/// Which grade of its law a face has: for itself, or by a field in space.
class FaceGrades {
 public:
  explicit FaceGrades(const InterfaceLaws& laws);

  /// Of a law's grades, counted from the first; `number` is that of the shared face.
  template <int D>
  Index of(Index law, std::size_t number, const Mesh<D>& mesh, const ElementFace& face) const;

 private:
  const InterfaceLaws& laws_;
  std::map<double, CorrelatedField> fields_;  ///< by length
};

}  // namespace breccia
