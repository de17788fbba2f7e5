#pragma once
#include "core/settings.hpp"
#include "mesh/shapes.hpp"

#include <filesystem>
#include <optional>

namespace breccia {

/// A [[body]] section as the mesh builders want it.
template <int D>
BodyShape body_shape(const Settings& body, const std::filesystem::path& folder, int seed);

/// Sub-elements of each composite of a body (base/composite.hpp), 1 for simple elements.
int group_size(const Settings& body);

/// The structured grid of a body whose scene gives `mesh.cells`.
template <int D>
std::optional<Grid<D>> grid_of(const Settings& body, int seed);

}  // namespace breccia
