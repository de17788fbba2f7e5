#pragma once
#include "step/model.hpp"

#include <filesystem>
#include <vector>

namespace breccia {

/// The bodies of the scene as one mesh, checked, before any renumbering. Files are looked for
/// beside the scene, in `folder`. Throws Error.
template <int D>
Mesh<D> build_mesh(const Settings& scene, const std::filesystem::path& folder);

/// Sub-elements of each composite, per body of the mesh; 1 where elements are simple.
template <int D>
std::vector<int> group_sizes(const Settings& scene, const Mesh<D>& mesh);

/// Counts of nodes, corners, elements, families and materials, and room for more.
template <int D>
void size_store(Model<D>& model);

/// Mesh, topology, materials and blocks of a scene; sizes of the store's entities.
template <int D>
void build_model(const Settings& scene, const std::filesystem::path& folder, Model<D>& model);

}  // namespace breccia
