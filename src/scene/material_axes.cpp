#include "scene/material_axes.hpp"

#include "mesh/geometry.hpp"
#include "step/selection.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>

namespace breccia {

namespace {

/// Distance from a point to a segment, squared.
double distance2(const Vec<2>& x, const Vec<2>& a, const Vec<2>& b) {
  const Vec<2> along = b - a;
  const double t = std::clamp(dot(x - a, along) / norm2(along), 0.0, 1.0);
  return norm2(x - a - along * t);
}

/// The first axis runs along the nearest piece of a line.
Mat<2> axes_along(const Points& line, const Vec<2>& x) {
  double nearest = std::numeric_limits<double>::infinity();
  Vec<2> direction = Vec<2>::zero();
  for (std::size_t i = 0; i + 1 < line.size(); ++i) {
    const Vec<2> a{{line[i][0], line[i][1]}}, b{{line[i + 1][0], line[i + 1][1]}};
    const double d = distance2(x, a, b);
    if (d < nearest) {
      nearest = d;
      direction = (b - a) * (1 / norm(b - a));
    }
  }
  return {{{direction[0], -direction[1]}, {direction[1], direction[0]}}};
}

/// Right-handed axes: the third along `normal`, the first as near to `first` as that allows.
Mat<3> axes_across(Vec<3> normal, const Vec<3>& first) {
  normal = normal * (1 / norm(normal));
  Vec<3> a = first - normal * dot(first, normal);
  if (norm(a) < 1e-6 * norm(first)) a = Vec<3>{{normal[1], normal[2], normal[0]}};
  a = a - normal * dot(a, normal);
  a = a * (1 / norm(a));
  const Vec<3> b = cross(normal, a);
  Mat<3> axes;
  for (int i = 0; i < 3; ++i) {
    axes(i, 0) = a[i];
    axes(i, 1) = b[i];
    axes(i, 2) = normal[i];
  }
  return axes;
}

Vec<3> direction(const Settings& section, const char* key) {
  const auto& v = section.vector(key);
  return {{v[0], v[1], v[2]}};
}

template <int D>
Vec<D> centroid(const Mesh<D>& mesh, Index first, int group) {
  Vec<D> sum = Vec<D>::zero();
  double volume = 0;
  for (Index e = first; e < first + group; ++e) {
    const double v = signed_volume<D>(corners(mesh, e));
    for (const Index n : mesh.element[e])
      for (int d = 0; d < D; ++d) sum[d] += v * mesh.point[n][d] / (D + 1);
    volume += v;
  }
  return sum * (1 / volume);
}

/// Middles and normals of the faces of a side.
struct Surface {
  std::vector<Vec<3>> middle, normal;
};

Surface surface_of(const Settings& section, const Mesh<3>& mesh) {
  const Region& region = named_region(section, "surface", section.text("surface"), mesh);
  if (region.faces.empty())
    throw section.error("surface", "that region has no faces", "name a side of a body");
  Surface s;
  for (const ElementFace& face : region.faces) {
    Vec<3> middle = Vec<3>::zero();
    for (int j = 0; j < 3; ++j)
      for (int d = 0; d < 3; ++d)
        middle[d] += mesh.point[mesh.element[face.element][face_node<3>(face.face, j)]][d] / 3;
    s.middle.push_back(middle);
    const Point<3> n = face_normal_area<3>(corners(mesh, face.element), face.face);
    s.normal.push_back({{n[0], n[1], n[2]}});
  }
  return s;
}

/// How one section turns the axes at a place.
template <int D>
class Turn {
 public:
  Turn(const Settings& section, const Mesh<D>& mesh) : section_(&section) {
    if constexpr (D == 3)
      if (section.has("surface")) surface_ = surface_of(section, mesh);
    if (section.has("along") && section.points("along").size() < 2)
      throw section.error("along", "a line has two points or more");
  }

  Mat<D> at(const Vec<D>& x) const {
    const Settings& s = *section_;
    if constexpr (D == 2) {
      if (s.has("along")) return axes_along(s.points("along"), x);
      const double a = s.number("angle");
      return {{{std::cos(a), -std::sin(a)}, {std::sin(a), std::cos(a)}}};
    } else {
      const Vec<3> first = s.has("first") ? direction(s, "first") : Vec<3>{{1, 0, 0}};
      if (s.has("normal")) return axes_across(direction(s, "normal"), first);
      std::size_t nearest = 0;
      for (std::size_t i = 1; i < surface_.middle.size(); ++i)
        if (norm2(surface_.middle[i] - x) < norm2(surface_.middle[nearest] - x)) nearest = i;
      return axes_across(surface_.normal[nearest], first);
    }
  }

 private:
  const Settings* section_;
  Surface surface_;
};

}  // namespace

void declare_axes(Schema& schema) {
  auto s = schema.section("axes[]").doc("Directions of anisotropic materials.");
  s.text("where").doc("A body or region; everything if absent.").example("layer 2");
  s.number("angle", unit::angle)
      .only_in(2)
      .doc("Of the first material axis, from x towards y.")
      .example("20 deg");
  s.points("along", unit::length)
      .only_in(2)
      .doc("A line: the first axis of each element runs along its nearest piece.")
      .example("[[0, 0], [\"50 m\", \"10 m\"], [\"100 m\", \"12 m\"]]");
  s.vector("normal", unit::none)
      .only_in(3)
      .doc("The third axis, normal of layers; of any length.")
      .example("[0, 0.2, 1]");
  s.text("surface")
      .only_in(3)
      .doc("A side: the third axis of each element is the normal of its nearest face.")
      .example("rock.top");
  s.vector("first", unit::none)
      .only_in(3)
      .doc("The first axis, as near to it as the third allows; x if absent.")
      .example("[1, 0, 0]");
  s.exactly_one_of({"angle", "along", "normal", "surface"});
}

template <int D>
std::vector<Mat<D>> material_axes(const Settings& scene, const Model<D>& model) {
  const std::vector<Settings>& sections = scene.list("axes");
  if (sections.empty()) return {};
  const auto elements = static_cast<std::size_t>(model.mesh.elements());
  std::vector<Mat<D>> axes(elements, Mat<D>::identity());
  std::vector<const Settings*> by(elements, nullptr);
  for (const Settings& section : sections) {
    std::vector<char> wanted(elements, section.has("where") ? 0 : 1);
    if (section.has("where")) {
      const Region& region = named_region(section, "where", section.text("where"), model.mesh);
      if (region.elements.empty())
        throw section.error("where", "no element lies there",
                            "name a body or a region of elements");
      for (const Index e : region.elements) wanted[static_cast<std::size_t>(e)] = 1;
    }
    const Turn<D> turn(section, model.mesh);
    for (const Block& block : model.blocks)
      for (Index first = block.begin; first < block.end; first += block.group) {
        const auto at = static_cast<std::size_t>(first);
        if (wanted[at] == 0) continue;
        if (by[at] != nullptr)
          throw section.error(section.has("where") ? "where" : "",
                              fmt::format("element {} has axes already", first),
                              "see the [[axes]] at " + by[at]->place());
        const Mat<D> turned = turn.at(centroid(model.mesh, first, block.group));
        for (std::size_t e = at; e < at + static_cast<std::size_t>(block.group); ++e) {
          axes[e] = turned;
          by[e] = &section;
        }
      }
  }
  return axes;
}

template std::vector<Mat<2>> material_axes(const Settings&, const Model<2>&);
template std::vector<Mat<3>> material_axes(const Settings&, const Model<3>&);

}  // namespace breccia
