#pragma once
#include "core/settings.hpp"
#include "mesh/mesh.hpp"
#include "mesh/topology.hpp"

namespace breccia {

/// The part of the mesh that a section names by one of `where` (body or region), `plane` or
/// `box`. Throws Error with the place when the name is unknown (nearest names given) or when
/// nothing lies there.
template <int D>
Region select_region(const Settings& section, const Mesh<D>& mesh, const Topology<D>& topology);

/// The region of that name; Error at `section`'s key `key` otherwise.
template <int D>
const Region& named_region(const Settings& section, const std::string& key, const std::string& name,
                           const Mesh<D>& mesh);

/// Adds a problem where the `box` of a section has its upper corner below the lower one.
void check_box(const Settings& section, Problems& problems);

}  // namespace breccia
