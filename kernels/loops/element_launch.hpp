#pragma once
#include "loops/element_loop.hpp"

namespace breccia {

/// Groups per chunk: about kChunk elements, whole packs.
template <int Group>
inline constexpr Index kGroupChunk = (kChunk / Group + 15) / 16 * 16;

KOKKOS_INLINE_FUNCTION
void add(const ElementSums& total, Index chunk, const Sums<element_sum::count>& sums) {
  for (int k = 0; k < element_sum::stored; ++k) total(chunk, k) += sums[k];
  total(chunk, element_sum::stored) = sums[element_sum::stored];
}

/// Runs the loop over chunks of packs, counted from the block's first group. What is stored is of
/// this step, the other sums grow.
template <int D, int Group, class Response, class Wish, class R>
void launch(const ElementLoop<D, Group, Response, Wish, R>& loop) {
  using Loop = ElementLoop<D, Group, Response, Wish, R>;
  const Index groups = (loop.in.end - loop.in.begin) / Group;
  const ElementSums total = loop.out.sums;
  constexpr Index kSize = kGroupChunk<Group>;
  count_launch();
  if constexpr (kOnDevice) {
    using Policy = Kokkos::TeamPolicy<Exec, Kokkos::IndexType<Index>>;
    Kokkos::parallel_for(
        "breccia::solid::element_force", Policy((groups + kSize - 1) / kSize, 128),
        KOKKOS_LAMBDA(const typename Policy::member_type& team) {
          const Index from = team.league_rank() * kSize;
          const Index to = from + kSize < groups ? from + kSize : groups;
          typename Loop::Totals sums;
          Kokkos::parallel_reduce(
              Kokkos::TeamThreadRange(team, from, to),
              [&](Index i, typename Loop::Totals& part) { loop(i, part); },
              Kokkos::Sum<typename Loop::Totals>(sums));
          Kokkos::single(Kokkos::PerTeam(team), [&]() { add(total, team.league_rank(), sums); });
        });
  } else {
    Kokkos::parallel_for(
        "breccia::solid::element_force",
        Kokkos::RangePolicy<Exec, Kokkos::IndexType<Index>>(0, (groups + kSize - 1) / kSize),
        KOKKOS_LAMBDA(Index chunk) {
          const Index from = chunk * kSize;
          const Index to = from + kSize < groups ? from + kSize : groups;
          typename Loop::Totals sums;
          for (Index first = from; first < to; first += Loop::W) loop(first, sums);
          add(total, chunk, sums);
        });
  }
}

/// Runs the loop with the block's group size.
template <int D, class R = Pack, class Response>
void launch_groups(const ElementForceIn<D>& in, const ElementForceOut<D>& out,
                   const Response& response) {
  const Wishes wish = wishes_of(in, out);
  if (in.end <= in.begin) return;
  if (in.group == 1) return launch(ElementLoop<D, 1, Response, Wishes, R>{in, out, response, wish});
  if constexpr (D == 2)
    return launch(ElementLoop<2, 4, Response, Wishes, R>{in, out, response, wish});
  if constexpr (D == 3) {
    if (in.group == 8)
      launch(ElementLoop<3, 8, Response, Wishes, R>{in, out, response, wish});
    else
      launch(ElementLoop<3, 12, Response, Wishes, R>{in, out, response, wish});
  }
}

}  // namespace breccia
