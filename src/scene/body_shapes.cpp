#include "scene/body_shapes.hpp"

#include <algorithm>
#include <cmath>

namespace breccia {

namespace {

template <int D>
Point<D> point_of(const std::vector<double>& v) {
  Point<D> p{};
  std::copy_n(v.begin(), D, p.begin());
  return p;
}

std::vector<Point<2>> outline_of(const Points& points) {
  std::vector<Point<2>> outline;
  for (const auto& p : points) outline.push_back(point_of<2>(p));
  return outline;
}

template <int D>
Point<D> far_corner(const Settings& brick) {
  Point<D> p = point_of<D>(brick.vector("corner"));
  for (int d = 0; d < D; ++d) p[d] += brick.vector("size")[d];
  return p;
}

Shape plane_shape(const Settings& shape) {
  if (shape.has("rectangle")) {
    const Settings& s = shape.at("rectangle");
    return Rectangle{point_of<2>(s.vector("corner")), far_corner<2>(s)};
  }
  if (shape.has("disc")) {
    const Settings& s = shape.at("disc");
    return Disc{point_of<2>(s.vector("centre")), 0.5 * s.number("diameter")};
  }
  const Settings& s = shape.at("polygon");
  Polygon polygon{outline_of(s.points("points")), {}};
  if (s.has("holes"))
    for (const Points& hole : s.lines("holes")) polygon.holes.push_back(outline_of(hole));
  return polygon;
}

Shape space_shape(const Settings& shape) {
  if (shape.has("box")) {
    const Settings& s = shape.at("box");
    return Box{point_of<3>(s.vector("corner")), far_corner<3>(s)};
  }
  if (shape.has("ball")) {
    const Settings& s = shape.at("ball");
    return Ball{point_of<3>(s.vector("centre")), 0.5 * s.number("diameter")};
  }
  const Settings& s = shape.at("cylinder");
  Point<3> axis = point_of<3>(s.vector("axis"));
  const double scale = s.number("length") / std::hypot(axis[0], axis[1], axis[2]);
  for (double& a : axis) a *= scale;
  return Cylinder{point_of<3>(s.vector("centre")), axis, 0.5 * s.number("diameter")};
}

Pattern pattern_of(const std::string& word, int dimension) {
  if (word == "right") return Pattern::right;
  if (word == "cross") return Pattern::cross;
  if (word == "union-jack") return Pattern::union_jack;
  if (word == "five") return Pattern::five;
  if (word == "kuhn") return Pattern::kuhn;
  return dimension == 2 ? Pattern::cross : Pattern::kuhn;
}

void read_refinements(const Settings& mesh, BodyShape& out) {
  for (const Settings& section : mesh.list("refine")) {
    Refinement refinement;
    const auto& at = section.vector("at");
    std::copy(at.begin(), at.end(), refinement.at.begin());
    refinement.radius = section.number("radius");
    refinement.size = section.number("size");
    if (section.has("transition")) refinement.transition = section.number("transition");
    out.refinements.push_back(refinement);
  }
}

}  // namespace

int group_size(const Settings& body) {
  const std::string kind = body.at("mesh").text_or("element", "");
  if (kind == "tri6c") return 4;
  if (kind == "tet10c") return 8;
  return kind == "tet10c12" ? 12 : 1;
}

template <int D>
BodyShape body_shape(const Settings& body, const std::filesystem::path& folder, int seed) {
  const Settings& shape = body.at("shape");
  const Settings& mesh = body.at("mesh");
  BodyShape out;
  out.name = body.name();
  out.seed = seed;
  out.part_of = body.text_or("part_of", "");
  out.curved = group_size(body) > 1;
  if (mesh.has("size")) out.size = mesh.number("size");
  if (shape.has("file")) {
    const std::filesystem::path path = folder / shape.text("file");  // an absolute one replaces it
    if (!std::filesystem::is_regular_file(path))
      throw shape.error("file", "there is no file " + path.string(), "check its name and folder");
    out.shape = MeshFile{path.string(), shape.text_or("region", "")};
  } else if constexpr (D == 2) {
    out.shape = plane_shape(shape);
  } else {
    out.shape = space_shape(shape);
  }
  read_refinements(mesh, out);
  if constexpr (D == 2)
    for (const Settings& line : mesh.list("embed"))
      out.lines.push_back({line.text("name"), outline_of(line.points("points"))});
  if (mesh.text("arrangement") == "regular") out.arrangement = Arrangement::regular;
  if (mesh.text("generator") == "structured") {
    out.pattern = pattern_of(mesh.text_or("pattern", ""), D);
    if (mesh.has("jitter")) out.jitter = mesh.number("jitter");
  }
  return out;
}

template <int D>
std::optional<Grid<D>> grid_of(const Settings& body, int seed) {
  const Settings& mesh = body.at("mesh");
  if (!mesh.has("cells")) return std::nullopt;
  const Settings& brick = body.at("shape").at(D == 2 ? "rectangle" : "box");
  Grid<D> grid;
  grid.lower = point_of<D>(brick.vector("corner"));
  grid.upper = far_corner<D>(brick);
  for (int d = 0; d < D; ++d) grid.cells[d] = static_cast<Index>(mesh.integers("cells")[d]);
  grid.pattern = pattern_of(mesh.text_or("pattern", ""), D);
  if (mesh.has("jitter")) grid.jitter = mesh.number("jitter");
  grid.seed = static_cast<std::uint64_t>(seed);
  grid.body = body.name();
  return grid;
}

template BodyShape body_shape<2>(const Settings&, const std::filesystem::path&, int);
template BodyShape body_shape<3>(const Settings&, const std::filesystem::path&, int);
template std::optional<Grid<2>> grid_of<2>(const Settings&, int);
template std::optional<Grid<3>> grid_of<3>(const Settings&, int);

}  // namespace breccia
