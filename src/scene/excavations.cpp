#include "scene/excavations.hpp"

#include "step/selection.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace breccia {

template <int D>
std::vector<Index> excavation_of_elements(const Settings& scene, const Mesh<D>& mesh) {
  std::vector<Index> taken(mesh.element.size(), kNone);
  const std::vector<Settings>& sections = scene.list("excavate");
  if (sections.empty()) return taken;
  const Topology<D> topology = build_topology(mesh);
  for (std::size_t i = 0; i < sections.size(); ++i) {
    const Settings& section = sections[i];
    const std::string key = section.has("where") ? "where" : "box";
    const Region region = select_region(section, mesh, topology);
    if (region.elements.empty())
      throw section.error(key, "no element lies there", "name a body or a region with elements");
    for (const Index e : region.elements) {
      Index& by = taken[static_cast<std::size_t>(e)];
      if (by != kNone)
        throw section.error(key, fmt::format("element {} is taken out twice", e),
                            fmt::format("make its place and that of the one at {} apart",
                                        sections[static_cast<std::size_t>(by)].place()));
      by = static_cast<Index>(i);
    }
  }
  if (std::find(taken.begin(), taken.end(), kNone) == taken.end())
    throw sections.back().error("", "the excavations leave nothing of the scene",
                                "take out a part of it");
  return taken;
}

template std::vector<Index> excavation_of_elements(const Settings&, const Mesh<2>&);
template std::vector<Index> excavation_of_elements(const Settings&, const Mesh<3>&);

}  // namespace breccia
