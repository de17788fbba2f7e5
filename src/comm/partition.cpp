#include "comm/partition.hpp"

#include "core/error.hpp"

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <utility>

#if BRECCIA_WITH_METIS
#include <metis.h>
#endif

namespace breccia {

namespace {

#if BRECCIA_WITH_METIS
/// Graph of clusters in METIS's form: neighbours of cluster c are next[start[c]] to
/// next[start[c + 1] - 1], joined by as many faces as `faces` says.
struct Graph {
  std::vector<idx_t> start, next, faces, elements;

  template <int D>
  Graph(const Topology<D>& topology, const std::vector<Index>& cluster) {
    std::vector<std::pair<idx_t, idx_t>> links;
    for (const SharedFace& face : topology.shared) {
      const idx_t a = cluster[face.left], b = cluster[face.right];
      if (a == b) continue;
      links.emplace_back(a, b);
      links.emplace_back(b, a);
    }
    std::sort(links.begin(), links.end());
    elements.assign(static_cast<std::size_t>(*std::max_element(cluster.begin(), cluster.end())) + 1,
                    0);
    for (const Index c : cluster) ++elements[c];
    start.assign(elements.size() + 1, 0);
    for (std::size_t i = 0; i < links.size(); ++i) {
      if (i > 0 && links[i] == links[i - 1]) {
        ++faces.back();
        continue;
      }
      next.push_back(links[i].second);
      faces.push_back(1);
      ++start[links[i].first + 1];
    }
    for (std::size_t c = 1; c < start.size(); ++c) start[c] += start[c - 1];
  }
};

template <int D>
std::vector<Index> cut(const Topology<D>& topology, const std::vector<Index>& cluster, int parts) {
  Graph graph(topology, cluster);
  auto clusters = static_cast<idx_t>(graph.elements.size());
  idx_t constraints = 1, number = parts, objective = 0;
  idx_t options[METIS_NOPTIONS];
  METIS_SetDefaultOptions(options);
  options[METIS_OPTION_SEED] = 1;
  std::vector<idx_t> part(graph.elements.size(), 0);
  const int status = METIS_PartGraphKway(
      &clusters, &constraints, graph.start.data(), graph.next.data(), graph.elements.data(),
      nullptr, graph.faces.data(), &number, nullptr, nullptr, options, &objective, part.data());
  if (status != METIS_OK) throw Error("", "METIS could not cut the mesh", "use fewer parts");
  std::vector<Index> of_element;
  for (const Index c : cluster) of_element.push_back(static_cast<Index>(part[c]));
  return of_element;
}
#endif

void refuse_empty(const Partition& p) {
  std::vector<std::uint8_t> seen(static_cast<std::size_t>(p.parts), 0);
  for (const Index owner : p.part) seen[static_cast<std::size_t>(owner)] = 1;
  const auto empty = std::count(seen.begin(), seen.end(), std::uint8_t{0});
  if (empty == 0) return;
  throw Error("", std::to_string(empty) + " of " + std::to_string(p.parts) + " parts are empty",
              "use fewer parts: composites and rigid bodies stay in one piece");
}

template <int D>
void assess(const Mesh<D>& mesh, const Topology<D>& topology, Partition& p) {
  std::vector<Index> size(static_cast<std::size_t>(p.parts), 0);
  for (const Index owner : p.part) ++size[owner];
  p.imbalance = static_cast<double>(*std::max_element(size.begin(), size.end())) * p.parts /
                static_cast<double>(mesh.elements());
  for (const SharedFace& face : topology.shared)
    p.cut_faces += p.part[face.left] != p.part[face.right];
  // An element is a ghost of every foreign part that owns an element around one of its points.
  std::size_t ghosts = 0;
  std::vector<Index> seen;
  for (Index e = 0; e < mesh.elements(); ++e) {
    seen.assign(1, p.part[e]);
    for (const Index n : mesh.element[e])
      for (Index k = topology.family_start[n]; k < topology.family_start[n + 1]; ++k) {
        const Index owner = p.part[topology.family_corner[k] / (D + 1)];
        if (std::find(seen.begin(), seen.end(), owner) == seen.end()) seen.push_back(owner);
      }
    ghosts += seen.size() - 1;
  }
  p.ghost_share = static_cast<double>(ghosts) / static_cast<double>(mesh.elements());
}

}  // namespace

bool can_partition() {
  return BRECCIA_WITH_METIS != 0;
}

template <int D>
Partition partition(const Mesh<D>& mesh, const Topology<D>& topology, int parts,
                    const std::vector<Index>& cluster) {
  if (parts > mesh.elements())
    throw Error("",
                std::to_string(parts) + " parts are more than the mesh has elements (" +
                    std::to_string(mesh.elements()) + ")",
                "use fewer parts");
  Partition p;
  p.parts = parts;
  p.part.assign(mesh.element.size(), 0);
  if (parts > 1) {
#if BRECCIA_WITH_METIS
    std::vector<Index> single(cluster.empty() ? mesh.element.size() : 0);
    std::iota(single.begin(), single.end(), 0);
    p.part = cut(topology, cluster.empty() ? single : cluster, parts);
#else
    throw Error("", "this build has no METIS and cannot partition a mesh",
                "install METIS (Debian: libmetis-dev) and configure again");
#endif
  }
  refuse_empty(p);
  assess(mesh, topology, p);
  return p;
}

template Partition partition(const Mesh<2>&, const Topology<2>&, int, const std::vector<Index>&);
template Partition partition(const Mesh<3>&, const Topology<3>&, int, const std::vector<Index>&);

}  // namespace breccia
