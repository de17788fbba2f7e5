#include "scene/model_builder.hpp"

#include "base/mat.hpp"
#include "io/mesh_file.hpp"
#include "mesh/composite.hpp"
#include "mesh/order.hpp"
#include "mesh/overlap.hpp"
#include "mesh/validate.hpp"
#include "scene/body_copies.hpp"
#include "scene/body_shapes.hpp"
#include "scene/excavations.hpp"
#include "scene/fractures.hpp"
#include "scene/initial_stress.hpp"
#include "scene/material_axes.hpp"

#include <algorithm>

namespace breccia {

namespace {

/// Room behind the last element: loops read a whole SIMD register of elements at a time.
constexpr Index kElementRoom = 16;

/// Room for nodes that splitting makes, before the store has to grow.
constexpr double kNodeRoom = 1.3;

constexpr Index kLargestGroup = 12;

/// The number of a body's material; rigid bodies have one of their own, made when it is asked for.
template <int D>
Index material_index(Model<D>& model, const Settings& body) {
  const auto find = [&](bool rigid) {
    return std::find_if(model.materials.begin(), model.materials.end(), [&](const Material& m) {
      return m.name == body.text("material") && m.rigid == rigid;
    });
  };
  const bool rigid = body.flag("rigid");
  auto found = find(rigid);
  if (rigid && found == model.materials.end() && find(false) != model.materials.end()) {
    model.materials.push_back(rigid_material(*find(false)));
    found = model.materials.end() - 1;
  }
  if (found != model.materials.end()) return static_cast<Index>(found - model.materials.begin());
  throw body.error("material", "there is no [material." + body.text("material") + "]");
}

/// Contiguous runs of elements of one material and one kind that stay or go together.
template <int D>
std::vector<Block> find_blocks(const Model<D>& model, const std::vector<Index>& excavation) {
  std::vector<Block> blocks;
  for (Index e = 0; e < model.mesh.elements(); ++e) {
    const Index material = model.body_material[model.mesh.body[e]];
    const int group = model.mesh.group_of_body(model.mesh.body[e]);
    if (blocks.empty() || blocks.back().material != material || blocks.back().group != group ||
        blocks.back().excavation != excavation[e])
      blocks.push_back({e, e, material, group, excavation[e], {}});
    blocks.back().end = e + 1;
  }
  return blocks;
}

}  // namespace

template <int D>
void size_store(Model<D>& model) {
  const Index points = model.mesh.points(), elements = model.mesh.elements();
  const bool may_split = model.scene->has("fracture") || !model.scene->list("interface").empty() ||
                         !model.scene->list("fractures").empty();
  const auto room = may_split ? static_cast<Index>(kNodeRoom * points) : points;
  model.store.set_size(Entity::node, points, room);
  model.store.set_size(Entity::corner, elements * (D + 1), elements * (D + 1));
  model.store.set_size(Entity::element, elements, elements + kElementRoom);
  model.store.set_size(Entity::family, points, points);
  const auto materials = static_cast<Index>(model.materials.size());
  model.store.set_size(Entity::material, materials, materials);
}

template <int D>
Mesh<D> build_mesh(const Settings& scene, const std::filesystem::path& folder) {
  const int seed = static_cast<int>(scene.at("run").integer("seed"));
  Mesh<D> mesh;
  std::vector<BodyShape> shapes, all;
  for (const Settings& body : scene.list("body")) {
    BodyShape shape = body_shape<D>(body, folder, seed);
    shape.fractures = fractures_of(scene, folder, shape, D);
    if (const auto grid = grid_of<D>(body, seed))
      append(mesh, structured_mesh(*grid));
    else
      shapes.push_back(shape);
    all.push_back(std::move(shape));
  }
  if (!shapes.empty())
    append(mesh,
           mesh_bodies<D>(shapes, [](const std::string& path) { return read_mesh<D>(path); }));
  validate(mesh, "the scene's mesh");
  place_fractures(scene, all, mesh);
  make_copies(scene, mesh);
  refuse_overlap(mesh);
  return mesh;
}

template <int D>
std::vector<int> group_sizes(const Settings& scene, const Mesh<D>& mesh) {
  std::vector<int> groups(mesh.body_names.size(), 1);
  for (const Settings& body : scene.list("body"))
    groups[find_body(mesh, body.name())] = group_size(body);
  return groups;
}

template <int D>
void build_model(const Settings& scene, const std::filesystem::path& folder, Model<D>& model) {
  model.scene = &scene;
  model.materials = read_materials(scene);
  model.mixed = scene.at("run").text("precision") == "mixed";
  if (D == 2) {
    model.thickness = scene.at("run").number("thickness");
    model.plane_stress = scene.at("run").text("plane") == "stress";
  }
  Mesh<D> mesh = build_mesh<D>(scene, folder);
  model.body_material.assign(mesh.body_names.size(), 0);
  for (const Settings& body : scene.list("body"))
    model.body_material[find_body(mesh, body.name())] = material_index(model, body);
  const auto groups = group_sizes(scene, mesh);
  const std::vector<Index> excavation = excavation_of_elements(scene, mesh);
  const auto parts = static_cast<Index>(scene.list("excavate").size()) + 1;
  std::vector<Index> block;
  for (std::size_t e = 0; e < mesh.body.size(); ++e)
    block.push_back(
        (model.body_material[mesh.body[e]] * (kLargestGroup + 1) + groups[mesh.body[e]]) * parts +
        excavation[e] + 1);
  const Ordering order = locality_order(mesh, block);
  std::vector<Index> taken;  // sub-elements go with their composite
  for (const Index e : order.element)
    taken.insert(taken.end(), static_cast<std::size_t>(groups[mesh.body[e]]), excavation[e]);
  model.mesh = refined_to_composites(reordered(mesh, order), groups);
  model.topology = build_topology(model.mesh);
  model.blocks = find_blocks(model, taken);
  model.initial_stress = initial_stress(scene, model);
  model.axes = material_axes(scene, model);
  size_store(model);
}

template Mesh<2> build_mesh<2>(const Settings&, const std::filesystem::path&);
template Mesh<3> build_mesh<3>(const Settings&, const std::filesystem::path&);
template void size_store(Model<2>&);
template void size_store(Model<3>&);
template std::vector<int> group_sizes(const Settings&, const Mesh<2>&);
template std::vector<int> group_sizes(const Settings&, const Mesh<3>&);
template void build_model(const Settings&, const std::filesystem::path&, Model<2>&);
template void build_model(const Settings&, const std::filesystem::path&, Model<3>&);

}  // namespace breccia
