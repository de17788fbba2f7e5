#include "io/mesh_file.hpp"

#include "io/hdf5_file.hpp"

#include <cmath>
#include <fstream>

namespace breccia {
namespace {

/// Version 2 has curved edges; a file without them stays readable for older builds.
constexpr std::int64_t kVersion = 2;
constexpr const char* kFormat = "breccia mesh";
constexpr const char* kRemedy =
    "write it again with `breccia mesh SCENE -o FILE`, or give another mesh file";

[[noreturn]] void refuse_file(const std::string& path, const std::string& cause) {
  throw Error(path, cause, kRemedy);
}

/// Names one per line: HDF5 text of varying length is not what VTK and h5py agree on.
std::string joined(const std::vector<std::string>& names) {
  std::string text;
  for (const auto& name : names) {
    if (name.find('\n') != std::string::npos) {
      throw Error("name \"" + name + "\"", "it has a line break", "give bodies plain names");
    }
    text += name + "\n";
  }
  return text;
}

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::size_t begin = 0;
  for (std::size_t end; (end = text.find('\n', begin)) != std::string::npos; begin = end + 1) {
    lines.push_back(text.substr(begin, end - begin));
  }
  return lines;
}

/// Lists of varying length as one array with the start of each.
template <class T>
struct Lists {
  std::vector<std::int64_t> start = {0};
  std::vector<T> item;

  void add(std::span<const T> list) {
    item.insert(item.end(), list.begin(), list.end());
    start.push_back(static_cast<std::int64_t>(item.size()));
  }
  std::span<const T> list(std::size_t n) const {
    return std::span(item).subspan(start[n], start[n + 1] - start[n]);
  }
};

template <class T>
void write_lists(H5Writer& file, const std::string& name, const Lists<T>& lists) {
  file.write(name + "_start", view_of(lists.start));
  file.write(name, view_of(lists.item));
}

template <class T>
Lists<T> read_lists(const H5Reader& file, const std::string& name, std::size_t count) {
  Lists<T> lists;
  lists.start = file.read<std::int64_t>(name + "_start");
  lists.item = file.read<T>(name);
  bool good = lists.start.size() == count + 1 && lists.start.front() == 0 &&
              lists.start.back() == static_cast<std::int64_t>(lists.item.size());
  for (std::size_t n = 1; good && n < lists.start.size(); ++n) {
    good = lists.start[n - 1] <= lists.start[n];
  }
  if (!good) refuse_file(file.path(), "\"" + name + "\" and \"" + name + "_start\" do not fit");
  return lists;
}

template <int D>
void write_regions(H5Writer& file, const Mesh<D>& mesh) {
  std::vector<std::string> names;
  Lists<Index> elements, face_elements, points;
  Lists<std::int32_t> face_numbers;
  for (const Region& region : mesh.regions) {
    names.push_back(region.name);
    elements.add(region.elements);
    points.add(region.points);
    std::vector<Index> element;
    std::vector<std::int32_t> number;
    for (const ElementFace& side : region.faces) {
      element.push_back(side.element);
      number.push_back(side.face);
    }
    face_elements.add(element);
    face_numbers.add(number);
  }
  file.write_text("region_names", joined(names));
  write_lists(file, "region_elements", elements);
  write_lists(file, "region_points", points);
  write_lists(file, "region_face_elements", face_elements);
  write_lists(file, "region_face_numbers", face_numbers);
}

template <int D>
void read_regions(const H5Reader& file, Mesh<D>& mesh) {
  const auto names = lines_of(file.read_text("region_names"));
  const auto elements = read_lists<Index>(file, "region_elements", names.size());
  const auto points = read_lists<Index>(file, "region_points", names.size());
  const auto face_elements = read_lists<Index>(file, "region_face_elements", names.size());
  const auto face_numbers = read_lists<std::int32_t>(file, "region_face_numbers", names.size());
  if (face_elements.start != face_numbers.start) {
    refuse_file(file.path(), "faces of regions lack elements or numbers");
  }
  for (std::size_t r = 0; r < names.size(); ++r) {
    Region region{names[r], {}, {}, {}};
    const auto e = elements.list(r);
    const auto p = points.list(r);
    region.elements.assign(e.begin(), e.end());
    region.points.assign(p.begin(), p.end());
    const auto of = face_elements.list(r);
    const auto number = face_numbers.list(r);
    for (std::size_t f = 0; f < of.size(); ++f) region.faces.push_back({of[f], number[f]});
    mesh.regions.push_back(std::move(region));
  }
}

template <int D>
void check_heading(const H5Reader& file) {
  if (!file.has_attribute("", "format") || file.text_attribute("", "format") != kFormat) {
    refuse_file(file.path(), "it is an HDF5 file, but no Breccia mesh");
  }
  const auto version = file.integer_attribute("", "version");
  if (version.size() != 1 || version[0] < 1 || version[0] > kVersion) {
    refuse_file(file.path(), "it is a mesh of format version " +
                                 (version.empty() ? "none" : std::to_string(version[0])) +
                                 "; this build reads versions 1 to " + std::to_string(kVersion));
  }
  const auto dimension = file.integer_attribute("", "dimension");
  if (dimension.size() != 1 || dimension[0] != D) {
    refuse_file(file.path(), "it is a mesh of dimension " +
                                 (dimension.empty() ? "none" : std::to_string(dimension[0])) +
                                 ", the scene has dimension " + std::to_string(D));
  }
}

/// A table with `width` columns as a vector of rows.
template <class T, std::size_t Width>
std::vector<std::array<T, Width>> read_rows(const H5Reader& file, const std::string& name) {
  const ArrayInfo info = file.info(name);
  if (info.shape.size() != 2 || info.shape[1] != Width) {
    refuse_file(file.path(), "\"" + name + "\" has not " + std::to_string(Width) + " columns");
  }
  std::vector<std::array<T, Width>> rows(info.shape[0]);
  file.read(name, data_type_of<T>(), rows.data());
  return rows;
}

template <class T, std::size_t Width>
ArrayView view_of_rows(const std::vector<std::array<T, Width>>& rows) {
  return {{data_type_of<T>(), {rows.size(), Width}}, rows.data()};
}

template <int D>
void write_curved(H5Writer& file, const Mesh<D>& mesh) {
  std::vector<Edge> edges;
  std::vector<Point<D>> middles;
  for (const auto& [edge, middle] : mesh.curved) {
    edges.push_back(edge);
    middles.push_back(middle);
  }
  file.write("curved_edges", view_of_rows(edges));
  file.write("curved_points", view_of_rows(middles));
}

template <int D>
void read_curved(const H5Reader& file, Mesh<D>& mesh) {
  const auto edges = read_rows<Index, 2>(file, "curved_edges");
  const auto middles = read_rows<double, D>(file, "curved_points");
  bool good = edges.size() == middles.size();
  for (std::size_t n = 0; good && n < edges.size(); ++n) {
    const auto [a, b] = edges[n];
    good = a >= 0 && a < b && b < mesh.points();
    for (double c : middles[n]) good = good && std::isfinite(c);
    mesh.curved[edges[n]] = middles[n];
  }
  if (!good) refuse_file(file.path(), "\"curved_edges\" and \"curved_points\" do not fit");
}

/// A number outside its range would lead a later reader of the mesh out of bounds.
template <int D>
void check_numbers(const H5Reader& file, const Mesh<D>& mesh) {
  const auto inside = [](Index n, std::size_t end) {
    return n >= 0 && static_cast<std::size_t>(n) < end;
  };
  bool good = mesh.body.size() == mesh.element.size();
  for (Index b : mesh.body) good = good && inside(b, mesh.body_names.size());
  for (const auto& nodes : mesh.element) {
    for (Index p : nodes) good = good && inside(p, mesh.point.size());
  }
  for (const Region& region : mesh.regions) {
    for (Index e : region.elements) good = good && inside(e, mesh.element.size());
    for (Index p : region.points) good = good && inside(p, mesh.point.size());
    for (const ElementFace& side : region.faces) {
      good = good && inside(side.element, mesh.element.size()) && inside(side.face, D + 1);
    }
  }
  if (!good) refuse_file(file.path(), "it has numbers of points, elements or bodies out of range");
}

}  // namespace

template <int D>
void write_mesh(const Mesh<D>& mesh, const std::string& path) {
  H5Writer file(path);
  file.attribute("", "format", kFormat);
  const std::int64_t version = mesh.curved.empty() ? 1 : kVersion;
  file.attribute("", "version", std::array<std::int64_t, 1>{version});
  file.attribute("", "dimension", std::array<std::int64_t, 1>{D});
  file.write("points", view_of_rows(mesh.point));
  file.write("elements", view_of_rows(mesh.element));
  file.write("bodies", view_of(mesh.body));
  file.write_text("body_names", joined(mesh.body_names));
  write_regions(file, mesh);
  if (!mesh.curved.empty()) write_curved(file, mesh);
  file.commit();
}

template <int D>
Mesh<D> read_mesh(const std::string& path) {
  const H5Reader file(path);
  check_heading<D>(file);
  Mesh<D> mesh;
  mesh.point = read_rows<double, D>(file, "points");
  mesh.element = read_rows<Index, D + 1>(file, "elements");
  mesh.body = file.read<Index>("bodies");
  mesh.body_names = lines_of(file.read_text("body_names"));
  read_regions(file, mesh);
  if (file.has("curved_edges")) read_curved(file, mesh);
  check_numbers(file, mesh);
  return mesh;
}

bool looks_like_hdf5(const std::string& path) {
  constexpr std::string_view signature("\x89HDF\r\n\x1a\n", 8);
  std::string start(signature.size(), '\0');
  std::ifstream file(path, std::ios::binary);
  file.read(start.data(), static_cast<std::streamsize>(start.size()));
  return file && start == signature;
}

template void write_mesh<2>(const Mesh<2>&, const std::string&);
template void write_mesh<3>(const Mesh<3>&, const std::string&);
template Mesh<2> read_mesh<2>(const std::string&);
template Mesh<3> read_mesh<3>(const std::string&);

}  // namespace breccia
