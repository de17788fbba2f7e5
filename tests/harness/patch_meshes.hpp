#pragma once
#include "mesh/mesh.hpp"

#include <string>

namespace breccia {

// The patches of MacNeal and Harder (1985), "A proposed standard set of problems to test finite
// element accuracy", doi:10.1016/0168-874X(85)90003-4, cut into simplices; text of Gmsh files.

std::string macneal_harder_plane();
std::string macneal_harder_space();

}  // namespace breccia
