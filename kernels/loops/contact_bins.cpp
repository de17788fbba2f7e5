#include "loops/contact_bins.hpp"

namespace breccia {

namespace {

/// Measures the boxes of the targets; returns the size of the smallest.
template <int D>
double find_boxes(const ContactSurface<D>& surface, double skin, ContactBins<D>& bins) {
  make_room(bins.box, surface.targets);
  const ContactBins<D> b = bins;
  const CornerVectors<D> place = surface.place;
  double least = 0;
  count_launch();
  Kokkos::parallel_reduce(
      "breccia::contact::boxes",
      Kokkos::RangePolicy<Exec, Kokkos::IndexType<Index>>(0, surface.targets),
      KOKKOS_LAMBDA(Index t, double& part) {
        for (int d = 0; d < D; ++d) {
          double low = place(t, 0, d), high = low;
          for (int a = 1; a <= D; ++a) {
            low = place(t, a, d) < low ? place(t, a, d) : low;
            high = place(t, a, d) > high ? place(t, a, d) : high;
          }
          b.box(t, d) = low - skin;
          b.box(t, D + d) = high + skin;
        }
        const double size = ContactBox<D>(b, t).size();
        part = size < part ? size : part;
      },
      Kokkos::Min<double>(least));
  return least;
}

struct GridUse {
  Index entries;
  std::uint32_t levels;
};

template <int D>
GridUse use_of(const ContactBins<D>& bins, Index targets, const ContactGrid<D>& grid) {
  Index entries = 0;
  std::uint32_t levels = 0;
  count_launch();
  Kokkos::parallel_reduce(
      "breccia::contact::count_cells",
      Kokkos::RangePolicy<Exec, Kokkos::IndexType<Index>>(0, targets),
      KOKKOS_LAMBDA(Index t, Index & n, std::uint32_t & l) {
        const ContactBox<D> box(bins, t);
        l |= 1u << grid.level_of(box.size());
        grid.cover(box, [&](std::uint64_t) { ++n; });
      },
      Kokkos::Sum<Index>(entries), Kokkos::BOr<std::uint32_t>(levels));
  return {entries, levels};
}

}  // namespace

template <int D>
void fill_contact_bins(const ContactSurface<D>& surface, double skin, ContactBins<D>& bins) {
  bins.cell = GridShape<D>::smallest * find_boxes(surface, skin, bins);
  ContactGrid<D> grid{bins.cell, 1};
  const GridUse use = use_of(bins, surface.targets, grid);
  bins.levels = use.levels;
  bins.entries = use.entries;
  while (grid.buckets < use.entries) grid.buckets *= 2;
  bins.buckets = grid.buckets;
  make_room(bins.fill, grid.buckets);
  Kokkos::deep_copy(Exec(), bins.fill, 0);
  const Array<Index> fill = bins.fill;
  const ContactBins<D> boxes = bins;
  // Integer atomics: the counts, and after the sort of each point's list the result, are the same
  // in any order.
  for_each(
      "breccia::contact::count_buckets", surface.targets, KOKKOS_LAMBDA(Index t) {
        grid.cover(ContactBox<D>(boxes, t),
                   [&](std::uint64_t tag) { Kokkos::atomic_inc(&fill(grid.bucket(tag))); });
      });
  list_begins("breccia::contact::buckets", grid.buckets, fill, bins.begin);
  make_room(bins.tag, use.entries);
  make_room(bins.target, use.entries);
  make_room(bins.piece, use.entries);
  const ContactBins<D> b = bins;
  const Array<Index> piece = surface.piece;
  for_each(
      "breccia::contact::fill_buckets", surface.targets, KOKKOS_LAMBDA(Index t) {
        grid.cover(ContactBox<D>(b, t), [&](std::uint64_t tag) {
          const Index bucket = grid.bucket(tag);
          const Index place = b.begin(bucket) + Kokkos::atomic_fetch_sub(&b.fill(bucket), 1) - 1;
          b.tag(place) = tag;
          b.target(place) = t;
          b.piece(place) = piece(t);
        });
      });
}

template void fill_contact_bins<2>(const ContactSurface<2>&, double, ContactBins<2>&);
template void fill_contact_bins<3>(const ContactSurface<3>&, double, ContactBins<3>&);

}  // namespace breccia
