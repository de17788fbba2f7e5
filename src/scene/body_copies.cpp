#include "scene/body_copies.hpp"

#include "core/random.hpp"

#include <array>
#include <cmath>
#include <numbers>

namespace breccia {

namespace {

constexpr std::uint32_t kCopies = 0x636f7079;  ///< stream of the random numbers

/// A rotation, all of them alike probable: Shoemake, Graphics Gems III (1992) 124, in space.
template <int D>
Mat<D> random_turn(const Random& random, std::uint64_t site) {
  const auto angle = [&](std::uint32_t draw) {
    return 2 * std::numbers::pi * random.uniform(site, draw);
  };
  if constexpr (D == 2) {
    const double a = angle(0);
    return {{{std::cos(a), -std::sin(a)}, {std::sin(a), std::cos(a)}}};
  } else {
    const double u = random.uniform(site, 0), a = angle(1), b = angle(2);
    const double x = std::sqrt(1 - u) * std::sin(a), y = std::sqrt(1 - u) * std::cos(a),
                 z = std::sqrt(u) * std::sin(b), w = std::sqrt(u) * std::cos(b);
    return {{{1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)},
             {2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)},
             {2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)}}};
  }
}

/// The sites of a raster, numbered with the last axis fastest.
template <int D>
struct Raster {
  std::array<std::int64_t, D> count{}, hollow{};
  std::int64_t every = 1, offset = 0;

  explicit Raster(const Settings& copies) {
    for (int d = 0; d < D; ++d) {
      count[d] = copies.integers("count")[d];
      hollow[d] = copies.has("hollow") ? copies.integers("hollow")[d] : 0;
    }
    every = copies.integer("every");
    offset = copies.integer("offset");
  }

  [[nodiscard]] std::int64_t sites() const {
    std::int64_t n = 1;
    for (int d = 0; d < D; ++d) n *= count[d];
    return n;
  }
  /// Site numbers along the axes.
  [[nodiscard]] std::array<std::int64_t, D> at(std::int64_t site) const {
    std::array<std::int64_t, D> i{};
    for (int d = D - 1; d >= 0; --d) {
      i[d] = site % count[d];
      site /= count[d];
    }
    return i;
  }
  /// Not in the hollow in the middle, and the turn of this body along the diagonals.
  [[nodiscard]] bool taken(const std::array<std::int64_t, D>& i) const {
    bool inside = true;
    std::int64_t sum = 0;
    for (int d = 0; d < D; ++d) {
      inside = inside && 2 * i[d] + 1 > count[d] - hollow[d] && 2 * i[d] + 1 < count[d] + hollow[d];
      sum += i[d];
    }
    return !inside && sum % every == offset;
  }
};

template <int D>
std::vector<Placement<D>> placements(const Settings& copies, const Random& random,
                                     const Vec<D>& first) {
  const Raster<D> raster(copies);
  const auto& pitch = copies.vector("pitch");
  const double shift = copies.has("shift") ? copies.number("shift") : 0;
  const bool turned = copies.flag("turned");
  std::vector<Placement<D>> list;
  for (std::int64_t site = 0; site < raster.sites(); ++site) {
    const auto i = raster.at(site);
    if (!raster.taken(i)) continue;
    const auto id = static_cast<std::uint64_t>(site);
    Placement<D> place{Mat<D>::identity(), first};
    for (int d = 0; d < D; ++d)
      place.centre[d] += pitch[d] * static_cast<double>(i[d]) +
                         shift * (2 * random.uniform(id, 3 + static_cast<std::uint32_t>(d)) - 1);
    if (turned) place.turn = random_turn<D>(random, id);
    list.push_back(place);
  }
  if (list.empty())
    throw copies.error("", "no site of this raster is taken",
                       "lessen the hollow, or give more sites");
  return list;
}

}  // namespace

template <int D>
void make_copies(const Settings& scene, Mesh<D>& mesh) {
  std::uint32_t stream = kCopies;
  for (const Settings& body : scene.list("body")) {
    ++stream;
    if (!body.has("copies")) continue;
    const Index number = find_body(mesh, body.name());
    const Settings& copies = body.at("copies");
    const Random random{static_cast<std::uint64_t>(scene.at("run").integer("seed")), stream};
    copy_body<D>(mesh, number, placements<D>(copies, random, middle_of_body(mesh, number)));
  }
}

template void make_copies(const Settings&, Mesh<2>&);
template void make_copies(const Settings&, Mesh<3>&);

}  // namespace breccia
