#include "scene/precision.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace breccia {

namespace {

/// Noise of the stress in an element that has turned by about a radian, as a share of its P-wave
/// modulus: some units of 2^-24 (tests/patch/precision.cpp). In one that has not turned it is this
/// share of the stress itself.
constexpr double kNoise = 4.0 / (1 << 24);

/// Noise that is no longer worth a word, as a share of what counts.
constexpr double kSmall = 0.01;

template <int D>
double stiffest(const Model<D>& model) {
  double modulus = 0;
  for (const Block& block : model.blocks)
    if (!model.materials[block.material].rigid)
      modulus = std::max(modulus, model.p_wave_modulus(block.material));
  return modulus;
}

/// The largest ratio of P-wave and shear modulus of what is elastic in single precision.
template <int D>
double incompressibility(const Model<D>& model) {
  double ratio = 1;
  for (const Material& material : model.materials)
    if (!material.rigid && !material.yields() && !material.eos && !material.stiffness)
      ratio = std::max(ratio, (material.bulk() + 4.0 / 3 * material.mu()) / material.mu());
  return ratio;
}

/// The smallest strength of all faces, Pa; infinite where nothing breaks.
double weakest(const Settings& scene) {
  double strength = std::numeric_limits<double>::infinity();
  const auto look = [&strength](const Settings& law) {
    for (const char* key : {"tensile_strength", "cohesion"})
      if (law.has(key) && law.number(key) > 0) strength = std::min(strength, law.number(key));
  };
  for (const Settings& law : scene.children("fracture")) look(law);
  for (const Settings& law : scene.list("interface")) look(law);
  for (const Settings& set : scene.list("fractures"))
    if (set.has("law")) look(set.at("law"));
  return strength;
}

/// The fastest node of the start, m/s.
template <int D>
double fastest(const Model<D>& model) {
  const auto v = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{},
                                                     model.store.template get<NodeVelocity<D>>());
  double speed = 0;
  for (Index n = 0; n < model.nodes(); ++n) speed = std::max(speed, norm(row<D>(v, n)));
  return speed;
}

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
  const double noise = kNoise * stiffest(model);
  const double strength = weakest(scene);
  if (noise > kSmall * strength)
    lines.push_back(fmt::format(
        "run.precision = \"mixed\": elements that turn have a noise of some {:.2g} Pa in their "
        "stress, {:.2g} % of the smallest strength ({:.3g} Pa); run.precision = \"double\" has "
        "none",
        noise, 100 * noise / strength, strength));
  const double speed = fastest(model);
  if (!std::isfinite(strength) && scene.has("contact") && speed > 0) {
    double impact = 0;
    for (const Material& material : model.materials)
      if (!material.rigid)
        impact = std::max(impact, speed * std::sqrt(material.density * stiffest(model)));
    if (noise > kSmall * impact)
      lines.push_back(fmt::format(
          "run.precision = \"mixed\": bodies that turn have a noise of some {:.2g} Pa in their "
          "stress, {:.2g} % of what meeting at {:.3g} m/s makes; run.precision = \"double\" has "
          "none",
          noise, 100 * noise / impact, speed));
  }
  // What shear and dilation make of the same round-off differs by the ratio of their moduli.
  const double stiffness = incompressibility(model), share = kNoise * stiffness;
  if (share > 1e-3)
    lines.push_back(fmt::format(
        "run.precision = \"mixed\": in a material that resists dilation {:.3g} times as "
        "much as shear, round-off makes a noise of {:.2g} % of the shear stress; take "
        "run.precision = \"double\" where that matters",
        stiffness, 100 * share));
  const double reach = 3e-7 * stiffness;
  if (scene.has("run.rest") && scene.at("run.rest").number("tolerance") < reach)
    lines.push_back(
        fmt::format("run.rest: forces in single precision balance to some {:.0e} of their size, "
                    "and a tolerance of {:.2g} may never be met; take a larger one, or "
                    "run.precision = \"double\"",
                    reach, scene.at("run.rest").number("tolerance")));
  return lines;
}

template std::vector<std::string> left_in_double(const Model<2>&);
template std::vector<std::string> left_in_double(const Model<3>&);
template std::vector<std::string> precision_doubts(const Model<2>&);
template std::vector<std::string> precision_doubts(const Model<3>&);

}  // namespace breccia
