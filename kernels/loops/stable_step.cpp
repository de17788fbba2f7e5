#include "loops/stable_step.hpp"

#include "loops/element.hpp"
#include "point/hencky.hpp"

#include <limits>

namespace breccia {

namespace {

/// The smallest principal value from below; exact in the plane.
KOKKOS_INLINE_FUNCTION
double least_principal(const Sym<2>& a) {
  const double half = 0.5 * (a.s[0] - a.s[1]);
  return 0.5 * trace(a) - Kokkos::sqrt(half * half + a.s[2] * a.s[2]);
}
KOKKOS_INLINE_FUNCTION
double least_principal(const Sym<3>& a) {
  const double mean = trace(a) / 3;
  Sym<3> deviator = a;
  for (int i = 0; i < 3; ++i) deviator.s[i] -= mean;
  return mean - 2 * Kokkos::sqrt(contract(deviator, deviator) / 6);
}

template <int D>
KOKKOS_INLINE_FUNCTION
double share_of(const StableStepIn<D>& in, Index e) {
  return in.share.extent(0) > 0 ? in.share(e) : 1.0;
}

/// Frobenius norm of the rate of deformation, 1/s; `c` and `det` are of the present edges.
template <int D>
KOKKOS_FUNCTION
double strain_rate(const StableStepIn<D>& in, Index e, const Mat<D>& c, double det) {
  Vec<D> v[D + 1];
  gather(in.element_nodes, in.v, e, e, v);
  const Sym<D> d = symmetric_part(edges<D, double>(v) * transpose(c));
  return Kokkos::sqrt(contract(d, d)) / Kokkos::abs(det);
}

/// Kirchhoff stress as the element loop left it or, where it leaves none, of Hencky's law.
template <int D>
KOKKOS_FUNCTION
Sym<D> kirchhoff_stress(const StableStepIn<D>& in, Index e, const Mat<D>& f, double jacobian) {
  if (in.stress.extent(0) > 0) {
    Sym<D> tau;
    for (int i = 0; i < Sym<D>::size; ++i) tau.s[i] = in.stress(e, i) * jacobian;
    return tau;
  }
  const Index material = in.material(e);
  const HenckyElastic law{in.lame(material, 0), in.lame(material, 1)};
  return law.kirchhoff(hencky_strain(left_cauchy_green(f), jacobian));
}

/// omega_e^2 times the mass at one of its corners, N/m; its rate of deformation in `deforming`.
template <int D>
KOKKOS_FUNCTION
double element_rate(const StableStepIn<D>& in, Index e, double& deforming) {
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
  deforming = strain_rate(in, e, c, det);
  Mat<D> reference;
  for (int i = 0; i < D; ++i)
    for (int j = 0; j < D; ++j) reference(i, j) = in.reference(e, i, j);
  const Index material = in.material(e);
  const double small = determinant(reference);
  const Sym<D> tau = kirchhoff_stress(in, e, g * reference, det * small);
  const double pressed = -least_principal(tau);
  const double now = in.modulus.extent(0) > 0 ? in.modulus(e) : 0.0;
  const double constant = in.lame(material, 0) + 2 * in.lame(material, 1);
  const double modulus = (now > 0 ? now : constant) + (pressed > 0 ? pressed : 0.0);
  const double xi = in.damping(material);
  const double slow = Kokkos::sqrt(1 + xi * xi) - xi;
  // The mass of a corner is density times the reference volume over its number.
  const double volume = in.thickness / (kFactorial<D> * small);
  return modulus * heights / (slow * slow) * volume;
}

}  // namespace

template <int D>
StableStep stable_step(const StableStepIn<D>& in) {
  double fastest = 0;
  if (in.renew_rates) {
    count_launch();
    Kokkos::parallel_reduce(
        "breccia::motion::element_rate",
        Kokkos::RangePolicy<Exec, Kokkos::IndexType<Index>>(0, in.elements),
        KOKKOS_LAMBDA(Index e, double& most) {
          double deforming = 0;
          in.rate(e) = share_of(in, e) > 0 ? element_rate(in, e, deforming) : 0.0;
          if (deforming > most) most = deforming;
        },
        Kokkos::Max<double>(fastest));
  }
  const bool springs = in.stiffness.extent(0) > 0;
  using Reducer = Kokkos::MinLoc<double, Index, Memory>;
  typename Kokkos::MinLoc<double, Index>::value_type least;
  count_launch();
  Kokkos::parallel_reduce(
      "breccia::motion::stable_step",
      Kokkos::RangePolicy<Exec, Kokkos::IndexType<Index>>(0, in.nodes),
      KOKKOS_LAMBDA(Index n, typename Reducer::value_type & part) {
        if (!(in.mass(n) > 0)) return;
        double rate = 0;
        for (Index k = in.corners(n, 0); k < in.corners(n, 1); ++k) {
          const Index e = in.corner_list(k) / (D + 1);
          rate += in.rate(e) * share_of(in, e);
        }
        const double s = springs ? in.stiffness(n) : 0.0;
        const double factor = s > 0 ? in.factor_springs : in.factor_bulk;
        const double dt = factor * 2 / Kokkos::sqrt((rate + s) / in.mass(n));
        if (dt < part.val || (dt == part.val && n < part.loc) || !(dt == dt)) {
          part.val = dt;
          part.loc = n;
        }
      },
      Kokkos::MinLoc<double, Index>(least));
  // Where nothing is elastic, nothing limits the step.
  if (least.loc >= in.nodes) return {std::numeric_limits<double>::infinity(), 0, false, fastest};
  double s = 0;
  if (springs) {
    const auto one = Kokkos::subview(in.stiffness, std::make_pair(least.loc, least.loc + 1));
    s = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{}, one)(0);
  }
  return {least.val, least.loc, s > 0, fastest};
}

template StableStep stable_step<2>(const StableStepIn<2>&);
template StableStep stable_step<3>(const StableStepIn<3>&);

}  // namespace breccia
