#pragma once

#include "mesh/mesh.hpp"

#include <span>
#include <string>

namespace breccia {

/// One body taken from a mesh: the elements of a region (all of them when empty) under a new name.
struct BodyPick {
  std::string name;
  std::string region;
};

/// The picked bodies as a mesh of their own; bodies that touched share their common points, an
/// element that two regions claim goes to the later pick. Regions of the mesh that touch a body
/// become "<body>.<region>", where a prefix "<picked region>." is replaced rather than repeated;
/// each body's own region is added. Throws Error at `source`: unknown region with the known ones, a
/// body without elements.
template <int D>
Mesh<D> extract_bodies(const Mesh<D>& mesh, std::span<const BodyPick> picks,
                       const std::string& source);

}  // namespace breccia
