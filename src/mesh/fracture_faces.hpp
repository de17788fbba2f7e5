#pragma once

#include "mesh/shapes.hpp"

namespace breccia {

/// Refuses fractures that no good mesh can follow: pieces without extent, that coincide, that cross
/// or end near one another so that slivers would be left, or that end just below the surface of
/// their body. Throws Error naming them and the remedy.
void check_fractures(int dimension, const BodyShape& body);

/// Why a piece cannot end where it does in a body, or "": it ends closer than a tenth of an element
/// below the surface, or runs along it at less than 5 degrees.
std::string conflict_with_surface(const BodyShape& body, const FracturePiece& piece);

/// Adds "<body>.<name>": the faces inside the body that lie on a piece. Where the mesh was made for
/// the fractures, the part of a piece inside the body is covered; it is told what was cut off.
/// Elsewhere (`made_for_them` false) pieces that are not made of faces are refused.
template <int D>
void add_fracture_region(Mesh<D>& mesh, Index body, const FractureNet& net, bool made_for_them);

/// Doubles the points on the faces of a region, so that both sides of it become surface. Points at
/// a rim inside the body stay whole.
template <int D>
void cut_open(Mesh<D>& mesh, const std::string& region);

}  // namespace breccia
