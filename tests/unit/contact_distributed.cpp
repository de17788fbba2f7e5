// The distributed potential, kept to compare: what it conserves, and how its force changes from
// element to element where the smooth one does not.
#include "contact_samples.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace {

using namespace breccia;

constexpr double kFloorSize = 0.1;

/// A disc upon a floor of elements that are larger than its own.
ContactWorld<2> disc_on_floor(bool distributed, double radius, const Vec<2>& centre) {
  Grid<2> floor;
  floor.lower = {0, -0.3};
  floor.upper = {1.2, 0};
  floor.cells = {12, 3};
  floor.jitter = 0.2;
  ContactWorld<2> world(
      join<2>({ring_disc(centre, radius, 32, 4, 0, "disc"), structured_mesh(floor)}));
  world.distributed = distributed;
  world.skin = 0.02;
  world.update_surface();
  return world;
}

/// Turns the disc about its first centre and moves that to `to`.
void place_disc(ContactWorld<2>& world, const std::vector<Vec<2>>& start, const Vec<2>& centre,
                const Vec<2>& to, double turn) {
  const double c = std::cos(turn), s = std::sin(turn);
  for (std::size_t e = 0; e < world.mesh.element.size(); ++e) {
    if (world.mesh.body[e] != 0) continue;
    for (const Index n : world.mesh.element[e]) {
      const Vec<2> r = start[n] - centre;
      world.x[n] = to + Vec<2>{{c * r[0] - s * r[1], s * r[0] + c * r[1]}};
    }
  }
}

/// What the floor gives to the points of a disc that rolls over it, its centre at one height.
struct Roll {
  double mean = 0, scatter = 0;  ///< N; standard deviation over the mean
};

Roll roll_over(bool distributed, double radius, double depth) {
  const Vec<2> centre{{0.4, radius - depth}};
  ContactWorld<2> world = disc_on_floor(distributed, radius, centre);
  const std::vector<Vec<2>> start = world.x;
  Roll roll;
  double square = 0;
  constexpr int kSamples = 60;
  for (int i = 0; i < kSamples; ++i) {
    const double way = i * 4 * kFloorSize / kSamples;
    place_disc(world, start, centre, centre + Vec<2>{{way, 0}}, -way / radius);
    world.search();
    world.force();
    const double up = world.point_force(0)[1];
    roll.mean += up / kSamples;
    square += up * up / kSamples;
  }
  roll.scatter = std::sqrt(std::max(0.0, square - roll.mean * roll.mean)) / roll.mean;
  return roll;
}

// V-035: a disc a fifth as large as the floor's elements, a tenth of one deep. The potential of the
// elements vanishes between them; the nodal one does not see them.
TEST(DistributedContact, RollsUnevenlyWhereTheSmoothOneDoesNot) {
  for (const double radius : {0.02, 0.05}) {
    const Roll smooth = roll_over(false, radius, 0.01), old = roll_over(true, radius, 0.01);
    std::printf("radius %.2f h: smooth %.4f, distributed %.3f\n", radius / kFloorSize,
                smooth.scatter, old.scatter);
    EXPECT_LT(smooth.scatter, 0.05);
    EXPECT_GT(old.scatter, 0.3);
    EXPECT_GT(smooth.mean, 0);
    EXPECT_LT(old.mean, smooth.mean);
  }
}

// Both momenta: forces of a pair act at one place.
TEST(DistributedContact, KeepsMomenta) {
  ContactWorld<2> world = disc_on_floor(true, 0.1, {{0.43, 0.085}});
  world.friction = 0.5;
  world.dt_before = 1e-5;
  for (auto& v : world.v) v = {{0, 0}};
  for (std::size_t e = 0; e < world.mesh.element.size(); ++e)
    for (const Index n : world.mesh.element[e])
      if (world.mesh.body[e] == 0) world.v[n] = {{10, -3}};
  world.search();
  world.force();
  world.force();
  Vec<2> sum = Vec<2>::zero();
  double moment = 0, size = 0;
  const auto force = world.node_force();
  for (std::size_t n = 0; n < force.size(); ++n) {
    sum += force[n];
    moment += cross(world.x[n], force[n]);
    size += norm(force[n]);
  }
  EXPECT_GT(std::abs(world.point_force(0)[0]), 0.1 * world.point_force(0)[1]);  // it rubs
  EXPECT_LT(norm(sum), 1e-13 * size);
  EXPECT_LT(std::abs(moment), 1e-13 * size);
}

/// Work over a closed way of a rigid disc in a rigid floor, over the work done on its way down.
double work_of_a_loop(int samples) {
  const Vec<2> centre{{0.45, 0.1}};
  ContactWorld<2> world = disc_on_floor(true, 0.1, centre);
  const std::vector<Vec<2>> start = world.x;
  double work = 0, size = 0;
  Vec<2> before = Vec<2>::zero(), at = centre;
  for (int i = 0; i <= samples; ++i) {
    const double angle = 2 * std::numbers::pi * i / samples;
    const Vec<2> to = centre + Vec<2>{{0.08 * std::sin(angle), -0.03 * (1 - std::cos(angle))}};
    place_disc(world, start, centre, to, 0);
    world.search();
    world.force();
    const Vec<2> force = world.point_force(0) - world.point_force(1);
    if (i > 0) {
      const double done = 0.5 * dot(before + force, to - at);
      work += done;
      size += 0.5 * std::abs(done);
    }
    before = force;
    at = to;
  }
  return std::abs(work) / size;
}

// The force is the exact gradient of an energy for any meshes: with finer steps nothing is left.
TEST(DistributedContact, GivesNoWorkOnAClosedWay) {
  const double coarse = work_of_a_loop(200), fine = work_of_a_loop(800);
  std::printf("work of a loop: %.2e, %.2e\n", coarse, fine);
  EXPECT_LT(fine, 1e-4);
  EXPECT_LT(fine, 0.2 * coarse);
}

}  // namespace
