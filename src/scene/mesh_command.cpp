// breccia mesh: the mesh of a scene as a file.
#include "core/log.hpp"
#include "io/mesh_file.hpp"
#include "mesh/composite.hpp"
#include "mesh/order.hpp"
#include "mesh/quality.hpp"
#include "scene/commands.hpp"
#include "scene/model_builder.hpp"
#include "scene/scene.hpp"

#include <fmt/format.h>

namespace breccia {

namespace {

template <int D>
int write(const Scene& scene, const std::filesystem::path& output) {
  const Mesh<D> raw = build_mesh<D>(scene.settings, scene.folder);
  const Mesh<D> mesh = reordered(raw, locality_order(raw));
  write_mesh(mesh, output.string());
  log::info(
      fmt::format("{}: {} elements, {} points", output.string(), mesh.elements(), mesh.points()));
  const auto report =
      assess_quality(refined_to_composites(mesh, group_sizes(scene.settings, mesh)));
  if (report.composites > 0)
    log::info(fmt::format(
        "{} of them are composites when the scene runs: then {} sub-elements, {} points{}",
        report.composites, report.elements, report.points,
        mesh.curved.empty() ? "" : "; the file keeps their curved edges"));
  return 0;
}

}  // namespace

int mesh_scene(const MeshRequest& request) {
  const Scene scene = read_and_resolve(request.scene, request.options);
  return scene.dimension() == 2 ? write<2>(scene, request.output) : write<3>(scene, request.output);
}

}  // namespace breccia
