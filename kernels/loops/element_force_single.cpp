#include "loops/element_response.hpp"

namespace breccia {

namespace {

/// The commonest wishes are known when the code is compiled.
template <bool kDamped, bool kWatched, int D>
void run_single(const ElementForceIn<D>& in, const ElementForceOut<D>& out) {
  using Wish = FixedWishes<kDamped, kWatched, false>;
  launch(ElementLoop<D, 1, HenckyResponse<D>, Wish, PackSingle>{in, out, {in.law, in.flat}, {}});
}

}  // namespace

template <int D>
void element_force_single(const ElementForceIn<D>& in, const ElementForceOut<D>& out) {
  if (in.end <= in.begin) return;
  const Wishes wish = wishes_of(in, out);
  if (in.group > 1 || wish.shocked || wish.shared || wish.stored)
    launch_groups<D, PackSingle>(in, out, HenckyResponse<D>{in.law, in.flat});
  else if (wish.damped && wish.watched)
    run_single<true, true>(in, out);
  else if (wish.damped)
    run_single<true, false>(in, out);
  else if (wish.watched)
    run_single<false, true>(in, out);
  else
    run_single<false, false>(in, out);
}

template <int D>
void anisotropic_force_single(const ElementForceIn<D>& in, const ElementForceOut<D>& out,
                              const AnisotropicState<D>& state) {
  launch_groups<D, PackSingle>(
      in, out, AnisotropicResponse<D>{state, in.flat, in.thickness / kFactorial<D>});
}

template void element_force_single<2>(const ElementForceIn<2>&, const ElementForceOut<2>&);
template void element_force_single<3>(const ElementForceIn<3>&, const ElementForceOut<3>&);
template void anisotropic_force_single(const ElementForceIn<2>&, const ElementForceOut<2>&,
                                       const AnisotropicState<2>&);
template void anisotropic_force_single(const ElementForceIn<3>&, const ElementForceOut<3>&,
                                       const AnisotropicState<3>&);

}  // namespace breccia
