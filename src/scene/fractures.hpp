#pragma once
#include "core/settings.hpp"
#include "mesh/shapes.hpp"

#include <filesystem>

namespace breccia {

/// The fractures that [[fractures]] put into a body.
std::vector<FractureNet> fractures_of(const Settings& scene, const std::filesystem::path& folder,
                                      const BodyShape& body, int dimension);

/// Finds the faces of all [[fractures]] in the finished mesh and cuts it along the open ones.
template <int D>
void place_fractures(const Settings& scene, std::span<const BodyShape> bodies, Mesh<D>& mesh);

}  // namespace breccia
