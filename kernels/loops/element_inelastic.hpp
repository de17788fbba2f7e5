#pragma once
#include "loops/element_laws.hpp"
#include "loops/element_response.hpp"
#include "point/radial_return.hpp"

namespace breccia {

/// Isotropic elasticity with plastic flow, damage and an equation of state, or initial stress.
///
// symbols  G [1] inverse plastic metric in material axes   B = F G F^T elastic left Cauchy-Green
//          eps = ln(B) / 2 elastic strain   p [Pa] pressure of the equation of state
// source   multiplicative plasticity in logarithmic strain: Weber and Anand 1990, Simo 1992. The
//          law sees principal strains only, so it is objective whatever it does, and hyperelastic
//          while it does not flow. docs/decisions/0006.
//
// eq:solid-17 trial eps = ln(F G F^T) / 2 with the G of the last step; after the law's return
//              G = F^-1 exp(2 eps) F^-T.
template <int D, class Law>
struct InelasticResponse {
  Law law;
  InelasticState<D> state;
  double density;       ///< kg/m3 at the start
  double dt;            ///< s since the last call
  double energy_scale;  ///< thickness / D!

  template <class R, class Lanes>
  KOKKOS_FUNCTION
  FullSym<D, R> respond(SubShape<D, R>& shape, const Lanes& lanes, int sub,
                        Sums<element_sum::count>& sums) const {
    FullSym<D, R> g;
    for (int i = 0; i < FullSym<D>::size; ++i) g[i] = lanes.read(state.elastic, sub, i);
    FullSym<D, R> eps = elastic_strain(shape, g);
    if constexpr (Lanes::kGroup > 1) eps.add_identity(shape.shift);
    // With an equation of state the law is shown the strain that makes its pressure.
    R pressed = R(0);
    if (state.has_eos) {
      pressed = (expected_pressure(shape, lanes, sub) * R(-1 / law.bulk) - trace(eps)) * R(1.0 / 3);
      eps.add_identity(pressed);
    }
    R history[kMaxHistory];
    for (int k = 0; k < Law::kHistory; ++k) history[k] = lanes.read(state.history, sub, k);
    const R mean = R(law.bulk) * trace(eps);
    const R beyond =
        law.beyond(mean, R(law.shear) * square_root(R(2) * squared_deviator(eps)), history);
    if (any(R(0) < beyond)) {
      if constexpr (kIsRadial<Law>)
        flow_radially(shape, lanes, sub, beyond, shape.shift + pressed, g, history, eps, sums);
      else
        flow(shape, lanes, sub, beyond, shape.shift + pressed, eps, sums);
    }
    const R volumetric = trace(eps);
    const R stored = R(law.shear) * squared_deviator(eps) +
                     (state.has_eos ? R(0) : R(0.5 * law.bulk) * volumetric * volumetric);
    book_stored(lanes, stored * shape.share * R(energy_scale) * shape.det / shape.jacobian, sums);
    return isotropic(HenckyElastic{law.bulk - 2 * law.shear / 3, law.shear}, eps, false);
  }

  /// The mean stress of the group: its own average, or the pressure that the equation of state
  /// gives for the group's volume, energy and heat.
  template <int Group, class R, class Lanes>
  KOKKOS_FUNCTION
  R settle(const Lanes& lanes, const GroupVolume<R>& volume, SubShape<D, R> (&shape)[Group],
           FullSym<D, R> (&tau)[Group], Sums<element_sum::count>& sums) const {
    if (!state.has_eos) {
      if constexpr (Group > 1) share_mean<D, Group>(volume, shape, tau);
      return R(law.bulk + 4.0 / 3 * law.shear);
    }
    R work = R(0), share = R(0);
    for (int s = 0; s < Group; ++s) {
      work = work + shape[s].work * shape[s].det / shape[s].jacobian;
      share = share + shape[s].share * R(1.0 / Group);
    }
    work = (work / volume.original + volume.shock_work) * R(1 / density);
    const R mass = share * volume.original * R(energy_scale * density);
    R modulus;
    const R pressure =
        advance(lanes, volume.now / volume.original, work, mass, Group, modulus, sums);
    for (int s = 0; s < Group; ++s)
      tau[s].add_identity(trace(tau[s]) * R(-1.0 / 3) - shape[s].jacobian * pressure);
    return modulus;
  }

 private:
  template <class R>
  KOKKOS_FORCEINLINE_FUNCTION
  static FullSym<D, R> elastic_strain(const SubShape<D, R>& shape, const FullSym<D, R>& g) {
    const Sym<D, R> b = congruent(shape.f, g.in);
    if constexpr (D == 2) {
      const R elastic_jacobian =
          shape.jacobian * square_root(g.in.s[0] * g.in.s[1] - g.in.s[2] * g.in.s[2]);
      return {hencky_strain(b, elastic_jacobian), R(0.5) * log_near_one(g.zz)};
    } else {
      return {hencky_strain(b, shape.jacobian), R(0)};
    }
  }

  template <class R>
  KOKKOS_FORCEINLINE_FUNCTION
  static R squared_deviator(const FullSym<D, R>& eps) {
    const R third = trace(eps) * R(1.0 / 3);
    return contract(eps, eps) - third * trace(eps);
  }

  /// J times the pressure that the group would have without plastic work in this step, Pa.
  template <class R, class Lanes>
  KOKKOS_FUNCTION
  R expected_pressure(const SubShape<D, R>& shape, const Lanes& lanes, int sub) const {
    // The group's dilation is that of the sub-element and what the group adds to it.
    double j[Lanes::W], added[Lanes::W];
    store(shape.jacobian, j);
    store(shape.shift, added);
    for (int l = 0; l < lanes.count(); ++l) {
      EosState now = read(lanes.element(l, sub));
      const double whole = Lanes::kGroup > 1 ? j[l] * Kokkos::exp(3 * added[l]) : j[l];
      state.eos.advance(now, density / whole, 0.0);
      j[l] *= now.p;
    }
    return load<R>(j);
  }

  KOKKOS_FORCEINLINE_FUNCTION
  EosState read(Index e) const {
    const auto& h = state.history;
    return {h(e, eos_place::density), h(e, eos_place::energy), h(e, eos_place::pressure),
            h(e, eos_place::distension)};
  }

  /// Moves the equations of state on and gives their pressures, Pa.
  template <class R, class Lanes>
  KOKKOS_FUNCTION
  R advance(const Lanes& lanes, const R& jacobian, const R& work, const R& mass, int group,
            R& modulus, Sums<element_sum::count>& sums) const {
    double j[Lanes::W], w[Lanes::W], m[Lanes::W], stiff[Lanes::W];
    store(jacobian, j);
    store(work, w);
    store(mass, m);
    for (int l = 0; l < Lanes::W; ++l) {
      stiff[l] = 0;
      if (l >= lanes.count()) continue;
      EosState now = read(lanes.element(l, 0));
      state.eos.advance(now, density / j[l], w[l]);
      for (int s = 0; s < group; ++s) write(lanes.element(l, s), now);
      if (lanes.counts(l)) sums[element_sum::stored] += m[l] * (now.e - state.eos.energy0);
      stiff[l] = j[l] * (state.eos.bulk_modulus(now.rho, now.e, now.alpha) + 4.0 / 3 * law.shear);
      j[l] = now.p;
    }
    modulus = load<R>(stiff);
    return load<R>(j);
  }

  KOKKOS_FORCEINLINE_FUNCTION
  void write(Index e, const EosState& now) const {
    state.history(e, eos_place::density) = now.rho;
    state.history(e, eos_place::energy) = now.e;
    state.history(e, eos_place::pressure) = now.p;
    state.history(e, eos_place::distension) = now.alpha;
  }

  /// What a radial law does to each lane that may flow.
  template <class Lanes>
  struct Returns {
    RadialReturn of[Lanes::W];
    double history[Lanes::W][kMaxHistory];

    template <class R>
    KOKKOS_FUNCTION
    Returns(const InelasticResponse& in, const Lanes& lanes, int sub,
            const double (&over)[Lanes::W], const R& trace, const R& squared,
            R (&before)[kMaxHistory]) {
      constexpr int W = Lanes::W;
      if constexpr (kHasClosedForm<Law, R>) {
        R work;
        double factor[W], spent[W], now[W];
        store(in.law.radial(squared, before, work), factor);
        store(work, spent);
        for (int l = 0; l < W; ++l) of[l] = {factor[l], 0, spent[l]};
        for (int k = 0; k < Law::kHistory; ++k) {
          store(before[k], now);
          for (int l = 0; l < W; ++l) history[l][k] = now[l];
        }
      } else {
        double total[W], size[W];
        store(trace, total);
        store(squared, size);
        for (int l = 0; l < lanes.count(); ++l) {
          if (!(over[l] > 0)) continue;
          for (int k = 0; k < Law::kHistory; ++k)
            history[l][k] = in.state.history(lanes.element(l, sub), k);
          of[l] = RadialReturn::of(in.law, total[l], size[l], history[l], in.dt);
          if (!in.state.has_eos) continue;
          in.keep_volume(total[l] + of[l].growth, of[l].growth / 3, of[l].work);
          of[l].growth = 0;
        }
      }
    }
  };

  /// The return of a law that scales the deviator: the law for each lane, the strain and the
  /// metric, eq:solid-18, of the whole pack. A lane whose strain changes much takes the long way.
  ///
  /// eq:solid-18  G := M G M^T, M = F^-1 exp(eps' - eps) F, which is eq:solid-17 since eps' - eps
  ///              has the axes of eps.
  template <class R, class Lanes>
  KOKKOS_FUNCTION
  void flow_radially(SubShape<D, R>& shape, const Lanes& lanes, int sub, const R& beyond,
                     const R& added, const FullSym<D, R>& g, R (&history)[kMaxHistory],
                     FullSym<D, R>& eps, Sums<element_sum::count>& sums) const {
    constexpr int W = Lanes::W;
    FullSym<D, R> change = eps;
    change.add_identity(trace(eps) * R(-1.0 / 3));
    const R size = contract(change, change);
    double over[W], far[W], squared[W], volume[W], less[W], growth[W], work[W];
    store(beyond, over);
    store(size, squared);
    store(shape.share * R(energy_scale) * shape.det / shape.jacobian, volume);
    const Returns<Lanes> back(*this, lanes, sub, over, trace(eps), size, history);
    bool any_near = false, any_far = false;
    for (int l = 0; l < W; ++l) {
      less[l] = growth[l] = work[l] = 0;
      far[l] = -1;
      if (!(over[l] > 0) || l >= lanes.count()) {
        over[l] = 0;
        continue;
      }
      const double lost = back.of[l].factor - 1, more = back.of[l].growth / 3;
      if (lost * lost * squared[l] + 3 * more * more > kSmallExponent * kSmallExponent) {
        far[l] = 1;
        any_far = true;
        over[l] = 0;
        continue;
      }
      const Index e = lanes.element(l, sub);
      for (int k = 0; k < Law::kHistory; ++k) state.history(e, k) = back.history[l][k];
      work[l] = back.of[l].work;
      if (lanes.counts(l)) sums[element_sum::plastic] += work[l] * volume[l];
      less[l] = lost;
      growth[l] = more;
      if (lost == 0 && more == 0)
        over[l] = 0;
      else
        any_near = true;
    }
    shape.work = load<R>(work);
    if (any_near) {
      change *= load<R>(less);
      change.add_identity(load<R>(growth));
      spread(shape, lanes, sub, over, change, g);
    }
    if (any_far) flow(shape, lanes, sub, load<R>(far), added, eps, sums);
    if (any_near) eps += change;
  }

  /// eq:solid-18 where `over` is above 0.
  template <class R, class Lanes>
  KOKKOS_FUNCTION
  void spread(const SubShape<D, R>& shape, const Lanes& lanes, int sub,
              const double (&over)[Lanes::W], const FullSym<D, R>& change,
              const FullSym<D, R>& g) const {
    const Mat<D, R> cofactors = cofactor(shape.f);
    const R inverse = R(1) / shape.jacobian;
    Mat<D, R> back;
    for (int i = 0; i < D; ++i)
      for (int j = 0; j < D; ++j) back(i, j) = cofactors(j, i) * inverse;
    const Sym<D, R> exponential = small_exponential(change.in);
    Mat<D, R> middle;
    for (int i = 0; i < D; ++i)
      for (int j = 0; j < D; ++j) middle(i, j) = exponential(i, j);
    FullSym<D, R> next{congruent(back * middle * shape.f, g.in), R(0)};
    if constexpr (D == 2) next.zz = g.zz * small_exponential(R(2) * change.zz);
    for (int i = 0; i < FullSym<D>::size; ++i) {
      double value[Lanes::W];
      store(next[i], value);
      for (int l = 0; l < lanes.count(); ++l)
        if (over[l] > 0) state.elastic(lanes.element(l, sub), i) = value[l];
    }
  }

  /// Volume belongs to the equation of state: the flow keeps it and does no work on it. `trace` of
  /// the strain that the law left, `change` of each normal strain.
  KOKKOS_FORCEINLINE_FUNCTION
  void keep_volume(double trace, double change, double& work) const {
    work += 3 * law.bulk * trace * change;
    if (work < 0) work = 0;
  }

  /// The law's return, lane by lane, in principal axes.
  template <class R, class Lanes>
  KOKKOS_FUNCTION
  void flow(SubShape<D, R>& shape, const Lanes& lanes, int sub, const R& beyond, const R& added,
            FullSym<D, R>& eps, Sums<element_sum::count>& sums) const {
    constexpr int W = Lanes::W, kSize = FullSym<D>::size;
    double trial[kSize][W], f[D][D][W], over[W], add[W], volume[W], work[W];
    for (int i = 0; i < kSize; ++i) store(eps[i], trial[i]);
    for (int i = 0; i < D; ++i)
      for (int j = 0; j < D; ++j) store(shape.f(i, j), f[i][j]);
    store(beyond, over);
    store(added, add);
    store(shape.share * R(energy_scale) * shape.det / shape.jacobian, volume);
    store(shape.work, work);
    for (int l = 0; l < W; ++l) {
      if (!(over[l] > 0) || l >= lanes.count()) continue;
      FullSym<D> e;
      Mat<D> deformation;
      for (int i = 0; i < kSize; ++i) e[i] = trial[i][l];
      for (int i = 0; i < D; ++i)
        for (int j = 0; j < D; ++j) deformation(i, j) = f[i][j][l];
      work[l] = flow_one(lanes.element(l, sub), deformation, add[l], e);
      for (int i = 0; i < kSize; ++i) trial[i][l] = e[i];
      if (lanes.counts(l)) sums[element_sum::plastic] += work[l] * volume[l];
    }
    for (int i = 0; i < kSize; ++i) eps[i] = load<R>(trial[i]);
    shape.work = load<R>(work);
  }

  KOKKOS_FUNCTION
  double flow_one(Index element, const Mat<D>& f, double added, FullSym<D>& e) const {
    const Principal<D> axes = principal_of(e.in);
    double strain[3], history[kMaxHistory];
    for (int k = 0; k < D; ++k) strain[k] = axes.value[k];
    if constexpr (D == 2) strain[2] = e.zz;
    const double trial[3] = {strain[0], strain[1], strain[2]};
    for (int k = 0; k < Law::kHistory; ++k) history[k] = state.history(element, k);
    double work = law.update(strain, history, dt);
    for (int k = 0; k < Law::kHistory; ++k) state.history(element, k) = history[k];
    if (strain[0] == trial[0] && strain[1] == trial[1] && strain[2] == trial[2]) return work;
    if (state.has_eos) {
      const double volume = strain[0] + strain[1] + strain[2];
      const double change = (volume - trial[0] - trial[1] - trial[2]) / 3;
      keep_volume(volume, change, work);
      for (double& value : strain) value -= change;
    }
    e.in = axes.with(strain);
    double square[D];  // principal values of B
    for (int k = 0; k < D; ++k) square[k] = Kokkos::exp(2 * (strain[k] - added));
    const Sym<D> g = congruent(inverse(f), axes.with(square));
    for (int i = 0; i < Sym<D>::size; ++i) state.elastic(element, i) = g.s[i];
    if constexpr (D == 2) {
      e.zz = strain[2];
      state.elastic(element, 3) = Kokkos::exp(2 * (strain[2] - added));
    }
    return work;
  }
};

/// Every law with one kind of element; each kind is compiled in a file of its own.
template <int D, int Group>
void inelastic_groups(const ElementForceIn<D>& in, const ElementForceOut<D>& out,
                      const PlasticLaw& law, const InelasticState<D>& state) {
  std::visit(
      [&]<class Law>(const Law& chosen) {
        const InelasticResponse<D, Law> response{chosen, state, in.density, in.dt,
                                                 in.thickness / kFactorial<D>};
        launch(ElementLoop<D, Group, InelasticResponse<D, Law>, Wishes>{in, out, response,
                                                                        wishes_of(in, out)});
      },
      law);
}

extern template void inelastic_groups<2, 4>(const ElementForceIn<2>&, const ElementForceOut<2>&,
                                            const PlasticLaw&, const InelasticState<2>&);
extern template void inelastic_groups<3, 1>(const ElementForceIn<3>&, const ElementForceOut<3>&,
                                            const PlasticLaw&, const InelasticState<3>&);
extern template void inelastic_groups<3, 8>(const ElementForceIn<3>&, const ElementForceOut<3>&,
                                            const PlasticLaw&, const InelasticState<3>&);
extern template void inelastic_groups<3, 12>(const ElementForceIn<3>&, const ElementForceOut<3>&,
                                             const PlasticLaw&, const InelasticState<3>&);

}  // namespace breccia
