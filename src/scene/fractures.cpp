#include "scene/fractures.hpp"

#include "mesh/fracture_faces.hpp"
#include "mesh/fracture_files.hpp"
#include "mesh/fracture_sets.hpp"
#include "mesh/grains.hpp"

#include <algorithm>
#include <cmath>

namespace breccia {

namespace {

Point<3> point_of(const std::vector<double>& v) {
  Point<3> p{};
  std::copy_n(v.begin(), std::min<std::size_t>(v.size(), 3), p.begin());
  return p;
}

/// Direction of traces in the plane, of normals in space.
Point<3> direction_of(const Settings& s, int dimension) {
  if (dimension == 3) return point_of(s.vector("normal"));
  const double dip = s.number("dip");
  return {std::cos(dip), std::sin(dip), 0};
}

FractureSet set_of(const Settings& s, const Settings& scene, int dimension, std::uint32_t stream) {
  FractureSet set;
  if (s.has("number")) set.number = static_cast<int>(s.integer("number"));
  if (s.has("intensity")) set.intensity = s.number("intensity");
  set.length = {s.number("shortest"), s.number("longest"),
                s.text("lengths") == "power_law" ? s.number("exponent") : 0.0};
  const std::string orientation = s.text("orientation");
  set.parallel = orientation == "parallel";
  if (orientation != "uniform") set.direction = direction_of(s, dimension);
  if (orientation == "scattered") set.concentration = s.number("concentration");
  set.seed = static_cast<std::uint64_t>(s.has("seed") ? s.integer("seed")
                                                      : scene.at("run").integer("seed"));
  set.stream = stream;
  return set;
}

std::vector<FracturePiece> pieces_of(const Settings& s, const Settings& scene,
                                     const std::filesystem::path& folder, const BodyShape& body,
                                     int dimension, std::uint32_t stream) {
  std::vector<FracturePiece> pieces;
  if (s.has("lines")) {
    for (const Points& line : s.lines("lines")) {
      std::vector<Point<3>> points;
      for (const auto& x : line) points.push_back(point_of(x));
      add_pieces(dimension, points, pieces);
    }
  } else if (s.has("file")) {
    pieces = read_fractures((folder / s.text("file")).string(), dimension, s.number("scale"));
  } else if (s.has("disc")) {
    const double size = s.has("size") ? s.number("size") : body.size;
    for (const Settings& disc : s.list("disc"))
      pieces.push_back(disc_piece(point_of(disc.vector("centre")), point_of(disc.vector("normal")),
                                  0.5 * disc.number("diameter"), size));
  } else if (s.has("planes")) {
    const Settings& planes = s.at("planes");
    pieces = parallel_planes(dimension, body, planes.number("spacing"),
                             direction_of(planes, dimension), point_of(planes.vector("through")));
  } else if (s.has("grains")) {
    const Settings& grains = s.at("grains");
    const auto seed = grains.has("seed") ? grains.integer("seed") : scene.at("run").integer("seed");
    pieces = grain_edges(body, grains.number("size"), grains.number("jitter"),
                         static_cast<std::uint64_t>(seed));
  } else {
    std::vector<FracturePiece> others;
    for (const FractureNet& net : body.fractures)
      others.insert(others.end(), net.pieces.begin(), net.pieces.end());
    pieces = draw_fractures(dimension, set_of(s.at("set"), scene, dimension, stream), body, others);
  }
  return pieces;
}

}  // namespace

std::vector<FractureNet> fractures_of(const Settings& scene, const std::filesystem::path& folder,
                                      const BodyShape& body, int dimension) {
  BodyShape grown = body;  // later sets keep clear of earlier ones
  std::uint32_t stream = 0;
  for (const Settings& s : scene.list("fractures")) {
    ++stream;
    if (s.text("body") != body.name) continue;
    FractureNet net;
    net.name = s.name();
    if (s.has("size")) net.size = s.number("size");
    if (s.has("growth")) net.growth = s.number("growth");
    net.drawn = s.has("set") || s.has("planes") || s.has("grains");
    net.pieces = pieces_of(s, scene, folder, grown, dimension, stream);
    grown.fractures.push_back(net);
  }
  return grown.fractures;
}

template <int D>
void place_fractures(const Settings& scene, std::span<const BodyShape> bodies, Mesh<D>& mesh) {
  for (const BodyShape& body : bodies) {
    const bool gmsh = !body.pattern && !std::holds_alternative<MeshFile>(body.shape);
    const Index number = find_body(mesh, body.name);
    for (const FractureNet& net : body.fractures) add_fracture_region(mesh, number, net, gmsh);
  }
  for (const Settings& s : scene.list("fractures"))
    if (s.text("kind") == "open") cut_open(mesh, s.text("body") + "." + s.name());
}

template void place_fractures<2>(const Settings&, std::span<const BodyShape>, Mesh<2>&);
template void place_fractures<3>(const Settings&, std::span<const BodyShape>, Mesh<3>&);

}  // namespace breccia
