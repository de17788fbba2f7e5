#include "scene/precision.hpp"

#include <fmt/format.h>

namespace breccia {

namespace {

/// Net forces of elements that balance in double, as a share of the forces: some units of 2^-24
/// (tests/patch/precision.cpp) of those that meet at a node.
constexpr double kBalance = 3e-6;

}  // namespace

template <int D>
std::vector<std::string> left_in_double(const Model<D>& model) {
  std::vector<std::string> lines;
  if (!model.mixed) return lines;
  for (const Material& material : model.materials) {
    const bool stressed = !model.initial_stress.empty() && !material.stiffness;
    if (material.rigid || !(material.yields() || material.eos || stressed)) continue;
    lines.push_back(fmt::format("elements of '{}' are computed in double: the material {}",
                                material.name,
                                material.yields() ? "yields"
                                : material.eos    ? "has an equation of state"
                                                  : "begins under stress"));
  }
  return lines;
}

template <int D>
std::vector<std::string> precision_doubts(const Model<D>& model) {
  std::vector<std::string> lines;
  if (!model.mixed) return lines;
  const Settings& scene = *model.scene;
  if (scene.has("run.rest") && scene.at("run.rest").number("tolerance") < kBalance)
    lines.push_back(
        fmt::format("run.rest: forces in single precision balance to some {:.0e} of their size, "
                    "and a tolerance of {:.2g} may never be met; take a larger one, or "
                    "run.precision = \"double\"",
                    kBalance, scene.at("run.rest").number("tolerance")));
  return lines;
}

template std::vector<std::string> left_in_double(const Model<2>&);
template std::vector<std::string> left_in_double(const Model<3>&);
template std::vector<std::string> precision_doubts(const Model<2>&);
template std::vector<std::string> precision_doubts(const Model<3>&);

}  // namespace breccia
