#pragma once
#include "loops/contact_search.hpp"
#include "loops/list_tools.hpp"

namespace breccia {

/// The grids of the search: ratio of the cell sizes of neighbouring ones and how many there may be;
/// the finest cell over the smallest box, the largest box of a grid over its cell; bits of a cell
/// number.
template <int D>
struct GridShape;
template <>
struct GridShape<2> {
  static constexpr int ratio = 4, levels = 12, bits = 28;
  static constexpr double smallest = 0.75, largest = 2;
};
template <>
struct GridShape<3> {
  static constexpr int ratio = 2, levels = 16, bits = 20;
  static constexpr double smallest = 1, largest = 1;
};

/// Box around a target, larger by the skin on each side.
template <int D>
struct ContactBox {
  Vec<D> low, high;

  KOKKOS_FUNCTION
  ContactBox(const ContactBins<D>& bins, Index t) {
    for (int d = 0; d < D; ++d) {
      low[d] = bins.box(t, d);
      high[d] = bins.box(t, D + d);
    }
  }
  KOKKOS_FUNCTION
  double size() const {
    double s = 0;
    for (int d = 0; d < D; ++d) s = high[d] - low[d] > s ? high[d] - low[d] : s;
    return s;
  }
};

/// The grids: from places to cells, tags and buckets. A box lies in the first grid that holds
/// boxes of its size.
template <int D>
struct ContactGrid {
  using Shape = GridShape<D>;
  double cell;    ///< of the finest grid, m
  Index buckets;  ///< a power of two

  KOKKOS_FUNCTION
  int level_of(double size) const {
    int level = 0;
    for (double c = Shape::largest * cell; size > c && level < Shape::levels - 1; c *= Shape::ratio)
      ++level;
    return level;
  }
  KOKKOS_FUNCTION
  double size_of(int level) const {
    double c = cell;
    for (int l = 0; l < level; ++l) c *= Shape::ratio;
    return c;
  }
  /// Cell number along one axis; far away ones are held at the rim, where they cost time but miss
  /// nothing.
  KOKKOS_FUNCTION
  static std::int64_t along(double x, double size) {
    constexpr double kRim = (std::int64_t{1} << (Shape::bits - 1)) - 1;
    const double c = Kokkos::floor(x / size);
    return static_cast<std::int64_t>(c < -kRim ? -kRim : (c > kRim ? kRim : c));
  }
  KOKKOS_FUNCTION
  static std::uint64_t tag(int level, const std::int64_t (&cell)[D]) {
    constexpr std::uint64_t kMask = (std::uint64_t{1} << Shape::bits) - 1;
    auto t = static_cast<std::uint64_t>(level);
    for (int d = 0; d < D; ++d)
      t = (t << Shape::bits) | (static_cast<std::uint64_t>(cell[d]) & kMask);
    return t;
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
  void cover(const ContactBox<D>& box, const F& f) const {
    const int level = level_of(box.size());
    const double size = size_of(level);
    std::int64_t first[D], last[D], at[D];
    for (int d = 0; d < D; ++d) {
      at[d] = first[d] = along(box.low[d], size);
      last[d] = along(box.high[d], size);
    }
    while (at[0] <= last[0]) {
      f(tag(level, at));
      int d = D - 1;
      for (; d > 0 && at[d] == last[d]; --d) at[d] = first[d];
      ++at[d];
    }
  }
  KOKKOS_FUNCTION
  std::uint64_t tag_at(int level, const Vec<D>& q) const {
    const double size = size_of(level);
    std::int64_t at[D];
    for (int d = 0; d < D; ++d) at[d] = along(q[d], size);
    return tag(level, at);
  }
};

/// Renders all targets.
template <int D>
void fill_contact_bins(const ContactSurface<D>& surface, double skin, ContactBins<D>& bins);

}  // namespace breccia
