// Selective mass scaling: nodes of the smallest elements are made heavier (ALGORITHMS ).
#include "core/log.hpp"
#include "modules/motion/motion.hpp"
#include "modules/motion/motion_fields.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace breccia {

namespace {

/// Largest share of added mass in a dynamic run.
constexpr double kCap = 0.05;

/// The masses that a step needs, node by node: m >= need * step^2.
struct Needs {
  std::vector<double> need, mass;

  double added(std::size_t n, double step) const {
    // A little more than needed, so that the step comes out as the one that was wanted.
    return std::max(0.0, need[n] * step * step * (1 + 1e-9) - mass[n]);
  }
  double share(double step) const {
    double more = 0, all = 0;
    for (std::size_t n = 0; n < mass.size(); ++n) more += added(n, step), all += mass[n];
    return more / all;
  }
  /// The longest step within the cap, to a thousandth.
  double longest(double beyond) const {
    double low = 0, high = beyond;
    while (high - low > 1e-3 * high) {
      const double middle = 0.5 * (low + high);
      (share(middle) <= kCap ? low : high) = middle;
    }
    return low;
  }
};

template <int D>
Needs needs_of(const Model<D>& model, const Array<double>& stiffness,
               typename Motion<D>::Factors factors) {
  const Store& s = model.store;
  const auto host = [](const auto& view) {
    return Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{}, view);
  };
  const auto corners = host(s.get<NodeCorners>());
  const auto list = host(s.get<CornerList>());
  const auto rate = host(s.get<ElementRate>());
  const auto mass = host(s.get<NodeMass>());
  const auto springs = host(stiffness);
  Needs needs;
  for (Index n = 0; n < model.nodes(); ++n) {
    double sum = 0;
    for (Index k = corners(n, 0); k < corners(n, 1); ++k) sum += rate(list(k) / (D + 1));
    const double spring = springs.extent(0) > 0 ? springs(n) : 0.0;
    const double factor = spring > 0 ? factors.springs : factors.bulk;
    needs.need.push_back((sum + spring) / (4 * factor * factor));
    needs.mass.push_back(mass(n));
  }
  return needs;
}

}  // namespace

template <int D>
void Motion<D>::scale_mass(Model<D>& model, const Array<double>& stiffness, Factors factors) {
  const Settings& section = model.scene->at("run.mass_scaling");
  const double step = section.number("step");
  const Needs needs = needs_of(model, stiffness, factors);
  model.added_mass = needs.share(step);
  if (model.added_mass > kCap && !section.flag("quasi_static"))
    throw section.error(
        "step",
        fmt::format("a step of {:.4g} s needs {:.3g} % more mass; a dynamic run may take {:.0f} %",
                    step, 100 * model.added_mass, 100 * kCap),
        fmt::format("take at most {:.4g} s, or write quasi_static = true where inertia does not "
                    "matter",
                    needs.longest(step)));
  const auto added = Kokkos::create_mirror_view(model.store.template get<NodeAddedMass>());
  const auto mass = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{},
                                                        model.store.template get<NodeMass>());
  Kokkos::deep_copy(added, 0.0);
  for (Index n = 0; n < model.nodes(); ++n) {
    added(n) = needs.added(static_cast<std::size_t>(n), step);
    mass(n) += added(n);
  }
  Kokkos::deep_copy(model.store.template get<NodeAddedMass>(), added);
  Kokkos::deep_copy(model.store.template get<NodeMass>(), mass);
  log::info(fmt::format("mass scaling adds {:.3g} % for a step of {:.4g} s", 100 * model.added_mass,
                        step));
}

template void Motion<2>::scale_mass(Model<2>&, const Array<double>&, Factors);
template void Motion<3>::scale_mass(Model<3>&, const Array<double>&, Factors);

}  // namespace breccia
