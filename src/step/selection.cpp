#include "step/selection.hpp"

#include "core/text.hpp"
#include "mesh/select.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace breccia {

namespace {

template <int D>
Point<D> point_of(const std::vector<double>& v) {
  Point<D> p{};
  std::copy_n(v.begin(), D, p.begin());
  return p;
}

}  // namespace

template <int D>
const Region& named_region(const Settings& section, const std::string& key, const std::string& name,
                           const Mesh<D>& mesh) {
  if (const Region* region = find_region(mesh, name)) return *region;
  std::vector<std::string> names;
  for (const Region& region : mesh.regions) names.push_back(region.name);
  throw section.error(
      key, fmt::format("no body or region is called '{}'.{}", name, did_you_mean(name, names)),
      "the scene has: " + join(names));
}

template <int D>
Region select_region(const Settings& section, const Mesh<D>& mesh, const Topology<D>& topology) {
  Region region;
  std::string key = "where";
  if (section.has("where")) {
    region = named_region(section, "where", section.text("where"), mesh);
  } else if (section.has("plane")) {
    key = "plane";
    const Settings& plane = section.at("plane");
    PlaneSelector<D> selector{point_of<D>(plane.vector("point")),
                              point_of<D>(plane.vector("normal")), 1e-6 * extent_of(mesh)};
    if (plane.has("tolerance")) selector.tolerance = plane.number("tolerance");
    region = select(mesh, topology, selector);
  } else {
    key = "box";
    const Settings& box = section.at("box");
    region =
        select(mesh, topology,
               BoxSelector<D>{point_of<D>(box.vector("lower")), point_of<D>(box.vector("upper"))});
  }
  if (region.points.empty() && !mesh.partial)
    throw section.error(key, "no node of the mesh lies there",
                        "move or enlarge it; `breccia check` prints the extent of every body");
  return region;
}

void check_box(const Settings& section, Problems& problems) {
  if (!section.has("box")) return;
  const Settings& box = section.at("box");
  const auto &lower = box.vector("lower"), &upper = box.vector("upper");
  for (std::size_t d = 0; d < lower.size(); ++d) {
    if (lower[d] <= upper[d]) continue;
    problems.add(box.error("upper", number_text(upper[d]) + " m is below lower, " +
                                        number_text(lower[d]) + " m, along " + "xyz"[d]));
    break;
  }
}

template Region select_region(const Settings&, const Mesh<2>&, const Topology<2>&);
template Region select_region(const Settings&, const Mesh<3>&, const Topology<3>&);
template const Region& named_region(const Settings&, const std::string&, const std::string&,
                                    const Mesh<2>&);
template const Region& named_region(const Settings&, const std::string&, const std::string&,
                                    const Mesh<3>&);

}  // namespace breccia
