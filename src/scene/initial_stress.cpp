#include "scene/initial_stress.hpp"

#include "step/selection.hpp"
#include "step/stress_view.hpp"

#include <fmt/format.h>

namespace breccia {

namespace {

template <int D>
std::vector<Index> elements_of(const Settings& section, const Model<D>& model) {
  if (section.has("where") || section.has("box")) {
    const Region region = select_region(section, model.mesh, model.topology);
    if (region.elements.empty())
      throw section.error(section.has("where") ? "where" : "box", "no element lies there",
                          "name a body or a region with elements");
    return region.elements;
  }
  std::vector<Index> all(model.mesh.element.size());
  for (std::size_t e = 0; e < all.size(); ++e) all[e] = static_cast<Index>(e);
  return all;
}

template <int D>
double middle(const Mesh<D>& mesh, Index element, int axis) {
  double x = 0;
  for (const Index n : mesh.element[static_cast<std::size_t>(element)])
    x += mesh.point[static_cast<std::size_t>(n)][static_cast<std::size_t>(axis)] / (D + 1);
  return x;
}

}  // namespace

template <int D>
std::vector<Sym<3>> initial_stress(const Settings& scene, const Model<D>& model) {
  const std::vector<Settings>& sections = scene.list("initial_stress");
  if (sections.empty()) return {};
  std::vector<Sym<3>> stress(model.mesh.element.size(), Sym<3>::zero());
  std::vector<const Settings*> by(model.mesh.element.size(), nullptr);
  for (const Settings& section : sections) {
    const Sym<3> level = stress_of(section.vector("stress"));
    const bool grows = section.has("gradient");
    const Sym<3> gradient = grows ? stress_of(section.vector("gradient")) : Sym<3>::zero();
    const int axis = grows ? section.text("axis")[0] - 'x' : 0;
    for (const Index element : elements_of(section, model)) {
      const auto e = static_cast<std::size_t>(element);
      if (by[e])
        throw section.error(
            "", fmt::format("element {} is given a stress twice", element),
            fmt::format("make its place and that of the one at {} apart", by[e]->place()));
      by[e] = &section;
      const double depth = middle(model.mesh, element, axis) - section.number("datum");
      stress[e] = level + gradient * depth;
    }
  }
  return stress;
}

template std::vector<Sym<3>> initial_stress(const Settings&, const Model<2>&);
template std::vector<Sym<3>> initial_stress(const Settings&, const Model<3>&);

}  // namespace breccia
