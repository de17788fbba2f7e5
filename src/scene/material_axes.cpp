#include "scene/material_axes.hpp"

#include "mesh/geometry.hpp"
#include "step/selection.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

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

/// A field of the mesh files as directions: in the plane an angle in degrees (1 component) or the
/// first axis (3), in space the third axis (3) or all three one after the other (9).
template <int D>
class Seeds {
 public:
  Seeds(const Settings& section, const Mesh<D>& mesh) : section_(&section), mesh_(&mesh) {
    const std::string& name = section.text("field");
    const auto found = mesh.fields.find(name);
    if (found == mesh.fields.end()) {
      std::string known;
      for (const auto& [other, field] : mesh.fields) known += (known.empty() ? "" : ", ") + other;
      throw section.error(
          "field", "no mesh file has a field \"" + name + "\" of elements",
          known.empty() ? "ASCII .msh files carry them as $ElementData" : "there are: " + known);
    }
    field_ = &found->second;
    const int n = field_->components;
    if (n == 3 || n == (D == 2 ? 1 : 9)) return;
    throw section.error(
        "field", fmt::format("\"{}\" has {} components", name, n),
        D == 2 ? "1 is an angle in degrees from x towards y, 3 are the direction of the first axis"
               : "3 are the direction of the third axis, 9 those of all three");
  }

  Mat<D> at(Index element, const Vec<3>& first) const {
    const double* v = &field_->values[static_cast<std::size_t>(element) * field_->components];
    if (std::isnan(v[0])) fail(element, "has no value", "give one to every element there");
    if constexpr (D == 2) {
      const double angle =
          field_->components == 1 ? v[0] * std::numbers::pi / 180 : std::atan2(v[1], v[0]);
      if (field_->components == 3 && !(std::hypot(v[0], v[1]) > 0))
        fail(element, "has no direction in the plane: its x and y are zero", kTurnSomewhere);
      return {{{std::cos(angle), -std::sin(angle)}, {std::sin(angle), std::cos(angle)}}};
    } else {
      if (field_->components == 3) {
        const Vec<3> normal{{v[0], v[1], v[2]}};
        if (!(norm(normal) > 0)) fail(element, "has a direction of length zero", kTurnSomewhere);
        return axes_across(normal, first);
      }
      return three_axes(element, v);
    }
  }

 private:
  static constexpr const char* kTurnSomewhere = "give a direction, of any length";

  Mat<3> three_axes(Index element, const double* v) const {
    const Vec<3> a{{v[0], v[1], v[2]}}, b{{v[3], v[4], v[5]}}, c{{v[6], v[7], v[8]}};
    const double size = norm(a) * norm(b) * norm(c);
    // Of right-handed axes at right angles the volume is the product of the lengths; a thousandth
    // less is two and a half degrees.
    if (!(dot(cross(a, b), c) > 0.999 * size) || !(size > 0))
      fail(element, "has three directions that are no right-handed axes at right angles",
           "give the first, the second and the third axis one after the other");
    return axes_across(c, a);
  }

  [[noreturn]] void fail(Index element, const std::string& cause, const char* remedy) const {
    const auto x = centroid(*mesh_, element, 1);
    throw section_->error(
        "field",
        fmt::format("in \"{}\" the element at ({:g}, {:g}{}) {}", section_->text("field"), x[0],
                    x[1], D == 3 ? fmt::format(", {:g}", x[D - 1]) : "", cause),
        remedy);
  }

  const Settings* section_;
  const Mesh<D>* mesh_;
  const ElementField* field_ = nullptr;
};

/// How one section turns the axes at a place.
template <int D>
class Turn {
 public:
  Turn(const Settings& section, const Mesh<D>& mesh) : section_(&section) {
    if constexpr (D == 3)
      if (section.has("surface")) surface_ = surface_of(section, mesh);
    if (section.has("along") && section.points("along").size() < 2)
      throw section.error("along", "a line has two points or more");
    if (section.has("field")) seeds_.emplace(section, mesh);
  }

  /// Axes of an element whose centroid, or that of its composite, is at x.
  Mat<D> at(Index element, const Vec<D>& x) const {
    const Settings& s = *section_;
    if constexpr (D == 2) {
      if (seeds_) return seeds_->at(element, Vec<3>::zero());
      if (s.has("along")) return axes_along(s.points("along"), x);
      const double a = s.number("angle");
      return {{{std::cos(a), -std::sin(a)}, {std::sin(a), std::cos(a)}}};
    } else {
      const Vec<3> first = s.has("first") ? direction(s, "first") : Vec<3>{{1, 0, 0}};
      if (seeds_) return seeds_->at(element, first);
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
  std::optional<Seeds<D>> seeds_;
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
  s.text("field")
      .doc(
          "A field of the elements in the bodies' .msh files ($ElementData). In 2D 1 component is "
          "the "
          "angle of the first axis in degrees, 3 are its direction; in 3D 3 components are the "
          "direction of the third axis, 9 those of all three.")
      .example("bedding");
  s.exactly_one_of({"angle", "along", "normal", "surface", "field"});
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
        const Mat<D> turned = turn.at(first, centroid(model.mesh, first, block.group));
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
