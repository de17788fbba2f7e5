#include "scene/field_norms.hpp"

#include "core/expression.hpp"
#include "core/text.hpp"
#include "fields/solid_fields.hpp"
#include "mesh/geometry.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

namespace breccia {

namespace {

/// One component of a field of a frame.
struct Component {
  const std::vector<double>* values = nullptr;
  std::size_t stride = 1, offset = 0;
  bool of_nodes = false;

  double at(Index i) const { return (*values)[static_cast<std::size_t>(i) * stride + offset]; }
};

using FieldParts = std::map<std::string, Component>;

const char* const kAxes[3] = {"x", "y", "z"};
const char* const kPairs[6] = {"xx", "yy", "zz", "xy", "yz", "xz"};

void add_parts(const PictureField& field, bool of_nodes, FieldParts& to) {
  const auto n = static_cast<std::size_t>(field.components);
  for (std::size_t k = 0; k < n; ++k) {
    const std::string part = n == 1 ? "" : std::string(".") + (n == 6 ? kPairs[k] : kAxes[k]);
    to[field.name + part] = {&field.values, n, k, of_nodes};
  }
}

template <int D>
PictureField node_field(const char* name, const char* unit, const Model<D>& model,
                        const ConstVectors<D>& field, const ConstVectors<D>* less = nullptr) {
  PictureField f{name, unit, D, {}};
  const auto host = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{}, field);
  for (Index n = 0; n < model.nodes(); ++n)
    for (int d = 0; d < D; ++d) f.values.push_back(host(n, d));
  if (less == nullptr) return f;
  const auto from = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{}, *less);
  for (Index n = 0; n < model.nodes(); ++n)
    for (int d = 0; d < D; ++d)
      f.values[static_cast<std::size_t>(n) * D + static_cast<std::size_t>(d)] -= from(n, d);
  return f;
}

/// All fields that a frame would have.
template <int D>
Picture draw_all(Simulation<D>& simulation) {
  Picture picture;
  const Model<D>& model = simulation.model();
  for (const auto& module : simulation.modules()) module->draw(simulation.model(), picture);
  const ConstVectors<D> x = model.store.template get<NodePosition<D>>();
  const ConstVectors<D> start = model.store.template get<NodeReference<D>>();
  const ConstVectors<D> v = model.store.template get<NodeVelocity<D>>();
  picture.node_fields.push_back(node_field<D>("displacement", "m", model, x, &start));
  picture.node_fields.push_back(node_field<D>("velocity", "m/s", model, v));
  return picture;
}

/// Points of an element that integrate degree 2, all of the same weight, by their barycentric
/// coordinates: `own` for one corner, `other` for the rest.
template <int D>
struct Quadrature {
  static constexpr double other = D == 2 ? 1.0 / 6 : 0.13819660112501051518;  // (5 - sqrt 5) / 20
  static constexpr double own = 1 - D * other;
};

template <int D>
std::vector<Index> elements_of(const Settings& norm, const Model<D>& model) {
  if (!norm.has("body")) {
    std::vector<Index> all(static_cast<std::size_t>(model.elements()));
    std::iota(all.begin(), all.end(), 0);
    return all;
  }
  const std::string& name = norm.text("body");
  const auto& names = model.mesh.body_names;
  if (std::find(names.begin(), names.end(), name) == names.end())
    throw norm.error("body", "there is no body '" + name + "'." + did_you_mean(name, names));
  return find_region(model.mesh, name)->elements;
}

/// Values of a formula of x, y, z (m, before anything moved) and time (s) at the points.
template <int D>
std::vector<double> values_of(const std::string& text, const std::vector<double> (&place)[D],
                              double time) {
  Quantities q;
  q.time.assign(place[0].size(), time);
  for (int d = 0; d < D; ++d) q.names.emplace_back(kAxes[d]);
  q.find = [&](const std::string& name) -> std::optional<ExpressionValue> {
    for (int d = 0; d < D; ++d)
      if (name == kAxes[d]) return ExpressionValue(place[d]);
    return std::nullopt;
  };
  return Expression("(" + text + ") + 0 * x").series(q);
}

template <int D>
class FieldNorm {
 public:
  FieldNorm(const Settings& norm, const Model<D>& model, const FieldParts& known)
      : norm_(norm), model_(model), elements_(elements_of(norm, model)) {
    std::vector<std::string> names;
    for (const auto& [name, component] : known) names.push_back(name);
    for (const std::string& name : norm.texts("fields")) {
      const auto found = known.find(name);
      if (found == known.end())
        throw norm.error("fields",
                         "this run has no field '" + name + "'." + did_you_mean(name, names),
                         "fields are " + join(names));
      components_.push_back(found->second);
    }
    if (norm.has("exact") && norm.texts("exact").size() != components_.size())
      throw norm.error("exact",
                       std::to_string(norm.texts("exact").size()) + " formulas for " +
                           std::to_string(components_.size()) + " fields",
                       "give one for each");
    place_points();
  }

  /// Roots of the mean squares of the difference and of what is exact.
  std::pair<double, double> find(double time) const {
    double difference = 0, size = 0;
    for (std::size_t k = 0; k < components_.size(); ++k) {
      const std::vector<double> exact = exact_values(k, time);
      for (std::size_t i = 0; i < exact.size(); ++i) {
        const double miss = value(components_[k], i) - exact[i];
        difference += weight_[i] * miss * miss;
        size += weight_[i] * exact[i] * exact[i];
      }
    }
    const double volume = std::accumulate(weight_.begin(), weight_.end(), 0.0);
    return {std::sqrt(difference / volume), std::sqrt(size / volume)};
  }

 private:
  void place_points() {
    for (const Index e : elements_) {
      const Simplex<D> x = corners(model_.mesh, e);
      for (int q = 0; q <= D; ++q) {
        weight_.push_back(signed_volume<D>(x) / (D + 1));
        for (int d = 0; d < D; ++d) {
          double at = 0;
          for (int a = 0; a <= D; ++a)
            at += (a == q ? Quadrature<D>::own : Quadrature<D>::other) * x[a][d];
          place_[d].push_back(at);
        }
      }
    }
  }

  double value(const Component& component, std::size_t point) const {
    const Index e = elements_[point / (D + 1)];
    if (!component.of_nodes) return component.at(e);
    double sum = 0;
    for (int a = 0; a <= D; ++a)
      sum += (a == static_cast<int>(point % (D + 1)) ? Quadrature<D>::own : Quadrature<D>::other) *
             component.at(nodes_(e, a));
    return sum;
  }

  std::vector<double> exact_values(std::size_t k, double time) const {
    if (!norm_.has("exact")) return std::vector<double>(weight_.size(), 0.0);
    try {
      return values_of<D>(norm_.texts("exact")[k], place_, time);
    } catch (const Error& error) {
      throw norm_.error("exact", error.what(), "formulas speak of x, y, z and time");
    }
  }

  const Settings& norm_;
  const Model<D>& model_;
  std::vector<Index> elements_;
  std::vector<Component> components_;
  std::vector<double> place_[D], weight_;
  decltype(Kokkos::create_mirror_view_and_copy(
      Kokkos::HostSpace{}, std::declval<const Store&>().get<ElementNodes<D>>())) nodes_ =
      Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{},
                                          model_.store.template get<ElementNodes<D>>());
};

std::string name_of(const Settings& norm) {
  return "norm." + norm.text("name");
}

}  // namespace

template <int D>
Numbers field_norms(Simulation<D>& simulation) {
  Numbers numbers;
  if (simulation.scene().list("norm").empty()) return numbers;
  const Picture picture = draw_all(simulation);
  FieldParts known;
  for (const PictureField& field : picture.node_fields) add_parts(field, true, known);
  for (const PictureField& field : picture.element_fields) add_parts(field, false, known);
  for (const Settings& norm : simulation.scene().list("norm")) {
    const auto [difference, size] =
        FieldNorm<D>(norm, simulation.model(), known).find(simulation.clock().time);
    numbers.emplace_back(name_of(norm), difference);
    if (norm.has("exact")) numbers.emplace_back(name_of(norm) + ".share", difference / size);
  }
  return numbers;
}

template Numbers field_norms<2>(Simulation<2>&);
template Numbers field_norms<3>(Simulation<3>&);

}  // namespace breccia
