#pragma once
#include "harness/simulation.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

namespace breccia {

/// Scenes of a few bodies in contact, and what is measured on them.
struct Slab {
  std::string name, corner, size, cells;
  std::string velocity = "[0, 0]", spin = "0";
  std::string pattern = "cross";

  std::string text() const {
    return fmt::format(
        "[[body]]\nname = \"{}\"\nmaterial = \"m\"\nvelocity = {}\nspin = \"{} rad/s\"\n"
        "shape = {{ rectangle = {{ corner = {}, size = {} }} }}\n"
        "mesh = {{ generator = \"structured\", cells = {}, pattern = \"{}\", jitter = 0.2 }}\n",
        name, velocity, spin, corner, size, cells, pattern);
  }
};

inline std::string contact_scene(const std::vector<Slab>& slabs, const std::string& material,
                                 const std::string& contact, const std::string& run = {},
                                 const std::string& more = {}) {
  std::string text = "[run]\ndimension = 2\nduration = 1\n" + run + "\n";
  for (const Slab& slab : slabs) text += slab.text();
  return text + "[material.m]\n" + material + "\n[contact]\n" + contact + "\n" + more;
}

/// Sums over the nodes of one body (or of all, if it has no name) at t^(n-1/2).
template <int D>
struct MomentumOf {
  decltype(cross(Vec<D>(), Vec<D>())) angular{};
  double mass = 0, size = 0;  ///< size: sum of |m v|
  Vec<D> linear = Vec<D>::zero(), centre = Vec<D>::zero();
  Vec<D> velocity() const { return linear * (1 / mass); }
};
using Momentum = MomentumOf<2>;

template <int D>
MomentumOf<D> momentum(SceneWorld<D>& world, const std::string& body = {}) {
  const auto x = world.template host<NodePosition<D>>();
  const auto v = world.template host<NodeVelocity<D>>();
  const auto m = world.template host<NodeMass>();
  std::vector<Index> nodes;
  if (body.empty())
    for (Index n = 0; n < world.model().nodes(); ++n) nodes.push_back(n);
  else
    nodes = find_region(world.model().mesh, body)->points;
  MomentumOf<D> sum;
  for (const Index n : nodes) {
    const Vec<D> at = row<D>(x, n), p = row<D>(v, n) * m(n);
    sum.mass += m(n);
    sum.linear += p;
    sum.size += norm(p);
    sum.centre += at * m(n);
    sum.angular += cross(at, p);
  }
  sum.centre *= 1 / sum.mass;
  return sum;
}

/// Steps to time `end`, `each()` taking one; ends with a failure when the run stops before, or when
/// its steps have become so small that it would never end.
template <class Each>
void run_to(SceneWorld<2>& world, double end, const Each& each) {
  const double most = 100 + 10 * (end - world.time()) / world.simulation.clock().dt;
  for (double n = 0; world.time() < end && !::testing::Test::HasFatalFailure(); ++n) {
    ASSERT_FALSE(world.model().stop.raised) << world.model().stop.cause;
    ASSERT_LT(n, most) << "steps have become too small";
    each();
  }
}
inline void run_to(SceneWorld<2>& world, double end) {
  run_to(world, end, [&] { world.step(); });
}

inline double total_energy(const Ledger& ledger) {
  return ledger.kinetic + ledger.stored();
}

}  // namespace breccia
