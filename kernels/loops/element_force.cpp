#include "loops/element_force.hpp"

#include "loops/element.hpp"

namespace breccia {

namespace {

template <int D, bool kDamped, bool kWatched>
struct ElementForceLoop {
  using R = Pack;
  static constexpr int W = lanes<R>();
  ElementForceIn<D> in;
  ElementForceOut<D> out;

  /// Elements first ... first + W - 1 of the block.
  KOKKOS_FUNCTION
  void operator()(Index first, Sums<1>& viscous) const {
    const Index last = in.end - 1;
    Vec<D, R> x[D + 1];
    gather(in.nodes, in.x, first, last, x);
    const Mat<D, R> g = edges<D, R>(x);
    const Mat<D, R> reference = stream<D, R>(in.reference, first);

    const Mat<D, R> cofactors = cofactor(g);
    const R det = dot_columns(g, cofactors);
    const Mat<D, R> f = g * reference;
    const R jacobian = det * determinant(reference);
    report(first, jacobian);
    Sym<D, R> tau = in.law.kirchhoff(hencky_strain(left_cauchy_green(f), jacobian));
    if constexpr (kWatched) watch(first, tau, jacobian);
    if constexpr (kDamped) {
      const Sym<D, R> viscous_stress = damp(first, last, g, det, jacobian, viscous);
      tau += viscous_stress;
    }
    put(first, tau, cofactors, jacobian);
  }

 private:
  KOKKOS_FORCEINLINE_FUNCTION
  static R dot_columns(const Mat<D, R>& a, const Mat<D, R>& b) {
    R s = a(0, 0) * b(0, 0);
    for (int j = 1; j < D; ++j) s = s + a(0, j) * b(0, j);
    return s;
  }

  KOKKOS_FORCEINLINE_FUNCTION
  void report(Index first, const R& jacobian) const {
    if (!any(!(R(in.smallest_jacobian) < jacobian))) return;
    double j[W];
    store(jacobian, j);
    for (int l = 0; l < W; ++l)
      if (first + l < in.end && !(j[l] > in.smallest_jacobian))
        Kokkos::atomic_min(&out.bad(0), first + l);
  }

  KOKKOS_FORCEINLINE_FUNCTION
  void watch(Index first, const Sym<D, R>& tau, const R& jacobian) const {
    const R reach = in.watch.reach(tau) / jacobian;
    double r[W];
    store(reach, r);
    for (int l = 0; l < W; ++l)
      if (first + l < in.end) out.hot(first + l) = r[l] >= 1.0 ? 1 : 0;
  }

  /// tau_v = beta (lambda tr(d) 1 + 2 mu d) with d the rate of deformation and beta such that
  /// the element's highest mode is damped by the given fraction of critical. The velocities are
  /// those of half a step ago and so is the shape that d is taken at: then a rotation, whose
  /// chords the velocities are, has no d at all (a midpoint rule is a Cayley transform).
  KOKKOS_FORCEINLINE_FUNCTION
  Sym<D, R> damp(Index first, Index last, const Mat<D, R>& g, const R& det, const R& jacobian,
                 Sums<1>& viscous) const {
    Vec<D, R> v[D + 1];
    gather(in.nodes, in.v, first, last, v);
    const Mat<D, R> rate = edges<D, R>(v);
    Mat<D, R> middle;
    for (int i = 0; i < D; ++i)
      for (int j = 0; j < D; ++j) middle(i, j) = g(i, j) - R(in.lag) * rate(i, j);
    const Mat<D, R> cofactors = cofactor(middle);
    const R over = R(1) / dot_columns(middle, cofactors);
    const Mat<D, R> h = rate * transpose(cofactors);  // velocity gradient times the determinant
    const Sym<D, R> d = symmetric_part(h) * over;
    R heights = R(0);  // sum over corners of 1 / height^2
    for (int i = 0; i < D; ++i) {
      R sum = R(0);
      for (int j = 0; j < D; ++j) {
        const R c = cofactors(i, j) * over;
        heights = heights + c * c;
        sum = sum + c;
      }
      heights = heights + sum * sum;
    }
    const R omega = R(in.wave_speed) * square_root(R(D + 1.0) * heights);
    const R beta = R(2 * in.damping) / omega;
    const Sym<D, R> tau = in.law.kirchhoff(d) * beta;
    double power[W], volume[W];
    store(contract(tau, d), power);
    store(det / jacobian, volume);
    for (int l = 0; l < W; ++l)
      if (first + l < in.end)
        viscous[0] += power[l] * volume[l] * (in.thickness / kFactorial<D> * in.kick);
    return tau;
  }

  /// V0 g_a = (thickness / D!) / J times the cofactors of the edge matrix.
  KOKKOS_FORCEINLINE_FUNCTION
  void put(Index first, const Sym<D, R>& tau, const Mat<D, R>& cofactors, const R& jacobian) const {
    const R scale = R(-in.thickness / kFactorial<D>) / jacobian;
    double f[D + 1][D][W];
    Vec<D, R> rest = Vec<D, R>::zero();
    for (int a = 0; a < D; ++a) {
      Vec<D, R> normal;
      for (int i = 0; i < D; ++i) normal[i] = cofactors(i, a) * scale;
      const Vec<D, R> fa = tau * normal;
      rest -= fa;
      for (int i = 0; i < D; ++i) store(fa[i], f[a + 1][i]);
    }
    for (int i = 0; i < D; ++i) store(rest[i], f[0][i]);
    for (int l = 0; l < W; ++l) {
      if (first + l >= in.end) break;
      for (int a = 0; a <= D; ++a)
        for (int i = 0; i < D; ++i) out.force(first + l, a, i) = f[a][i][l];
    }
  }
};

/// Runs the loop over chunks of packs; chunks are counted from the block's first element.
template <class Loop>
void launch(const Loop& loop, Index begin, Index end, const ChunkSums<1>& viscous) {
  constexpr int kWidth = Loop::W;
  if constexpr (kOnDevice) {
    for_each_summed<1>(
        "breccia::solid::element_force", end - begin, viscous,
        KOKKOS_LAMBDA(Index i, Sums<1> & sums) { loop(begin + i, sums); });
  } else {
    const Index n = end - begin;
    count_launch();
    Kokkos::parallel_for(
        "breccia::solid::element_force",
        Kokkos::RangePolicy<Exec, Kokkos::IndexType<Index>>(0, chunks_of(n)),
        KOKKOS_LAMBDA(Index chunk) {
          const Index from = begin + chunk * kChunk;
          const Index to = from + kChunk < end ? from + kChunk : end;
          Sums<1> sums;
          for (Index first = from; first < to; first += kWidth) loop(first, sums);
          viscous(chunk, 0) += sums[0];
        });
  }
}

}  // namespace

template <int D>
void element_force(const ElementForceIn<D>& in, const ElementForceOut<D>& out) {
  if (in.end <= in.begin) return;
  const auto run = [&](const auto& loop) { launch(loop, in.begin, in.end, out.viscous); };
  if (in.damping > 0 && in.watch.on()) {
    run(ElementForceLoop<D, true, true>{in, out});
  } else if (in.damping > 0) {
    run(ElementForceLoop<D, true, false>{in, out});
  } else if (in.watch.on()) {
    run(ElementForceLoop<D, false, true>{in, out});
  } else {
    run(ElementForceLoop<D, false, false>{in, out});
  }
}

template void element_force<2>(const ElementForceIn<2>&, const ElementForceOut<2>&);
template void element_force<3>(const ElementForceIn<3>&, const ElementForceOut<3>&);

}  // namespace breccia
