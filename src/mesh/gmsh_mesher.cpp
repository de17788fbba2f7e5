#include "mesh/gmsh_mesher.hpp"

#include "mesh/refusal.hpp"

#if BRECCIA_WITH_GMSH

#include "core/error.hpp"
#include "mesh/gmsh_geometry.hpp"
#include "mesh/size_field.hpp"

#include <gmsh.h>

#include <algorithm>
#include <clocale>
#include <cmath>
#include <fstream>
#include <future>
#include <map>

namespace breccia {
namespace {

using Tag = GmshTag;
using Tags = std::vector<Tag>;

/// Gmsh from start to end of one mesh. It sets the locale of the process to its own, which is put
/// back.
class Session {
 public:
  Session() {
    gmsh::initialize(0, nullptr, false);
    gmsh::option::setNumber("General.Terminal", 0);
    gmsh::option::setNumber("General.NumThreads", 1);
    gmsh::option::setNumber("General.AbortOnError", 2);
    gmsh::option::setNumber("Mesh.RandomSeed", 1);
    gmsh::model::add("breccia");
  }
  ~Session() {
    gmsh::finalize();
    std::setlocale(LC_ALL, locale_.c_str());
  }
  Session(const Session&) = delete;
  Session& operator=(const Session&) = delete;

 private:
  std::string locale_ = std::setlocale(LC_ALL, nullptr);
};

/// Runs `work` with Gmsh and turns whatever it throws (std::string) into an Error. Gmsh sets the
/// number of OpenMP threads of the thread that starts it, so it gets one of its own.
template <class Work>
auto with_gmsh(const std::string& place, Work&& work) {
  std::string message;
  try {
    return std::async(std::launch::async,
                      [&] {
                        const Session session;
                        return work();
                      })
        .get();
  } catch (const Error&) {
    throw;
  } catch (const std::string& text) {
    message = text;
  } catch (const std::exception& error) {
    message = error.what();
  } catch (int code) {
    message = "error " + std::to_string(code);
  }
  refuse(place, "Gmsh could not mesh it: " + message,
         "check the sizes (a smaller size may do), crossing outlines and touching bodies");
}

/// Gmsh's number of the method: MeshAdapt, Delaunay, frontal Delaunay (docs/method/mesh.md).
int algorithm(Arrangement arrangement) {
  switch (arrangement) {
    case Arrangement::irregular:
      return 1;
    case Arrangement::quick:
      return 5;
    case Arrangement::regular:
      return 6;
  }
  return 1;
}

void set_sizes(std::span<const BodyShape* const> bodies, const GmshAssembly& assembly,
               double scale) {
  double largest = 0;
  double smallest = bodies[0]->size;
  for (const BodyShape* body : bodies) {
    largest = std::max(largest, body->size);
    smallest = std::min(smallest, body->size);
  }
  gmsh::option::setNumber("Mesh.MeshSizeFromPoints", 0);
  gmsh::option::setNumber("Mesh.MeshSizeFromCurvature", 0);
  // Where a coarse body meets a fine one, sizes grow inwards from their common face.
  gmsh::option::setNumber("Mesh.MeshSizeExtendFromBoundary", smallest < largest ? 1 : 0);
  gmsh::model::mesh::setSizeCallback([bodies, &owners = assembly.owners, scale, largest](
                                         int dim, int tag, double x, double y, double z) {
    double size = largest;
    const auto found = owners.find({dim, tag});
    if (found == owners.end()) return scale * size;
    for (std::size_t b : found->second) {
      size = std::min(size, element_size(*bodies[b], {x / scale, y / scale, z / scale}));
    }
    return scale * size;
  });
}

/// Points of the current Gmsh model, and their numbers by Gmsh's tag.
std::vector<Index> take_points(double scale, RawMesh& raw) {
  std::vector<std::size_t> tags;
  std::vector<double> xyz, unused;
  gmsh::model::mesh::getNodes(tags, xyz, unused);
  std::size_t last = 0;
  for (std::size_t tag : tags) last = std::max(last, tag);
  std::vector<Index> number(last + 1, kNone);
  for (std::size_t i = 0; i < tags.size(); ++i) {
    number[tags[i]] = static_cast<Index>(raw.point.size());
    raw.point.push_back({xyz[3 * i] / scale, xyz[3 * i + 1] / scale, xyz[3 * i + 2] / scale});
  }
  return number;
}

/// Appends the elements of an entity and returns their numbers.
std::vector<Index> take_elements(const Tag& entity, const std::vector<Index>& number,
                                 const std::string& place, RawMesh& raw) {
  std::vector<int> types;
  std::vector<std::vector<std::size_t>> tags, nodes;
  gmsh::model::mesh::getElements(types, tags, nodes, entity.first, entity.second);
  std::vector<Index> taken;
  for (std::size_t t = 0; t < types.size(); ++t) {
    const GmshType type = gmsh_type(types[t]);
    if (type.dimension < 0) {
      refuse(place, "it has elements of Gmsh type " + std::to_string(types[t]), kTypesTaken);
    }
    const int count = type.dimension + 1 + type.middles;
    for (std::size_t e = 0; e < tags[t].size(); ++e) {
      const auto node = [&](int a) { return number[nodes[t][count * e + a]]; };
      RawElement element{type.dimension, {}};
      for (int a = 0; a <= type.dimension; ++a) element.point[a] = node(a);
      for (int m = 0; m < type.middles; ++m) {
        const auto [a, b] = type.edge[m];
        add_middle(raw, node(a), node(b), node(type.dimension + 1 + m), place);
      }
      taken.push_back(static_cast<Index>(raw.element.size()));
      raw.element.push_back(element);
    }
  }
  return taken;
}

void take_groups(const std::map<Tag, std::vector<Index>>& elements, RawMesh& raw) {
  Tags groups;
  gmsh::model::getPhysicalGroups(groups);
  for (const Tag& group : groups) {
    RawGroup taken{group.first, "", {}};
    gmsh::model::getPhysicalName(group.first, group.second, taken.name);
    if (taken.name.empty()) taken.name = std::to_string(group.second);
    std::vector<int> entities;
    gmsh::model::getEntitiesForPhysicalGroup(group.first, group.second, entities);
    for (int entity : entities) {
      const auto found = elements.find({group.first, entity});
      if (found == elements.end()) continue;
      taken.elements.insert(taken.elements.end(), found->second.begin(), found->second.end());
    }
    raw.groups.push_back(std::move(taken));
  }
}

/// Points that no element uses (the far ends of lines that leave their body).
void drop_unused_points(RawMesh& raw) {
  std::vector<Index> number(raw.point.size(), kNone);
  for (const RawElement& element : raw.element) {
    for (int a = 0; a <= element.dimension; ++a) number[element.point[a]] = 0;
  }
  for (const auto& [edge, middle] : raw.middle) number[middle] = 0;
  std::vector<Point<3>> kept;
  for (std::size_t p = 0; p < number.size(); ++p) {
    if (number[p] == kNone) continue;
    number[p] = static_cast<Index>(kept.size());
    kept.push_back(raw.point[p]);
  }
  for (RawElement& element : raw.element) {
    for (int a = 0; a <= element.dimension; ++a) element.point[a] = number[element.point[a]];
  }
  std::map<Edge, Index> middles;  // points keep their order, so edges keep theirs
  for (const auto& [edge, middle] : raw.middle) {
    middles.emplace_hint(middles.end(), Edge{number[edge[0]], number[edge[1]]}, number[middle]);
  }
  raw.middle = std::move(middles);
  raw.point = std::move(kept);
}

}  // namespace

RawMesh gmsh_mesh(int dimension, std::span<const BodyShape* const> bodies) {
  const std::string place = "body \"" + bodies[0]->name + "\"";
  return with_gmsh(place, [&] {
    const double scale = gmsh_scale(bodies);
    const GmshAssembly assembly = gmsh_assemble(dimension, bodies, scale);
    set_sizes(bodies, assembly, scale);
    gmsh::option::setNumber("Mesh.Algorithm", algorithm(bodies[0]->arrangement));
    gmsh::option::setNumber("Mesh.Algorithm3D", 1);
    gmsh::option::setNumber("Mesh.OptimizeThreshold", 0.7);  // docs/method/mesh.md
    gmsh::option::setNumber("Mesh.RandomSeed", bodies[0]->seed);
    gmsh::model::mesh::generate(dimension);
    gmsh::model::mesh::removeSizeCallback();
    if (bodies[0]->curved) gmsh::model::mesh::setOrder(2);
    RawMesh raw;
    const auto number = take_points(scale, raw);
    for (std::size_t b = 0; b < bodies.size(); ++b) {
      RawGroup group{dimension, bodies[b]->name, {}};
      for (const Tag& piece : assembly.pieces[b]) {
        for (Index e : take_elements(piece, number, place, raw)) group.elements.push_back(e);
      }
      raw.groups.push_back(std::move(group));
    }
    drop_unused_points(raw);
    return raw;
  });
}

RawMesh gmsh_open(const std::string& path, int dimension, double size, bool curved) {
  if (!std::ifstream(path)) {  // Gmsh would make an empty model of it
    refuse(path, "the file cannot be read", "check its name and that you may read it");
  }
  return with_gmsh(path, [&] {
    gmsh::open(path);
    if (size > 0) gmsh::option::setNumber("Mesh.MeshSizeMax", size);
    std::vector<int> types;
    gmsh::model::mesh::getElementTypes(types, dimension);
    if (types.empty()) {
      gmsh::model::mesh::generate(dimension);
      if (curved) gmsh::model::mesh::setOrder(2);
    }
    RawMesh raw;
    const auto number = take_points(1, raw);
    Tags entities, groups;
    gmsh::model::getEntities(entities);
    gmsh::model::getPhysicalGroups(groups, dimension);
    std::map<Tag, std::vector<Index>> elements;
    for (const Tag& entity : entities) {
      // As Gmsh saves meshes: where there are physical groups, what is in none is not wanted.
      std::vector<int> physical;
      gmsh::model::getPhysicalGroupsForEntity(entity.first, entity.second, physical);
      if (entity.first == dimension && !groups.empty() && physical.empty()) continue;
      elements[entity] = take_elements(entity, number, path, raw);
    }
    take_groups(elements, raw);
    drop_unused_points(raw);
    return raw;
  });
}

bool gmsh_available() {
  return true;
}

std::string gmsh_version() {
  return GMSH_API_VERSION;
}

}  // namespace breccia

#else

namespace breccia {

RawMesh gmsh_mesh(int, std::span<const BodyShape* const> bodies) {
  refuse(
      "body \"" + bodies[0]->name + "\"", "this build has no Gmsh to mesh it",
      "install Gmsh with its headers (Debian: libgmsh-dev) and configure again, give a mesh file, "
      "or use a rectangle or box with a structured pattern");
}

RawMesh gmsh_open(const std::string& path, int, double, bool) {
  refuse(
      path, "this build has no Gmsh to read it",
      "install Gmsh with its headers (Debian: libgmsh-dev) and configure again, or save the mesh "
      "as MSH 2.2 or 4.1 in ASCII");
}

bool gmsh_available() {
  return false;
}

std::string gmsh_version() {
  return "";
}

}  // namespace breccia

#endif
