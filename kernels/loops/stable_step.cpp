#include "loops/stable_step.hpp"

#include "loops/element.hpp"
#include "point/hencky.hpp"

#include <limits>

namespace breccia {

namespace {

/// The smallest principal value from below; exact in the plane.
template <class R>
KOKKOS_INLINE_FUNCTION
R least_principal(const Sym<2, R>& a) {
  const R half = R(0.5) * (a.s[0] - a.s[1]);
  return R(0.5) * trace(a) - square_root(half * half + a.s[2] * a.s[2]);
}
template <class R>
KOKKOS_INLINE_FUNCTION
R least_principal(const Sym<3, R>& a) {
  const R mean = trace(a) / R(3);
  Sym<3, R> deviator = a;
  for (int i = 0; i < 3; ++i) deviator.s[i] = deviator.s[i] - mean;
  return mean - R(2) * square_root(contract(deviator, deviator) / R(6));
}

template <int D>
KOKKOS_INLINE_FUNCTION
double share_of(const StableStepIn<D>& in, Index e) {
  return in.share.extent(0) > 0 ? in.share(e) : 1.0;
}

/// A pack of elements from `first` on; lanes behind the last element repeat it.
template <int D, class R>
struct RateOfElements {
  StableStepIn<D> in;
  Index first, last;
  Mat<D, R> g, c;  ///< edges and their cofactors
  R det;

  KOKKOS_FUNCTION
  RateOfElements(const StableStepIn<D>& i, Index begin)
      : in(i), first(begin), last(i.elements - 1) {
    Vec<D, R> x[D + 1];
    gather(in.element_nodes, in.x, first, last, x);
    g = edges<D, R>(x);
    c = cofactor(g);
    det = R(0);
    for (int j = 0; j < D; ++j) det = det + g(0, j) * c(0, j);
  }

  KOKKOS_FUNCTION
  Index element(int lane) const { return first + lane < last ? first + lane : last; }

  /// A number of the lanes' materials.
  template <class F>
  KOKKOS_FUNCTION
  R of_material(const F& f) const {
    return fill<R>([&](int l) { return f(in.material(element(l))); });
  }

  /// Frobenius norm of the rate of deformation, 1/s.
  KOKKOS_FUNCTION
  R deforming() const {
    Vec<D, R> v[D + 1];
    gather(in.element_nodes, in.v, first, last, v);
    const Sym<D, R> d = symmetric_part(edges<D, R>(v) * transpose(c));
    return square_root(contract(d, d)) / absolute(det);
  }

  /// Kirchhoff stress as the element loop left it or, where it leaves none, of Hencky's law.
  KOKKOS_FUNCTION
  Sym<D, R> kirchhoff_stress(const Mat<D, R>& f, const R& jacobian) const {
    Sym<D, R> tau;
    if (in.stress.extent(0) > 0) {
      for (int i = 0; i < Sym<D>::size; ++i)
        tau.s[i] = fill<R>([&](int l) { return in.stress(element(l), i); }) * jacobian;
      return tau;
    }
    const Sym<D, R> eps = hencky_strain(left_cauchy_green(f), jacobian);
    tau = eps * (R(2) * of_material([&](Index m) { return in.lame(m, 1); }));
    const R p = of_material([&](Index m) { return in.lame(m, 0); }) * trace(eps);
    for (int i = 0; i < D; ++i) tau.s[i] = tau.s[i] + p;
    return tau;
  }

  /// P-wave modulus of the pressed element, Pa.
  KOKKOS_FUNCTION
  R modulus(const Sym<D, R>& tau) const {
    const R now = fill<R>([&](int l) {
      const Index m = in.material(element(l));
      const double given = in.modulus.extent(0) > 0 ? in.modulus(element(l)) : 0.0;
      return given > 0 ? given : in.lame(m, 0) + 2 * in.lame(m, 1);
    });
    return now + maximum(R(0), R(0) - least_principal(tau));
  }

  /// omega_e^2 times the mass at one of its corners, N/m.
  KOKKOS_FUNCTION
  R rate() const {
    R heights = R(0);
    for (int i = 0; i < D; ++i) {
      R sum = R(0);
      for (int j = 0; j < D; ++j) {
        heights = heights + c(i, j) * c(i, j);
        sum = sum + c(i, j);
      }
      heights = heights + sum * sum;
    }
    heights = heights / (det * det);
    const Mat<D, R> reference = stream<D, R>(in.reference, first);
    const R small = determinant(reference);
    const R xi = of_material([&](Index m) { return in.damping(m); });
    const R slow = square_root(R(1) + xi * xi) - xi;
    // The mass of a corner is density times the reference volume over its number.
    const R volume = R(in.thickness) / (R(kFactorial<D>) * small);
    const Sym<D, R> tau = kirchhoff_stress(g * reference, det * small);
    return modulus(tau) * heights / (slow * slow) * volume;
  }
};

/// Renews the rates of the elements; gives the largest rate of deformation.
template <int D>
double renew_rates(const StableStepIn<D>& in) {
  constexpr int kWide = lanes<Pack>();
  double fastest = 0;
  count_launch();
  Kokkos::parallel_reduce(
      "breccia::motion::element_rate",
      Kokkos::RangePolicy<Exec, Kokkos::IndexType<Index>>(0, (in.elements + kWide - 1) / kWide),
      KOKKOS_LAMBDA(Index pack, double& most) {
        const RateOfElements<D, Pack> elements(in, pack * kWide);
        double rate[kWide], deforming[kWide];
        store(elements.rate(), rate);
        store(elements.deforming(), deforming);
        for (int l = 0; l < kWide && pack * kWide + l < in.elements; ++l) {
          const Index e = pack * kWide + l;
          const bool there = share_of(in, e) > 0;
          in.rate(e) = there ? rate[l] : 0.0;
          if (there && deforming[l] > most) most = deforming[l];
        }
      },
      Kokkos::Max<double>(fastest));
  return fastest;
}

}  // namespace

template <int D>
StableStep stable_step(const StableStepIn<D>& in) {
  const double fastest = in.renew_rates ? renew_rates(in) : 0;
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
