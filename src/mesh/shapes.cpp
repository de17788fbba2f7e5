#include "mesh/shapes.hpp"

#include "core/log.hpp"
#include "mesh/check_shapes.hpp"
#include "mesh/extract.hpp"
#include "mesh/fracture_faces.hpp"
#include "mesh/geometry.hpp"
#include "mesh/gmsh_mesher.hpp"
#include "mesh/msh_reader.hpp"
#include "mesh/refusal.hpp"
#include "mesh/region_builder.hpp"
#include "mesh/sides.hpp"
#include "mesh/validate.hpp"

#include <map>

namespace breccia {
namespace {

using Part = std::vector<const BodyShape*>;

std::vector<Part> parts_of(std::span<const BodyShape> bodies) {
  std::vector<Part> parts;
  std::map<std::string, std::size_t> place;
  for (const BodyShape& body : bodies) {
    if (body.part_of.empty()) {
      parts.push_back({&body});
      continue;
    }
    const auto [found, fresh] = place.emplace(body.part_of, parts.size());
    if (fresh) parts.emplace_back();
    parts[found->second].push_back(&body);
  }
  return parts;
}

template <int D>
Mesh<D> mesh_structured(const BodyShape& body) {
  Grid<D> grid;
  if constexpr (D == 2) {
    const auto& r = std::get<Rectangle>(body.shape);
    grid.lower = r.lower;
    grid.upper = r.upper;
  } else {
    const auto& b = std::get<Box>(body.shape);
    grid.lower = b.lower;
    grid.upper = b.upper;
  }
  grid.cells = cells_of_size<D>(grid.lower, grid.upper, body.size);
  grid.pattern = *body.pattern;
  grid.jitter = body.jitter;
  grid.seed = static_cast<std::uint64_t>(body.seed);
  grid.body = body.name;
  Mesh<D> mesh = structured_mesh(grid);
  if constexpr (D == 2) add_line_regions(mesh, 0, body.lines);
  return mesh;
}

template <int D>
void orient(Mesh<D>& mesh) {
  // The geometry kernel is free in the direction of its surfaces; regions are built afterwards.
  for (Index e = 0; e < mesh.elements(); ++e) {
    if (signed_volume<D>(corners(mesh, e)) < 0) {
      std::swap(mesh.element[e][D - 1], mesh.element[e][D]);
    }
  }
}

template <int D>
Mesh<D> mesh_by_gmsh(const Part& part) {
  const std::string source = "body \"" + part[0]->name + "\"";
  Mesh<D> whole = to_mesh<D>(gmsh_mesh(D, part), source);
  orient(whole);
  std::vector<BodyPick> picks;
  for (const BodyShape* body : part) picks.push_back({body->name, body->name});
  Mesh<D> mesh = extract_bodies<D>(whole, picks, source);
  for (std::size_t b = 0; b < part.size(); ++b) {
    const auto body = static_cast<Index>(b);
    add_side_regions(mesh, body, part[b]->shape);
    if constexpr (D == 2) add_line_regions(mesh, body, part[b]->lines);
  }
  validate(mesh, source);
  return mesh;
}

template <int D>
Mesh<D> read_file(const BodyShape& body, const NativeReader<D>& native) {
  const std::string& path = std::get<MeshFile>(body.shape).path;
  if (path.ends_with(".h5")) {
    if (!native) refuse(path, "this build cannot read HDF5", "give a .msh file");
    return native(path);
  }
  if (path.ends_with(".geo")) return to_mesh<D>(gmsh_open(path, D, body.size, body.curved), path);
  const bool own = is_ascii_msh(path);  // Gmsh reads the rest: binary and older versions
  return to_mesh<D>(own ? read_msh(path) : gmsh_open(path, D, body.size, body.curved), path);
}

template <int D>
Mesh<D> mesh_from_file(const Part& part, const NativeReader<D>& native) {
  const std::string& path = std::get<MeshFile>(part[0]->shape).path;
  std::vector<BodyPick> picks;
  for (const BodyShape* body : part) {
    picks.push_back({body->name, std::get<MeshFile>(body->shape).region});
  }
  Mesh<D> whole = read_file<D>(*part[0], native);
  if (!part[0]->curved && !whole.curved.empty()) {
    log::info(path + ": its curved edges are made straight; composites would follow them");
    whole.curved.clear();
  }
  if (orient_if_all_mirrored(whole)) {
    log::info(path + ": all elements are oriented negatively; they were turned over");
  }
  Mesh<D> mesh = extract_bodies<D>(whole, picks, path);
  validate(mesh, path);
  return mesh;
}

template <int D>
Mesh<D> mesh_part(const Part& part, const NativeReader<D>& native) {
  check_part(D, part);
  for (const BodyShape* body : part) check_fractures(D, *body);
  if (std::holds_alternative<MeshFile>(part[0]->shape)) return mesh_from_file<D>(part, native);
  if (part[0]->pattern) return mesh_structured<D>(*part[0]);
  return mesh_by_gmsh<D>(part);
}

/// Numbers the bodies as the caller listed them; meshing went part by part.
template <int D>
void restore_order(std::span<const BodyShape> bodies, Mesh<D>& mesh) {
  std::vector<Index> number(bodies.size());
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    number[find_body(mesh, bodies[b].name)] = static_cast<Index>(b);
  }
  for (Index& b : mesh.body) b = number[b];
  for (std::size_t b = 0; b < bodies.size(); ++b) mesh.body_names[b] = bodies[b].name;
}

}  // namespace

template <int D>
Mesh<D> mesh_bodies(std::span<const BodyShape> bodies, const NativeReader<D>& native) {
  Mesh<D> mesh;
  for (const Part& part : parts_of(bodies)) append(mesh, mesh_part<D>(part, native));
  restore_order(bodies, mesh);
  return mesh;
}

template Mesh<2> mesh_bodies<2>(std::span<const BodyShape>, const NativeReader<2>&);
template Mesh<3> mesh_bodies<3>(std::span<const BodyShape>, const NativeReader<3>&);

}  // namespace breccia
