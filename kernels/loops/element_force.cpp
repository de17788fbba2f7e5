#include "loops/element_force.hpp"

#include "loops/element_response.hpp"

namespace breccia {

namespace {

template <bool kDamped, bool kWatched, bool kStored, int D>
void run_single(const ElementForceIn<D>& in, const ElementForceOut<D>& out) {
  using Wish = FixedWishes<kDamped, kWatched, kStored>;
  launch(ElementLoop<D, 1, HenckyResponse<D>, Wish>{in, out, {in.law, in.flat}, {}});
}

template <bool kDamped, bool kWatched, int D>
void run_single(const ElementForceIn<D>& in, const ElementForceOut<D>& out) {
  if (out.stress.extent(0) > 0)
    run_single<kDamped, kWatched, true>(in, out);
  else
    run_single<kDamped, kWatched, false>(in, out);
}

}  // namespace

template <int D>
void element_force(const ElementForceIn<D>& in, const ElementForceOut<D>& out) {
  if (in.end <= in.begin) return;
  const Wishes wish = wishes_of(in, out);
  if (in.group > 1 || wish.shocked || wish.shared)
    launch_groups(in, out, HenckyResponse<D>{in.law, in.flat});
  else if (wish.damped && wish.watched)
    run_single<true, true>(in, out);
  else if (wish.damped)
    run_single<true, false>(in, out);
  else if (wish.watched)
    run_single<false, true>(in, out);
  else
    run_single<false, false>(in, out);
}

template void element_force<2>(const ElementForceIn<2>&, const ElementForceOut<2>&);
template void element_force<3>(const ElementForceIn<3>&, const ElementForceOut<3>&);

}  // namespace breccia
