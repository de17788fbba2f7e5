#include "loops/contact_flyers.hpp"

#include "contact_samples.hpp"
#include "core/random.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace {

using namespace breccia;

struct Box {
  Vec<2> low{{1e30, 1e30}}, high{{-1e30, -1e30}};
  void add(const Vec<2>& x) {
    for (int d = 0; d < 2; ++d) {
      low[d] = std::min(low[d], x[d]);
      high[d] = std::max(high[d], x[d]);
    }
  }
  Box moved(const Vec<2>& by, double grown) const {
    Box box = *this;
    box.low += by - Vec<2>{{grown, grown}};
    box.high += by + Vec<2>{{grown, grown}};
    return box;
  }
  bool touches(const Box& other) const {
    for (int d = 0; d < 2; ++d)
      if (high[d] < other.low[d] || low[d] > other.high[d]) return false;
    return true;
  }
};

/// Blocks of some elements at random places, which have gone some way since the search.
struct Flight {
  static constexpr Index kBodies = 40;
  ContactWorld<2> world;
  ContactPieces<2> pieces;
  std::vector<Vec<2>> shift, velocity, place;
  Vectors<2> x, v;

  explicit Flight(std::uint64_t seed) : world(blocks(seed)) {
    const Random random{seed, 9};
    world.update_surface();
    world.search();
    place = world.x;
    for (Index b = 0; b < kBodies; ++b) {
      shift.push_back({{random.uniform(b, 4) - 0.5, random.uniform(b, 5) - 0.5}});
      velocity.push_back({{random.uniform(b, 6), random.uniform(b, 7)}});
    }
    x = Vectors<2>("x", world.x.size());
    v = Vectors<2>("v", world.x.size());
    const auto hx = Kokkos::create_mirror_view(x), hv = Kokkos::create_mirror_view(v);
    for (std::size_t e = 0; e < world.mesh.element.size(); ++e)
      for (const Index n : world.mesh.element[e])
        for (int d = 0; d < 2; ++d) {
          const auto b = static_cast<std::size_t>(world.mesh.body[e]);
          hx(n, d) = place[static_cast<std::size_t>(n)][d] + shift[b][d];
          hv(n, d) = velocity[b][d];
        }
    Kokkos::deep_copy(x, hx);
    Kokkos::deep_copy(v, hv);
    pieces.count = kBodies;
    pieces.of_target = to_device("of", bodies_of_targets());
    pieces.first = Array<Index>("first", kBodies);
    pieces.numbers = decltype(pieces.numbers)("numbers", kBodies);
    box_pieces(world.surface, pieces);
    move_pieces<2>(world.surface, pieces, x, v);
  }

  static Mesh<2> blocks(std::uint64_t seed) {
    const Random random{seed, 8};
    std::vector<Mesh<2>> all;
    for (Index b = 0; b < kBodies; ++b) {
      const double at_x = 8 * random.uniform(b, 0), at_y = 8 * random.uniform(b, 1);
      all.push_back(block({at_x, at_y},
                          {at_x + 0.2 + random.uniform(b, 2), at_y + 0.2 + random.uniform(b, 3)}, 2,
                          3));
    }
    return join<2>(all);
  }

  std::vector<Index> bodies_of_targets() const {
    std::vector<Index> of;
    for (const Index e : to_host(world.surface.target, world.surface.targets))
      of.push_back(world.mesh.body[static_cast<std::size_t>(e)]);
    return of;
  }

  bool brute_force(Index flyer, const std::vector<double>& grown) const {
    const auto& mesh = world.mesh;
    Box box;
    for (std::size_t e = 0; e < mesh.element.size(); ++e)
      if (mesh.body[e] == flyer)
        for (const Index n : mesh.element[e]) box.add(place[static_cast<std::size_t>(n)]);
    const auto f = static_cast<std::size_t>(flyer);
    for (std::size_t e = 0; e < mesh.element.size(); ++e) {
      const auto b = static_cast<std::size_t>(mesh.body[e]);
      if (b == f) continue;
      Box other;
      for (const Index n : mesh.element[e]) other.add(place[static_cast<std::size_t>(n)]);
      if (box.moved(shift[f], grown[f]).touches(other.moved(shift[b], grown[b]))) return true;
    }
    return false;
  }
};

TEST(ContactFlyers, PiecesTellHowTheyMoved) {
  const Flight flight(1);
  using P = ContactPieces<2>;
  const auto numbers =
      Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{}, flight.pieces.numbers);
  for (Index b = 0; b < Flight::kBodies; ++b) {
    const auto i = static_cast<std::size_t>(b);
    for (int d = 0; d < 2; ++d) EXPECT_NEAR(numbers(b, P::shift + d), flight.shift[i][d], 1e-14);
    EXPECT_NEAR(numbers(b, P::way), norm2(flight.shift[i]), 1e-13);
    EXPECT_NEAR(numbers(b, P::speed), norm2(flight.velocity[i]), 1e-13);
    EXPECT_NEAR(numbers(b, P::spread), 0, 1e-26);
    EXPECT_EQ(numbers(b, P::turn), 0);
  }
}

// V-054 for pieces that fly: whether boxes touch is what brute force says, whatever else flies.
TEST(ContactFlyers, NearIsWhatBruteForceSays) {
  int near = 0, clear = 0;
  for (std::uint64_t seed = 1; seed < 6; ++seed) {
    const Flight flight(seed);
    const Random random{seed, 10};
    const PieceReach<2> reach("reach", Flight::kBodies);
    const auto host = Kokkos::create_mirror_view(reach);
    std::vector<double> grown;
    for (Index b = 0; b < Flight::kBodies; ++b) {
      grown.push_back(0.1 * random.uniform(b));
      for (int d = 0; d < 2; ++d) {
        host(b, d) = flight.shift[static_cast<std::size_t>(b)][d] - grown.back();
        host(b, 2 + d) = flight.shift[static_cast<std::size_t>(b)][d] + grown.back();
      }
    }
    Kokkos::deep_copy(reach, host);
    for (Index b = 0; b < Flight::kBodies; ++b) {
      const bool expected = flight.brute_force(b, grown);
      ++(expected ? near : clear);
      EXPECT_EQ(pieces_near(flight.world.surface, flight.pieces, reach,
                            to_device("list", std::vector<Index>{b}), 1),
                expected)
          << b;
    }
  }
  EXPECT_GT(near, 10);
  EXPECT_GT(clear, 10);
}

}  // namespace
