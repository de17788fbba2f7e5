#pragma once
#include "loops/element_force.hpp"
#include "loops/element_group.hpp"

namespace breccia {

/// What the loop is asked to do besides forces, known when the code is compiled (the simplest
/// elements) or when it runs.
template <bool kDamped, bool kWatched, bool kStored>
struct FixedWishes {
  static constexpr bool damped = kDamped, watched = kWatched, stored = kStored, shocked = false,
                        shared = false, paced = false;
};
struct Wishes {
  bool damped, watched, stored;
  bool shocked;  ///< bulk viscosity
  bool shared;   ///< elements carry a share of their stress
  bool paced;    ///< the time step wants to know moduli
};

template <int D>
Wishes wishes_of(const ElementForceIn<D>& in, const ElementForceOut<D>& out) {
  return {in.damping > 0,           in.watch.on,
          out.stress.extent(0) > 0, in.shock_quadratic > 0 || in.shock_linear > 0,
          in.share.extent(0) > 0,   out.modulus.extent(0) > 0};
}

/// Shape of one sub-element now.
template <int D, class R>
struct SubShape {
  Mat<D, R> f;          ///< deformation gradient, columns along the material axes
  Mat<D, R> cofactors;  ///< of the edge matrix
  R det;                ///< of the edge matrix: D! times the volume
  R jacobian;
  R shift;  ///< what the shared dilation adds to each normal strain
  R share;  ///< of its stress that the element carries
  R work;   ///< of plastic flow in this step per reference volume, J/m3
  R shock;  ///< bulk viscosity, Pa
};

/// Volume of a group, times D! and over the thickness, and what bulk viscosity does to it.
template <class R>
struct GroupVolume {
  R now, original;
  R shock_work;  ///< heat of bulk viscosity in this step per reference volume, J/m3
};

/// eq:solid-16  tau = dev tau + (J / Jbar) mbar 1, mbar = sum V0 m / V0 with m the mean stress:
/// with eq:solid-15 the exact derivative of the group's energy sum V0 w(eps).
template <int D, int Group, class R>
KOKKOS_FORCEINLINE_FUNCTION
void share_mean(const GroupVolume<R>& volume, const SubShape<D, R> (&shape)[Group],
                FullSym<D, R> (&tau)[Group]) {
  R mean[Group], sum = R(0);
  for (int s = 0; s < Group; ++s) {
    mean[s] = trace(tau[s]) * R(1.0 / 3);
    sum = sum + mean[s] * shape[s].det / shape[s].jacobian;
  }
  const R shared = sum / volume.now;
  for (int s = 0; s < Group; ++s) tau[s].add_identity(shape[s].jacobian * shared - mean[s]);
}

/// Adds what each lane stores, J.
template <class Lanes, class R>
KOKKOS_FORCEINLINE_FUNCTION
void book_stored(const Lanes& lanes, const R& energy, Sums<element_sum::count>& sums) {
  double e[Lanes::W];
  store(energy, e);
  for (int l = 0; l < lanes.count(); ++l) sums[element_sum::stored] += e[l];
}

/// The one loop over elements. A pack computes W groups: shapes, one dilation for the group, the
/// response of each sub-element, one mean stress for the group, forces. What a material is, only
/// `Response` knows (element_response.hpp, element_inelastic.hpp):
///   FullSym<D, R> respond(SubShape&, const Lanes&, int sub, Sums&) const
/// gives the Kirchhoff stress of a sub-element and books its energy,
///   R settle(const Lanes&, GroupVolume&, SubShape (&)[Group], FullSym (&)[Group], Sums&) const
/// the group's mean stress; its result is the P-wave modulus for the time step, Pa.
template <int D, int Group, class Response, class Wish>
struct ElementLoop {
  using R = Pack;
  static constexpr int W = lanes<R>();
  static constexpr int kNodes = kGroupNodes<D, Group>;
  using Lanes = GroupLanes<Group, R>;
  using Totals = Sums<element_sum::count>;
  using Shapes = SubShape<D, R>[Group];
  using Stresses = FullSym<D, R>[Group];

  ElementForceIn<D> in;
  ElementForceOut<D> out;
  Response response;
  Wish wish;

  /// Groups first ... first + W - 1 of the block.
  KOKKOS_FUNCTION
  void operator()(Index first, Totals& sums) const {
    const Lanes lanes{in.begin, first, (in.end - in.begin) / Group};
    Vec<D, R> x[kNodes];
    lanes.template gather<D>(in.nodes, in.x, x);
    Shapes shape;
    GroupVolume<R> volume{R(0), R(0), R(0)};
    for (int s = 0; s < Group; ++s) {
      form(lanes, x, s, shape[s]);
      volume.now = volume.now + shape[s].det;
      volume.original = volume.original + shape[s].det / shape[s].jacobian;
    }
    if constexpr (Group > 1) share_dilation(volume, shape);
    R stiffening = R(1);
    if (wish.shocked) press(lanes, x, volume, shape, stiffening, sums);

    Stresses tau;
    for (int s = 0; s < Group; ++s) tau[s] = response.respond(shape[s], lanes, s, sums);
    const R modulus = response.settle(lanes, volume, shape, tau, sums);
    for (int s = 0; s < Group; ++s) {
      if (wish.shared) tau[s] *= shape[s].share;
      if (wish.watched) watch(lanes, s, tau[s], shape[s].jacobian);
      if (wish.stored) keep(lanes, s, tau[s], shape[s].jacobian);
      if (wish.shocked) tau[s].add_identity(-shape[s].shock * shape[s].share * shape[s].jacobian);
      if (wish.paced) lanes.write(modulus * stiffening, out.modulus, s);
    }
    if (wish.damped) damp(lanes, x, volume, shape, tau, sums);
    for (int s = 0; s < Group; ++s) put(lanes, s, tau[s].in, shape[s]);
  }

 private:
  KOKKOS_FORCEINLINE_FUNCTION
  static R dot_columns(const Mat<D, R>& a, const Mat<D, R>& b) {
    R s = a(0, 0) * b(0, 0);
    for (int j = 1; j < D; ++j) s = s + a(0, j) * b(0, j);
    return s;
  }

  KOKKOS_FORCEINLINE_FUNCTION
  void form(const Lanes& lanes, const Vec<D, R> (&x)[kNodes], int s, SubShape<D, R>& shape) const {
    const Mat<D, R> g = sub_edges<D, Group, R>(x, s);
    Mat<D, R> reference;
    for (int i = 0; i < D; ++i)
      for (int j = 0; j < D; ++j) reference(i, j) = lanes.read(in.reference, s, i, j);
    shape.cofactors = cofactor(g);
    shape.det = dot_columns(g, shape.cofactors);
    shape.f = g * reference;
    shape.jacobian = shape.det * determinant(reference);
    shape.shift = R(0);
    shape.share = wish.shared ? lanes.read(in.share, s) : R(1);
    shape.work = R(0);
    shape.shock = R(0);
    report(lanes, s, shape.jacobian);
  }

  KOKKOS_FORCEINLINE_FUNCTION
  void report(const Lanes& lanes, int s, const R& jacobian) const {
    if (!any(!(R(in.smallest_jacobian) < jacobian))) return;
    double j[W];
    store(jacobian, j);
    for (int l = 0; l < lanes.count(); ++l)
      if (!(j[l] > in.smallest_jacobian)) Kokkos::atomic_min(&out.bad(0), lanes.element(l, s));
  }

  /// eq:solid-15  the strain of each sub-element takes the dilation of the whole:
  /// eps + (ln Jbar - ln J)/3 1, Jbar = V / V0 of the group. Not in plane stress, where thickness
  /// is free to change and nothing locks.
  KOKKOS_FORCEINLINE_FUNCTION
  void share_dilation(const GroupVolume<R>& volume, Shapes& shape) const {
    if (in.flat) return;
    const R whole = log_near_one(volume.now / volume.original);
    for (int s = 0; s < Group; ++s)
      shape[s].shift = (whole - log_near_one(shape[s].jacobian)) * R(1.0 / 3);
  }

  /// Bulk viscosity: q = rho l (a l tr(d)^2 + b c |tr(d)|) where a sub-element is
  /// compressed, l its size. Each has its own: the pressure that a composite shares does not keep
  /// its parts from inverting in a shock. It makes the group stiffer for the time step by
  /// (x + sqrt(1 + x^2))^2, x = b + a l |tr(d)| / c.
  KOKKOS_FUNCTION
  void press(const Lanes& lanes, const Vec<D, R> (&x)[kNodes], GroupVolume<R>& volume,
             Shapes& shape, R& stiffening, Totals& sums) const {
    Vec<D, R> v[kNodes];
    lanes.template gather<D>(in.nodes, in.v, v);
    R heat = R(0), excess = R(0);
    for (int s = 0; s < Group; ++s) {
      R heights, det;
      const Sym<D, R> d = rate_of_deformation(sub_edges<D, Group, R>(x, s),
                                              sub_edges<D, Group, R>(v, s), heights, det);
      const R closing = maximum(R(0), -trace(d));
      const R size = map_lanes(shape[s].det * R(1 / kFactorial<D>), [](double part) {
        return D == 2 ? Kokkos::sqrt(part) : Kokkos::cbrt(part);
      });
      const R quick = R(in.shock_quadratic) * size * closing;
      shape[s].shock = R(in.density) / shape[s].jacobian * size * closing *
                       (quick + R(in.shock_linear * in.wave_speed));
      heat = heat + shape[s].shock * closing * shape[s].det;
      const R linear = minimum(closing * R(1e300), R(in.shock_linear));
      excess = maximum(excess, linear + quick * R(1 / in.wave_speed));
    }
    const R slow = excess + square_root(R(1) + excess * excess);
    stiffening = slow * slow;
    volume.shock_work = heat / volume.original * R(in.dt);
    double power[W];
    store(heat, power);
    for (int l = 0; l < lanes.count(); ++l)
      sums[element_sum::shock] += power[l] * (in.thickness / kFactorial<D> * in.kick);
  }

  KOKKOS_FORCEINLINE_FUNCTION
  void watch(const Lanes& lanes, int s, const FullSym<D, R>& tau, const R& jacobian) const {
    if (!in.watch.is_far(tau.in, jacobian)) look_closer(lanes, s, tau.in, jacobian);
  }

  /// Apart and with copies, so that registers of the loop are not kept for it. The lanes of a pack
  /// lie in few words; each is asked for once.
  [[gnu::noinline]] KOKKOS_FUNCTION
  void look_closer(Lanes lanes, int s, Sym<D, R> tau, R jacobian) const {
    const R room = in.watch.room(tau, jacobian);
    if (!any(room <= R(0))) return;
    double r[W];
    store(room, r);
    Index word = -1;
    BitWord bits = 0;
    for (int l = 0; l < lanes.count(); ++l) {
      if (!(r[l] <= 0)) continue;
      const Index e = lanes.element(l, s);
      if (bits != 0 && e / kWordBits != word) {
        Kokkos::atomic_or(&out.hot(word), bits);
        bits = 0;
      }
      word = e / kWordBits;
      bits |= BitWord{1} << (e % kWordBits);
    }
    if (bits != 0) Kokkos::atomic_or(&out.hot(word), bits);
  }

  KOKKOS_FORCEINLINE_FUNCTION
  void keep(const Lanes& lanes, int s, const FullSym<D, R>& tau, const R& jacobian) const {
    const R over = R(1) / jacobian;
    for (int i = 0; i < FullSym<D>::size; ++i) lanes.write(tau[i] * over, out.stress, s, i);
  }

  /// tau_v = beta (lambda tr(d) 1 + 2 mu d) with d the rate of deformation and beta such that
  /// the element's highest mode is damped by the given fraction of critical. The velocities are
  /// those of half a step ago and so is the shape that d is taken at: then a rotation, whose
  /// chords the velocities are, has no d at all (a midpoint rule is a Cayley transform).
  KOKKOS_FUNCTION
  void damp(const Lanes& lanes, const Vec<D, R> (&x)[kNodes], const GroupVolume<R>& volume,
            const Shapes& shape, Stresses& tau, Totals& sums) const {
    Vec<D, R> v[kNodes];
    lanes.template gather<D>(in.nodes, in.v, v);
    FullSym<D, R> d[Group];
    R beta[Group], whole = R(0), growth = R(0);
    for (int s = 0; s < Group; ++s) {
      R heights, det;
      d[s].in = rate_of_deformation(sub_edges<D, Group, R>(x, s), sub_edges<D, Group, R>(v, s),
                                    heights, det);
      d[s].zz = R(0);
      beta[s] = shape[s].share * R(2 * in.damping) /
                (R(in.wave_speed) * square_root(R(D + 1.0) * heights));
      whole = whole + det;
      growth = growth + det * trace(d[s].in);
    }
    const R mean = growth / whole;
    FullSym<D, R> viscous[Group];
    for (int s = 0; s < Group; ++s) {
      if (Group > 1 && !in.flat) d[s].add_identity((mean - trace(d[s])) * R(1.0 / 3));
      viscous[s] = isotropic(in.law, d[s], in.flat) * beta[s];
      double power[W], reference_volume[W];
      store(contract(viscous[s], d[s]), power);
      store(shape[s].det / shape[s].jacobian, reference_volume);
      for (int l = 0; l < lanes.count(); ++l)
        sums[element_sum::viscous] +=
            power[l] * reference_volume[l] * (in.thickness / kFactorial<D> * in.kick);
    }
    if (Group > 1 && !in.flat) share_mean<D, Group>(volume, shape, viscous);
    for (int s = 0; s < Group; ++s) tau[s] += viscous[s];
  }

  /// Half a step ago; `heights` is the sum over corners of 1 / height^2.
  KOKKOS_FORCEINLINE_FUNCTION
  Sym<D, R> rate_of_deformation(const Mat<D, R>& g, const Mat<D, R>& rate, R& heights,
                                R& det) const {
    Mat<D, R> middle;
    for (int i = 0; i < D; ++i)
      for (int j = 0; j < D; ++j) middle(i, j) = g(i, j) - R(in.lag) * rate(i, j);
    const Mat<D, R> cofactors = cofactor(middle);
    det = dot_columns(middle, cofactors);
    const R over = R(1) / det;
    heights = R(0);
    for (int i = 0; i < D; ++i) {
      R sum = R(0);
      for (int j = 0; j < D; ++j) {
        const R c = cofactors(i, j) * over;
        heights = heights + c * c;
        sum = sum + c;
      }
      heights = heights + sum * sum;
    }
    const Mat<D, R> h = rate * transpose(cofactors);  // velocity gradient times the determinant
    return symmetric_part(h) * over;
  }

  /// V0 g_a = (thickness / D!) / J times the cofactors of the edge matrix.
  KOKKOS_FORCEINLINE_FUNCTION
  void put(const Lanes& lanes, int s, const Sym<D, R>& tau, const SubShape<D, R>& shape) const {
    const R scale = R(-in.thickness / kFactorial<D>) / shape.jacobian;
    double f[D + 1][D][W];
    Vec<D, R> rest = Vec<D, R>::zero();
    for (int a = 0; a < D; ++a) {
      Vec<D, R> normal;
      for (int i = 0; i < D; ++i) normal[i] = shape.cofactors(i, a) * scale;
      const Vec<D, R> fa = tau * normal;
      rest -= fa;
      for (int i = 0; i < D; ++i) store(fa[i], f[a + 1][i]);
    }
    for (int i = 0; i < D; ++i) store(rest[i], f[0][i]);
    for (int l = 0; l < lanes.count(); ++l)
      for (int a = 0; a <= D; ++a)
        for (int i = 0; i < D; ++i) out.force(lanes.element(l, s), a, i) = f[a][i][l];
  }
};

/// Groups per chunk: about kChunk elements, whole packs.
template <int Group>
inline constexpr Index kGroupChunk = (kChunk / Group + 7) / 8 * 8;

KOKKOS_INLINE_FUNCTION
void add(const ElementSums& total, Index chunk, const Sums<element_sum::count>& sums) {
  for (int k = 0; k < element_sum::stored; ++k) total(chunk, k) += sums[k];
  total(chunk, element_sum::stored) = sums[element_sum::stored];
}

/// Runs the loop over chunks of packs, counted from the block's first group. What is stored is of
/// this step, the other sums grow.
template <int D, int Group, class Response, class Wish>
void launch(const ElementLoop<D, Group, Response, Wish>& loop) {
  using Loop = ElementLoop<D, Group, Response, Wish>;
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
template <int D, class Response>
void launch_groups(const ElementForceIn<D>& in, const ElementForceOut<D>& out,
                   const Response& response) {
  const Wishes wish = wishes_of(in, out);
  if (in.end <= in.begin) return;
  if (in.group == 1) return launch(ElementLoop<D, 1, Response, Wishes>{in, out, response, wish});
  if constexpr (D == 2) return launch(ElementLoop<2, 4, Response, Wishes>{in, out, response, wish});
  if constexpr (D == 3) {
    if (in.group == 8)
      launch(ElementLoop<3, 8, Response, Wishes>{in, out, response, wish});
    else
      launch(ElementLoop<3, 12, Response, Wishes>{in, out, response, wish});
  }
}

}  // namespace breccia
