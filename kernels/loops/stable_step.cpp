#include "loops/stable_step.hpp"

#include "loops/element.hpp"

namespace breccia {

namespace {

/// omega_e^2 times the mass at one of its corners, N/m.
template <int D>
KOKKOS_FUNCTION
double element_rate(const StableStepIn<D>& in, Index e) {
  Vec<D> x[D + 1];
  gather(in.element_nodes, in.x, e, e, x);
  const Mat<D> g = edges<D, double>(x);
  const Mat<D> c = cofactor(g);
  double det = 0;
  for (int j = 0; j < D; ++j) det += g(0, j) * c(0, j);
  double heights = 0;
  for (int i = 0; i < D; ++i) {
    double sum = 0;
    for (int j = 0; j < D; ++j) {
      heights += c(i, j) * c(i, j);
      sum += c(i, j);
    }
    heights += sum * sum;
  }
  heights /= det * det;
  Mat<D> reference;
  for (int i = 0; i < D; ++i)
    for (int j = 0; j < D; ++j) reference(i, j) = in.reference(e, i, j);
  const Index material = in.material(e);
  const double speed = in.wave_speed(material), xi = in.damping(material);
  const double slow = Kokkos::sqrt(1 + xi * xi) - xi;
  const double corner_mass =
      in.density(material) * in.thickness / (kFactorial<D> * (D + 1) * determinant(reference));
  return speed * speed * (D + 1) * heights / (slow * slow) * corner_mass;
}

}  // namespace

template <int D>
StableStep stable_step(const StableStepIn<D>& in) {
  if (in.renew_rates)
    for_each(
        "breccia::motion::element_rate", in.elements,
        KOKKOS_LAMBDA(Index e) { in.rate(e) = element_rate(in, e); });
  const bool springs = in.stiffness.extent(0) > 0;
  using Reducer = Kokkos::MinLoc<double, Index, Memory>;
  typename Kokkos::MinLoc<double, Index>::value_type least;
  count_launch();
  Kokkos::parallel_reduce(
      "breccia::motion::stable_step",
      Kokkos::RangePolicy<Exec, Kokkos::IndexType<Index>>(0, in.nodes),
      KOKKOS_LAMBDA(Index n, typename Reducer::value_type & part) {
        double rate = 0;
        for (Index k = in.corners(n, 0); k < in.corners(n, 1); ++k)
          rate += in.rate(in.corner_list(k) / (D + 1));
        const double s = springs ? in.stiffness(n) : 0.0;
        const double factor = s > 0 ? in.factor_springs : in.factor_bulk;
        const double dt = factor * 2 / Kokkos::sqrt((rate + s) / in.mass(n));
        if (dt < part.val || (dt == part.val && n < part.loc) || !(dt == dt)) {
          part.val = dt;
          part.loc = n;
        }
      },
      Kokkos::MinLoc<double, Index>(least));
  double s = 0;
  if (springs) {
    const auto one = Kokkos::subview(in.stiffness, std::make_pair(least.loc, least.loc + 1));
    s = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{}, one)(0);
  }
  return {least.val, least.loc, s > 0};
}

template StableStep stable_step<2>(const StableStepIn<2>&);
template StableStep stable_step<3>(const StableStepIn<3>&);

}  // namespace breccia
