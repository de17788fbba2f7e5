#pragma once
#include "loops/contact_force.hpp"
#include "point/contact_law.hpp"
#include "point/simplex_geometry.hpp"

namespace breccia {

// What the loops over contact points share.

template <int D>
KOKKOS_INLINE_FUNCTION
ContactState<D> load_state(const ContactHistory<D>& history, Index a, int slot) {
  const double* s = &history.state(a, slot, 0);
  ContactState<D> state;
  state.phi = s[0];
  state.offset = s[1];
  state.stored = s[2];
  for (int d = 0; d < D; ++d) {
    state.slip[d] = s[3 + d];
    state.force[d] = s[3 + D + d];
    state.viscous[d] = s[3 + 2 * D + d];
  }
  if (history.rubbed.extent(0) > 0) {
    const double* r = &history.rubbed(a, slot, 0);
    state.rubbed = {r[0], r[1], r[2]};
  }
  return state;
}

template <int D>
KOKKOS_INLINE_FUNCTION
void store_state(const ContactHistory<D>& history, Index a, int slot,
                 const ContactState<D>& state) {
  double* s = &history.state(a, slot, 0);
  s[0] = state.phi;
  s[1] = state.offset;
  s[2] = state.stored;
  for (int d = 0; d < D; ++d) {
    s[3 + d] = state.slip[d];
    s[3 + D + d] = state.force[d];
    s[3 + 2 * D + d] = state.viscous[d];
  }
  if (history.rubbed.extent(0) == 0) return;
  double* r = &history.rubbed(a, slot, 0);
  r[0] = state.rubbed.slip;
  r[1] = state.rubbed.rate;
  r[2] = state.rubbed.theta;
}

/// What is kept of a point that is out of a piece, see ContactHistory.
template <int D>
KOKKOS_INLINE_FUNCTION
ContactState<D> state_apart(const ContactState<D>& old) {
  ContactState<D> apart;
  apart.phi = ContactHistory<D>::left;
  apart.rubbed = old.rubbed;
  return apart;
}

/// Law of point a against an element.
template <int D>
KOKKOS_INLINE_FUNCTION
ContactParameters contact_parameters(const ContactForceIn<D>& in, Index a, Index element) {
  const Index pair = in.point.material(a) * in.materials + in.element_material(element);
  const double share = in.table(pair, 1), ratio = in.table(pair, 2);
  ContactParameters p;
  p.normal = in.point.constants(a, 0) * share;
  p.tangential = p.normal * ratio;
  // A dashpot that takes longer than a step makes energy: a large face that presses small elements.
  const double damping = in.point.constants(a, 1) * in.table(pair, 3);
  p.damping = Kokkos::min(damping, p.normal * in.dt_before);
  p.tangential_damping = Kokkos::min(damping * Kokkos::sqrt(ratio), p.tangential * in.dt_before);
  p.friction = in.table(pair, 0);
  if (in.laws.extent(0) > 0) p.law = &in.laws(pair);
  return p;
}

/// Way of a place that moves at v past what it left in an element, during the last step, m.
template <int D>
KOKKOS_FUNCTION
Vec<D> way_past(const ContactForceIn<D>& in, Index element, const Vec<D>& at, const Vec<D>& v) {
  Index node[D + 1];
  Vec<D> x[D + 1];
  for (int k = 0; k <= D; ++k) {
    node[k] = in.element_nodes(element, k);
    x[k] = row<D>(in.x, node[k]);
  }
  double l[D + 1];
  barycentric(inverse(edge_matrix<D>(x)), x[0], at, l);
  Vec<D> way = v;
  for (int k = 0; k <= D; ++k) way -= row<D>(in.v, node[k]) * l[k];
  return way * in.dt_before;
}

template <int D>
KOKKOS_INLINE_FUNCTION
void book_contact(const ContactResponse<D>& r, Sums<3>& lost) {
  lost[0] += r.friction;
  lost[1] += r.viscous;
  lost[2] += r.numeric;
}

}  // namespace breccia
