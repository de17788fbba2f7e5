#pragma once

#include "mesh/fracture_net.hpp"
#include "mesh/mesh.hpp"
#include "mesh/structured.hpp"

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <variant>
#include <vector>

namespace breccia {

struct Rectangle {
  Point<2> lower, upper;
};
struct Disc {
  Point<2> centre;
  double radius;
};
/// Outer loop and holes, each without repeating its first point; either direction.
struct Polygon {
  std::vector<Point<2>> outer;
  std::vector<std::vector<Point<2>>> holes;
};
struct Box {
  Point<3> lower, upper;
};
struct Ball {
  Point<3> centre;
  double radius;
};
/// From the centre of one end along `axis` (its length is the cylinder's length).
struct Cylinder {
  Point<3> centre, axis;
  double radius;
};
/// A mesh (.msh, or .h5 in Breccia's own format) or a Gmsh script (.geo). With `region` only that
/// physical group, body or region is taken.
struct MeshFile {
  std::string path;
  std::string region;
};
using Shape = std::variant<Rectangle, Disc, Polygon, Box, Ball, Cylinder, MeshFile>;

/// Element size `size` within `radius` of `at` (third coordinate unused in the plane), growing
/// linearly to the body's own size over `transition` (m; 0: so far that the size grows by 0.3 per
/// unit length).
struct Refinement {
  std::array<double, 3> at{};
  double radius = 0;
  double size = 0;
  double transition = 0;
};

/// A polyline that the mesh must follow (plane only): a joint or a pre-existing crack. Its faces
/// become the region "<body>.<name>".
struct EmbeddedLine {
  std::string name;
  std::vector<Point<2>> points;
};

/// How Gmsh lays triangles out (measured in docs/method/mesh.md). `irregular` has edges in all
/// directions alike, as fracture needs. `quick` is six times faster, with a slight preference for
/// three directions. `regular` has the best triangles, nearly all along three directions.
enum class Arrangement { irregular, quick, regular };

/// One body as the scene describes it. Lengths in m.
struct BodyShape {
  std::string name;
  Shape shape;
  double size = 0;      ///< element size; not used for files with elements
  std::string part_of;  ///< bodies with equal, non-empty part_of share the points of common faces
  std::vector<Refinement> refinements;
  std::vector<EmbeddedLine> lines;
  std::vector<FractureNet> fractures;  ///< Gmsh follows them
  std::optional<Pattern> pattern;      ///< rectangle and box: structured grid instead of Gmsh
  double jitter = 0;                   ///< of the structured grid
  Arrangement arrangement = Arrangement::irregular;  ///< of a part: its first body's
  int seed = 1;                                      ///< other seeds give other meshes
  bool curved = false;  ///< mid-edge nodes on the geometry (Mesh::curved); of a part: as one
};

/// Reads a mesh in Breccia's own format, which io can and mesh cannot (hdf5.h has its door there).
template <int D>
using NativeReader = std::function<Mesh<D>(const std::string& path)>;

/// Meshes all bodies into one mesh, in the order given: structured grids by ourselves, everything
/// else by Gmsh. Where bodies with the same `part_of` overlap, the later one takes the common part.
///
/// Regions: each body; the sides of rectangle and box (structured.hpp); "<body>.rim" of a disc,
/// "<body>.surface" of a ball, "<body>.start", ".end" and ".side" of a cylinder, "<body>.side<i>"
/// (edge i runs from point i to i + 1) and "<body>.hole<i>" of a polygon; embedded lines; physical
/// groups of files as "<body>.<group>".
///
/// Throws Error naming the body: shape of the wrong dimension, size not positive, unreadable file,
/// unknown physical group, Gmsh missing from the build, Gmsh's own message.
template <int D>
Mesh<D> mesh_bodies(std::span<const BodyShape> bodies, const NativeReader<D>& native = {});

/// Whether this build can call Gmsh, and its version ("4.8.4", or "").
bool gmsh_available();
std::string gmsh_version();

}  // namespace breccia
