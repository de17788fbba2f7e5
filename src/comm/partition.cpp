#include "comm/partition.hpp"

#include "core/error.hpp"

#include <algorithm>

#if BRECCIA_WITH_METIS
#include <metis.h>
#endif

namespace breccia {

namespace {

#if BRECCIA_WITH_METIS
/// Dual graph in METIS's form: neighbours of element e are next[start[e]] to
/// next[start[e + 1] - 1].
template <int D>
void dual_graph(const Mesh<D>& mesh, const Topology<D>& topology, std::vector<idx_t>& start,
                std::vector<idx_t>& next) {
  start.assign(mesh.element.size() + 1, 0);
  for (const SharedFace& face : topology.shared) {
    ++start[face.left + 1];
    ++start[face.right + 1];
  }
  for (std::size_t e = 1; e < start.size(); ++e) start[e] += start[e - 1];
  next.resize(static_cast<std::size_t>(start.back()));
  std::vector<idx_t> place(start.begin(), start.end() - 1);
  for (const SharedFace& face : topology.shared) {
    next[place[face.left]++] = face.right;
    next[place[face.right]++] = face.left;
  }
}

template <int D>
std::vector<Index> cut(const Mesh<D>& mesh, const Topology<D>& topology, int parts) {
  std::vector<idx_t> start, next;
  dual_graph(mesh, topology, start, next);
  auto elements = static_cast<idx_t>(mesh.elements());
  idx_t constraints = 1, number = parts, objective = 0;
  idx_t options[METIS_NOPTIONS];
  METIS_SetDefaultOptions(options);
  options[METIS_OPTION_SEED] = 1;
  std::vector<idx_t> part(mesh.element.size(), 0);
  const int status =
      METIS_PartGraphKway(&elements, &constraints, start.data(), next.data(), nullptr, nullptr,
                          nullptr, &number, nullptr, nullptr, options, &objective, part.data());
  if (status != METIS_OK) throw Error("", "METIS could not cut the mesh", "use fewer parts");
  return {part.begin(), part.end()};
}
#endif

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
Partition partition(const Mesh<D>& mesh, const Topology<D>& topology, int parts) {
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
    p.part = cut(mesh, topology, parts);
#else
    throw Error("", "this build has no METIS and cannot partition a mesh",
                "install METIS (Debian: libmetis-dev) and configure again");
#endif
  }
  assess(mesh, topology, p);
  return p;
}

template Partition partition(const Mesh<2>&, const Topology<2>&, int);
template Partition partition(const Mesh<3>&, const Topology<3>&, int);

}  // namespace breccia
