#include "mesh/extract.hpp"

#include "core/text.hpp"
#include "mesh/face_table.hpp"
#include "mesh/refusal.hpp"
#include "mesh/region_builder.hpp"

#include <algorithm>
#include <map>

namespace breccia {
namespace {

template <int D>
std::string known_regions(const Mesh<D>& mesh) {
  std::string text;
  for (const Region& region : mesh.regions) {
    if (!region.elements.empty()) text += (text.empty() ? "" : ", ") + region.name;
  }
  return text.empty() ? "none" : text;
}

/// Per element the pick it goes to, or kNone.
template <int D>
std::vector<Index> assign_elements(const Mesh<D>& mesh, std::span<const BodyPick> picks,
                                   const std::string& source) {
  std::vector<Index> owner(mesh.element.size(), kNone);
  for (std::size_t b = 0; b < picks.size(); ++b) {
    if (picks[b].region.empty()) {
      std::fill(owner.begin(), owner.end(), static_cast<Index>(b));
      continue;
    }
    const Region* region = find_region(mesh, picks[b].region);
    if (!region || region->elements.empty()) {
      std::vector<std::string> names;
      for (const Region& r : mesh.regions) {
        if (!r.elements.empty()) names.push_back(r.name);
      }
      refuse(source,
             "it has no region \"" + picks[b].region + "\" of dimension " + std::to_string(D) +
                 " for body \"" + picks[b].name + "\"",
             "regions with elements: " + known_regions(mesh) + "." +
                 did_you_mean(picks[b].region, names));
    }
    for (Index e : region->elements) owner[e] = static_cast<Index>(b);
  }
  return owner;
}

std::string region_name(const BodyPick& pick, const std::string& name) {
  const std::string prefix = pick.region + ".";
  if (!pick.region.empty() && name.starts_with(prefix)) {
    return pick.name + "." + name.substr(prefix.size());
  }
  return pick.name + "." + name;
}

/// The elements with an owner, their points, and the old -> new numbers (kNone: left out).
template <int D>
struct Part {
  Mesh<D> mesh;
  std::vector<Index> point, element;
};

template <int D>
Part<D> cut_out(const Mesh<D>& from, const std::vector<Index>& owner) {
  Part<D> part;
  part.point.assign(from.point.size(), kNone);
  part.element.assign(from.element.size(), kNone);
  for (Index e = 0; e < from.elements(); ++e) {
    if (owner[e] == kNone) continue;
    for (Index p : from.element[e]) part.point[p] = 0;
  }
  for (Index p = 0; p < from.points(); ++p) {
    if (part.point[p] == kNone) continue;
    part.point[p] = part.mesh.points();
    part.mesh.point.push_back(from.point[p]);
  }
  std::vector<Index> kept;
  for (Index e = 0; e < from.elements(); ++e) {
    if (owner[e] == kNone) continue;
    kept.push_back(e);
    auto nodes = from.element[e];
    for (Index& p : nodes) p = part.point[p];
    part.element[e] = part.mesh.elements();
    part.mesh.element.push_back(nodes);
    part.mesh.body.push_back(owner[e]);
  }
  part.mesh.fields = fields_of(from.fields, kept);
  for (const auto& [edge, middle] : from.curved) {
    const Index a = part.point[edge[0]], b = part.point[edge[1]];
    if (a != kNone && b != kNone) part.mesh.curved[edge_of(a, b)] = middle;
  }
  return part;
}

/// Builders of the regions, one per (region, body): region * bodies + body.
template <int D>
class RegionCutter {
 public:
  RegionCutter(const Mesh<D>& from, const Part<D>& part, std::size_t bodies)
      : from_(from), part_(part), bodies_(bodies), builder_(from.regions.size() * bodies) {
    cut_faces();
    for (std::size_t r = 0; r < from.regions.size(); ++r) cut_elements_and_points(r);
  }

  RegionBuilder<D>& at(std::size_t region, std::size_t body) {
    return builder_[region * bodies_ + body];
  }

 private:
  std::array<Index, D> face_points(const Mesh<D>& mesh, const ElementFace& side) const {
    std::array<Index, D> points;
    for (int i = 0; i < D; ++i) points[i] = mesh.element[side.element][face_node<D>(side.face, i)];
    return points;
  }

  // A face between two bodies belongs to both, whichever element the region lists it from.
  void cut_faces() {
    std::map<std::array<Index, D>, std::vector<std::size_t>> regions_of;
    for (std::size_t r = 0; r < from_.regions.size(); ++r) {
      for (const ElementFace& side : from_.regions[r].faces) {
        auto points = face_points(from_, side);
        for (Index& p : points) p = part_.point[p];
        std::sort(points.begin(), points.end());
        if (points[0] != kNone) regions_of[points].push_back(r);
      }
    }
    if (regions_of.empty()) return;
    for_each_face(part_.mesh, [&](std::span<const ElementFace> sides) {
      auto points = face_points(part_.mesh, sides[0]);
      std::sort(points.begin(), points.end());
      const auto found = regions_of.find(points);
      if (found == regions_of.end()) return;
      for (std::size_t s = 0; s < sides.size(); ++s) {
        const Index body = part_.mesh.body[sides[s].element];
        const bool listed = s > 0 && part_.mesh.body[sides[s - 1].element] == body;
        if (listed) continue;
        for (std::size_t r : found->second) at(r, body).add_face(part_.mesh, sides[s]);
      }
    });
  }

  void cut_elements_and_points(std::size_t r) {
    std::vector<char> wanted(part_.mesh.point.size(), 0);
    for (Index p : from_.regions[r].points) {
      if (part_.point[p] != kNone) wanted[part_.point[p]] = 1;
    }
    for (Index e = 0; e < part_.mesh.elements(); ++e) {
      for (Index p : part_.mesh.element[e]) {
        if (wanted[p]) at(r, part_.mesh.body[e]).add_point(p);
      }
    }
    for (Index e : from_.regions[r].elements) {
      const Index n = part_.element[e];
      if (n != kNone) at(r, part_.mesh.body[n]).add_element(part_.mesh, n);
    }
  }

  const Mesh<D>& from_;
  const Part<D>& part_;
  std::size_t bodies_;
  std::vector<RegionBuilder<D>> builder_;
};

}  // namespace

template <int D>
Mesh<D> extract_bodies(const Mesh<D>& mesh, std::span<const BodyPick> picks,
                       const std::string& source) {
  auto part = cut_out(mesh, assign_elements(mesh, picks, source));
  std::vector<char> filled(picks.size(), 0);
  for (Index b : part.mesh.body) filled[b] = 1;
  for (std::size_t b = 0; b < picks.size(); ++b) {
    part.mesh.body_names.push_back(picks[b].name);
    if (filled[b]) continue;
    refuse(source, "no element is left for body \"" + picks[b].name + "\"",
           "later bodies of this part took all of it; change their order or regions");
  }
  RegionCutter<D> cutter(mesh, part, picks.size());
  Mesh<D> result = part.mesh;
  add_body_regions(result);
  for (std::size_t r = 0; r < mesh.regions.size(); ++r) {
    for (std::size_t b = 0; b < picks.size(); ++b) {
      const std::string& name = mesh.regions[r].name;
      if (name == picks[b].region || cutter.at(r, b).empty()) continue;
      Region region = cutter.at(r, b).finish(region_name(picks[b], name));
      // Points that merely touch a neighbour's region make no region here.
      const bool reaches = !region.elements.empty() || !region.faces.empty() ||
                           (mesh.regions[r].elements.empty() && mesh.regions[r].faces.empty());
      if (reaches) result.regions.push_back(std::move(region));
    }
  }
  return result;
}

template Mesh<2> extract_bodies<2>(const Mesh<2>&, std::span<const BodyPick>, const std::string&);
template Mesh<3> extract_bodies<3>(const Mesh<3>&, std::span<const BodyPick>, const std::string&);

}  // namespace breccia
