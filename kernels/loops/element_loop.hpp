#pragma once
#include "loops/element_shape.hpp"

namespace breccia {

/// The one loop over elements. A pack computes W groups: shapes, one dilation for the group, the
/// response of each sub-element, one mean stress for the group, forces. What a material is, only
/// `Response` knows (element_response.hpp, element_inelastic.hpp):
///   FullSym<D, R> respond(SubShape&, const Lanes&, int sub, Sums&) const
/// gives the Kirchhoff stress of a sub-element and books its energy,
///   R settle(const Lanes&, GroupVolume&, SubShape (&)[Group], FullSym (&)[Group], Sums&) const
/// the group's mean stress; its result is the P-wave modulus for the time step, Pa.
template <int D, int Group, class Response, class Wish, class Real = Pack>
struct ElementLoop {
  using R = Real;
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
    const Lanes lanes{in.begin, first, (in.end - in.begin) / Group, in.own.data()};
    Vec<D, R> x[kNodes];
    Shapes shape;
    GroupVolume<R> volume{R(0), R(0), R(0), R(0)};
    form_all(lanes, x, shape, volume);
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

  /// Shapes of all sub-elements, positions of the nodes (in single precision relative to the first
  /// one), volumes.
  KOKKOS_FORCEINLINE_FUNCTION
  void form_all(const Lanes& lanes, Vec<D, R> (&x)[kNodes], Shapes& shape,
                GroupVolume<R>& volume) const {
    if constexpr (kSingle<R>) {
      form_wide(lanes, x, shape, volume);
    } else {
      lanes.template gather<D>(in.nodes, in.x, x);
      for (int s = 0; s < Group; ++s) form(lanes, x, s, shape[s]);
    }
    for (int s = 0; s < Group; ++s) {
      shape[s].shift = R(0);
      shape[s].share = wish.shared ? lanes.read(in.share, s) : R(1);
      shape[s].work = R(0);
      shape[s].shock = R(0);
      report(lanes, s, shape[s].jacobian);
      volume.now = volume.now + shape[s].det;
      volume.original = volume.original + shape[s].det / shape[s].jacobian;
    }
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
  }

  /// All that is taken from one is formed in double, a part of the lanes at a time, and then
  /// rounded: eq:solid-19  C - 1 along the material axes, J - 1, and Jbar - 1 of the group.
  KOKKOS_FORCEINLINE_FUNCTION
  void form_wide(const Lanes& lanes, Vec<D, R> (&x)[kNodes], Shapes& shape,
                 GroupVolume<R>& volume) const {
    using Wide = typename Lanes::Wide;
    constexpr int kParts = Lanes::kParts;
    typename Lanes::template WideNodes<D> wide;
    lanes.gather_wide(in.nodes, in.x, wide);
    if (wish.damped || wish.shocked)
      for (int a = 0; a < kNodes; ++a)
        for (int d = 0; d < D; ++d) x[a][d] = Lanes::narrow(wide.at[a][d]);
    Wide growth[kParts], original[kParts];
    for (int s = 0; s < Group; ++s) {
      Wide f[D][D][kParts], c[D][D][kParts], e[Sym<D>::size][kParts], det[kParts], j[kParts];
      for (int p = 0; p < kParts; ++p) {
        const Mat<D, Wide> g = Lanes::template wide_edges<D>(wide, s, p);
        Mat<D, Wide> reference;
        for (int i = 0; i < D; ++i)
          for (int k = 0; k < D; ++k) reference(i, k) = lanes.read_wide(in.reference, p, s, i, k);
        const Mat<D, Wide> now = g * reference, cofactors = cofactor(g);
        const Sym<D, Wide> metric = right_cauchy_green(now);
        for (int i = 0; i < D; ++i)
          for (int k = 0; k < D; ++k) {
            f[i][k][p] = now(i, k);
            c[i][k][p] = cofactors(i, k);
          }
        for (int i = 0; i < Sym<D>::size; ++i)
          e[i][p] = i < D ? metric.s[i] - Wide(1) : metric.s[i];
        const Wide inverse = determinant(reference);
        det[p] = g(0, 0) * cofactors(0, 0);
        for (int k = 1; k < D; ++k) det[p] = det[p] + g(0, k) * cofactors(0, k);
        j[p] = det[p] * inverse - Wide(1);
        if constexpr (Group > 1) {
          const Wide before = Wide(1) / inverse;
          growth[p] = s == 0 ? j[p] * before : growth[p] + j[p] * before;
          original[p] = s == 0 ? before : original[p] + before;
        }
      }
      for (int i = 0; i < D; ++i)
        for (int k = 0; k < D; ++k) {
          shape[s].f(i, k) = Lanes::narrow(f[i][k]);
          shape[s].cofactors(i, k) = Lanes::narrow(c[i][k]);
        }
      for (int i = 0; i < Sym<D>::size; ++i) shape[s].growth.s[i] = Lanes::narrow(e[i]);
      shape[s].det = Lanes::narrow(det);
      shape[s].dilation = Lanes::narrow(j);
      shape[s].jacobian = R(1) + shape[s].dilation;
    }
    if constexpr (Group > 1) {
      for (int p = 0; p < kParts; ++p) growth[p] = growth[p] / original[p];
      volume.growth = Lanes::narrow(growth);
    }
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
    if constexpr (kSingle<R>) {
      const R whole = log_of_one_plus(volume.growth);
      for (int s = 0; s < Group; ++s) shape[s].shift = whole;
    } else {
      const R whole = log_near_one(volume.now / volume.original);
      for (int s = 0; s < Group; ++s)
        shape[s].shift = (whole - log_near_one(shape[s].jacobian)) * R(1.0 / 3);
    }
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
      const R linear = minimum(closing * R(1e30), R(in.shock_linear));
      excess = maximum(excess, linear + quick * R(1 / in.wave_speed));
    }
    const R slow = excess + square_root(R(1) + excess * excess);
    stiffening = slow * slow;
    volume.shock_work = heat / volume.original * R(in.dt);
    double power[W];
    store(heat, power);
    for (int l = 0; l < lanes.count(); ++l)
      if (lanes.counts(l))
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
        if (lanes.counts(l))
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
    R corner[D][D];  // component, corner
    for (int a = 0; a < D; ++a) {
      Vec<D, R> normal;
      for (int i = 0; i < D; ++i) normal[i] = shape.cofactors(i, a) * scale;
      const Vec<D, R> fa = tau * normal;
      for (int i = 0; i < D; ++i) corner[i][a] = fa[i];
    }
    Lane<R> f[D + 1][D][W];
    for (int i = 0; i < D; ++i) {
      if constexpr (kSingle<R>) round_together(corner[i]);
      R rest = R(0);
      for (int a = 0; a < D; ++a) {
        rest = rest - corner[i][a];
        store(corner[i][a], f[a + 1][i]);
      }
      store(rest, f[0][i]);
    }
    if constexpr (!kSingle<R>)
      if (out.force_single.extent(0) > 0) return put_narrowed(lanes, s, f);
    const auto& force = [this]() -> const auto& {
      if constexpr (kSingle<R>)
        return out.force_single;
      else
        return out.force;
    }
    ();
    for (int l = 0; l < lanes.count(); ++l)
      for (int a = 0; a <= D; ++a)
        for (int i = 0; i < D; ++i) force(lanes.element(l, s), a, i) = f[a][i][l];
  }

  /// Forces of double precision for a run whose field of forces is single.
  KOKKOS_FUNCTION
  void put_narrowed(const Lanes& lanes, int s, const Lane<R> (&f)[D + 1][D][W]) const {
    for (int l = 0; l < lanes.count(); ++l)
      for (int i = 0; i < D; ++i) {
        float corner[D], rest = 0;
        for (int a = 0; a < D; ++a) corner[a] = static_cast<float>(f[a + 1][i][l]);
        round_together(corner);
        for (int a = 0; a < D; ++a) {
          rest -= corner[a];
          out.force_single(lanes.element(l, s), a + 1, i) = corner[a];
        }
        out.force_single(lanes.element(l, s), 0, i) = rest;
      }
  }
};

}  // namespace breccia
