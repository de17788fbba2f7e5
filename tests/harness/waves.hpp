#pragma once
#include "harness/scenes.hpp"

#include <cmath>
#include <string>
#include <vector>

namespace breccia {

/// A standing wave in a box from the origin whose sides slide without friction:
///   u_i = a_i sin(k_i x_i) prod_{j != i} cos(k_j x_j) cos(omega t),  k_i L_i / pi integer.
/// It solves linear elasticity exactly with omega = c_p |k| where a is along k (div u carries it) and
/// with omega = c_s |k| where a is normal to k (div u = 0).
template <int D>
struct StandingWave {
  Vec<D> k;  ///< rad/m
  Vec<D> a;  ///< m
  double omega;

  Vec<D> shape(const Vec<D>& x) const {
    Vec<D> u;
    for (int i = 0; i < D; ++i) {
      u[i] = a[i] * std::sin(k[i] * x[i]);
      for (int j = 0; j < D; ++j)
        if (j != i) u[i] *= std::cos(k[j] * x[j]);
    }
    return u;
  }
  /// du_i / dx_j of the shape.
  Mat<D> gradient(const Vec<D>& x) const {
    Mat<D> g;
    for (int i = 0; i < D; ++i)
      for (int j = 0; j < D; ++j) {
        g(i, j) = a[i];
        for (int m = 0; m < D; ++m) {
          const double phase = k[m] * x[m];
          const bool sine = m == i;
          const double value = sine ? std::sin(phase) : std::cos(phase);
          const double slope = k[m] * (sine ? std::cos(phase) : -std::sin(phase));
          g(i, j) *= m == j ? slope : value;
        }
      }
    return g;
  }
};

/// All sides of body "b" slide: their normal component is held.
inline std::string sliding_sides(int dimension) {
  const char* sides[3][2] = {{"left", "right"}, {"bottom", "top"}, {"front", "back"}};
  std::string text;
  for (int d = 0; d < dimension; ++d)
    for (const char* side : sides[d]) {
      std::string fixed;
      for (int i = 0; i < dimension; ++i)
        fixed += std::string(i ? ", " : "") + (i == d ? "0" : "\"free\"");
      text += fmt::format("[[boundary]]\nwhere = \"b.{}\"\nfixed = [{}]\n", side, fixed);
    }
  return text;
}

/// Steps of a length that the scene language would refuse: for what lies beyond the stable step.
template <int D>
void run_step(SceneWorld<D>& world, Clock& clock) {
  Plan& plan = world.simulation.plan();
  plan.run(Stage::search, Stage::split, clock);
  plan.run(Stage::assemble, Stage::observe, clock);
  clock.time += clock.dt;
  clock.dt_before = clock.dt;
  ++clock.step;
}

/// Displacement of every node.
template <int D>
std::vector<Vec<D>> displacements(SceneWorld<D>& world) {
  const auto x = world.template host<NodePosition<D>>();
  std::vector<Vec<D>> u;
  for (Index n = 0; n < world.model().mesh.points(); ++n)
    u.push_back(row<D>(x, n) - vector_of<D>(world.model().mesh.point[static_cast<std::size_t>(n)]));
  return u;
}

/// Slope of log(error) over log(size).
inline double slope(double error_coarse, double error_fine, double ratio) {
  return std::log(error_coarse / error_fine) / std::log(ratio);
}

}  // namespace breccia
