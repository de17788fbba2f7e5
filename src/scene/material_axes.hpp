#pragma once
#include "core/schema.hpp"
#include "step/model.hpp"

namespace breccia {

/// Declares [[axes]].
void declare_axes(Schema& schema);

/// Material axes of every element as columns, from the [[axes]] sections; empty where the scene has
/// none. Elements that no section names have those of the coordinates. Sub-elements of a composite
/// have the axes of its centroid.
/// \throws Error: a section names no element, one that has axes already, or directions that do not
/// span axes.
template <int D>
std::vector<Mat<D>> material_axes(const Settings& scene, const Model<D>& model);

}  // namespace breccia
