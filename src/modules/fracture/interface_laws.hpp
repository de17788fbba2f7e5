#pragma once
#include "loops/interface_views.hpp"
#include "step/model.hpp"

#include <string>
#include <utility>
#include <vector>

namespace breccia {

/// The law of a fracture that was there before, and those of its patches, which go first.
struct ExistingLaw {
  const Settings* section = nullptr;  ///< of [[fractures]]
  Index law = kNone;
  std::vector<std::pair<const Settings*, Index>> patches;
};

/// The law of the faces between grains of one material.
struct GrainLaw {
  const Settings* section = nullptr;  ///< [fracture.NAME.grains]
  std::string material;
  Index law = kNone;
};

/// The laws of a scene and which faces each belongs to.
struct InterfaceLaws {
  std::vector<InterfaceLaw> laws;
  std::vector<const Settings*> sections;  ///< where each was read
  std::vector<Index> grades;              ///< laws of that section: 1, or grades of strength
  std::vector<double> correlation;        ///< m, of the grades; 0: each face for itself
  std::vector<Index> of_materials;  ///< the first one, at left * materials + right; kNone: tied
  std::vector<ExistingLaw> existing;
  std::vector<GrainLaw> grain_laws;
  Index materials = 0;
  int seed = 0;  ///< of the scene

  Index between(Index left, Index right) const {
    return of_materials[static_cast<std::size_t>(left * materials + right)];
  }
};

/// Appends the law of a section, one for each grade of strength; returns the first.
Index append_laws(InterfaceLaws& laws, const Settings& section);

/// Reads [fracture.*], [[interface]] and [[fractures]]. Throws Error with place.
InterfaceLaws read_interface_laws(const Settings& scene, const std::vector<Material>& materials);

/// The law of each shared face; kNone where no law belongs to its materials and inside composites,
/// which never break.
template <int D>
std::vector<Index> law_of_faces(const InterfaceLaws& laws, const Model<D>& model);

/// Springs are made of these; per material.
template <int D>
std::vector<InterfaceSide> interface_sides(const Model<D>& model);

/// Refuses laws that the mesh cannot follow: a face whose stored energy at the peak exceeds what
/// breaking it may take. Warns where the softening zone is shorter than three elements.
/// Throws Error naming the number and the remedy.
template <int D>
void check_interface_laws(const InterfaceLaws& laws, const Model<D>& model);

/// Bound on the stress in the elements of a material below which none of its faces can reach its
/// onset; all zero where every face of the material is inserted at the start or tied.
Onset watch_for(const InterfaceLaws& laws, Index material);

}  // namespace breccia
