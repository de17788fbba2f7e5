#pragma once
#include "loops/contact_search.hpp"
#include "loops/list_tools.hpp"

namespace breccia {

/// Ratio of the cell sizes of neighbouring grids, and how many there may be.
inline constexpr int kGridRatio = 4;
inline constexpr int kGridLevels = 12;

/// Box around a target, larger by the skin on each side.
template <int D>
struct ContactBox {
  Vec<D> low, high;

  KOKKOS_FUNCTION
  ContactBox(const CornerVectors<D>& place, Index t, double skin) {
    for (int d = 0; d < D; ++d) {
      low[d] = high[d] = place(t, 0, d);
      for (int a = 1; a <= D; ++a) {
        low[d] = place(t, a, d) < low[d] ? place(t, a, d) : low[d];
        high[d] = place(t, a, d) > high[d] ? place(t, a, d) : high[d];
      }
      low[d] -= skin;
      high[d] += skin;
    }
  }
  KOKKOS_FUNCTION
  double size() const {
    double s = 0;
    for (int d = 0; d < D; ++d) s = high[d] - low[d] > s ? high[d] - low[d] : s;
    return s;
  }
  KOKKOS_FUNCTION
  bool holds(const Vec<D>& q) const {
    bool in = true;
    for (int d = 0; d < D; ++d) in = in && q[d] >= low[d] && q[d] <= high[d];
    return in;
  }
};

/// The grids: from places to cells, tags and buckets.
struct ContactGrid {
  double cell;
  Index buckets;  ///< a power of two

  KOKKOS_FUNCTION
  int level_of(double size) const {
    int level = 0;
    for (double c = 2 * cell; size > c && level < kGridLevels - 1; c *= kGridRatio) ++level;
    return level;
  }
  KOKKOS_FUNCTION
  double size_of(int level) const {
    double c = cell;
    for (int l = 0; l < level; ++l) c *= kGridRatio;
    return c;
  }
  /// Cell number along one axis; far away ones are held at the rim, where they cost time but miss
  /// nothing.
  KOKKOS_FUNCTION
  static std::int64_t along(double x, double size) {
    constexpr double kRim = 134217727;  // 2^27 - 1
    const double c = Kokkos::floor(x / size);
    return static_cast<std::int64_t>(c < -kRim ? -kRim : (c > kRim ? kRim : c));
  }
  KOKKOS_FUNCTION
  static std::uint64_t tag(int level, std::int64_t i, std::int64_t j) {
    constexpr std::uint64_t kMask = (1u << 28) - 1;
    return (static_cast<std::uint64_t>(level) << 56) |
           ((static_cast<std::uint64_t>(i) & kMask) << 28) |
           (static_cast<std::uint64_t>(j) & kMask);
  }
  KOKKOS_FUNCTION
  Index bucket(std::uint64_t tag) const {
    tag ^= tag >> 31;
    tag *= 0x9E3779B97F4A7C15ull;
    tag ^= tag >> 29;
    tag *= 0xBF58476D1CE4E5B9ull;
    tag ^= tag >> 32;
    return static_cast<Index>(tag & static_cast<std::uint64_t>(buckets - 1));
  }

  /// Calls f(tag) for each cell that the box touches.
  template <class F>
  KOKKOS_FUNCTION
  void cover(const ContactBox<2>& box, const F& f) const {
    const int level = level_of(box.size());
    const double size = size_of(level);
    const std::int64_t i1 = along(box.high[0], size), j1 = along(box.high[1], size);
    for (std::int64_t i = along(box.low[0], size); i <= i1; ++i)
      for (std::int64_t j = along(box.low[1], size); j <= j1; ++j) f(tag(level, i, j));
  }
  KOKKOS_FUNCTION
  std::uint64_t tag_at(int level, const Vec<2>& q) const {
    const double size = size_of(level);
    return tag(level, along(q[0], size), along(q[1], size));
  }
};

/// Renders all targets.
template <int D>
void fill_contact_bins(const ContactSurface<D>& surface, double skin, ContactBins<D>& bins);

}  // namespace breccia
