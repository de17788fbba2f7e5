#include "loops/contact_bins.hpp"

namespace breccia {

namespace {

/// Smallest box and the grids that hold targets.
template <int D>
double smallest_box(const ContactSurface<D>& surface, double skin) {
  double least = 0;
  count_launch();
  Kokkos::parallel_reduce(
      "breccia::contact::box_size",
      Kokkos::RangePolicy<Exec, Kokkos::IndexType<Index>>(0, surface.targets),
      KOKKOS_LAMBDA(Index t, double& part) {
        const double size = ContactBox<D>(surface.place, t, skin).size();
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
GridUse use_of(const ContactSurface<D>& surface, double skin, const ContactGrid<D>& grid) {
  Index entries = 0;
  std::uint32_t levels = 0;
  count_launch();
  Kokkos::parallel_reduce(
      "breccia::contact::count_cells",
      Kokkos::RangePolicy<Exec, Kokkos::IndexType<Index>>(0, surface.targets),
      KOKKOS_LAMBDA(Index t, Index & n, std::uint32_t & l) {
        const ContactBox<D> box(surface.place, t, skin);
        l |= 1u << grid.level_of(box.size());
        grid.cover(box, [&](std::uint64_t) { ++n; });
      },
      Kokkos::Sum<Index>(entries), Kokkos::BOr<std::uint32_t>(levels));
  return {entries, levels};
}

}  // namespace

template <int D>
void fill_contact_bins(const ContactSurface<D>& surface, double skin, ContactBins<D>& bins) {
  bins.cell = GridShape<D>::smallest * smallest_box(surface, skin);
  ContactGrid<D> grid{bins.cell, 1};
  const GridUse use = use_of(surface, skin, grid);
  bins.levels = use.levels;
  bins.entries = use.entries;
  while (grid.buckets < use.entries) grid.buckets *= 2;
  bins.buckets = grid.buckets;
  make_room(bins.fill, grid.buckets);
  Kokkos::deep_copy(Exec(), bins.fill, 0);
  const Array<Index> fill = bins.fill;
  // Integer atomics: the counts, and after the sort of each point's list the result, are the same
  // in any order.
  for_each(
      "breccia::contact::count_buckets", surface.targets, KOKKOS_LAMBDA(Index t) {
        grid.cover(ContactBox<D>(surface.place, t, skin),
                   [&](std::uint64_t tag) { Kokkos::atomic_inc(&fill(grid.bucket(tag))); });
      });
  list_begins("breccia::contact::buckets", grid.buckets, fill, bins.begin);
  make_room(bins.tag, use.entries);
  make_room(bins.target, use.entries);
  const ContactBins<D> b = bins;
  for_each(
      "breccia::contact::fill_buckets", surface.targets, KOKKOS_LAMBDA(Index t) {
        grid.cover(ContactBox<D>(surface.place, t, skin), [&](std::uint64_t tag) {
          const Index bucket = grid.bucket(tag);
          const Index place = b.begin(bucket) + Kokkos::atomic_fetch_sub(&b.fill(bucket), 1) - 1;
          b.tag(place) = tag;
          b.target(place) = t;
        });
      });
}

template void fill_contact_bins<2>(const ContactSurface<2>&, double, ContactBins<2>&);
template void fill_contact_bins<3>(const ContactSurface<3>&, double, ContactBins<3>&);

}  // namespace breccia
