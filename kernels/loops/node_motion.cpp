#include "loops/node_motion.hpp"

#include "loops/compact.hpp"
#include "point/absorbing.hpp"

#include <type_traits>

namespace breccia {

namespace {

/// F: type of the elements' corner forces. All sums are of doubles.
template <int D, class F>
struct NodeMotionLoop {
  NodeMotionIn<D> in;
  const F* element_force;
  NodeMotionOut<D> out;
  std::uint32_t extra_any;  ///< bits of all classes
  Index nodes;

  KOKKOS_FORCEINLINE_FUNCTION
  void operator()(Index n, Sums<kWorks>& work) const {
    KOKKOS_IF_ON_HOST((fetch_ahead(n + kAhead);))
    const Index begin = in.corners(n, 0), end = in.corners(n, 1);
    const std::uint32_t flags = in.flags(n);
    const double m = in.mass(n);
    // All its elements are excavated: it stays where it is, and nothing has to hold it there.
    if (!(m > 0)) return let_go(n, flags);
    const Vec<D> v = row<D>(out.v, n);

    Forces f;
    if ((flags & extra_any) == 0)
      f.element = gather(begin, end);
    else
      gather_all(begin, end, flags, f);
    const Vec<D> weight = in.gravity * (in.added_mass.extent(0) > 0 ? m - in.added_mass(n) : m);
    Vec<D> total = f.element + weight;
    for (int c = 0; c < kExtraClasses; ++c) total += f.extra[c];

    Vec<D> drag = Vec<D>::zero();
    if (in.resisting > 0) drag = resist(flags, v, total);
    total += drag;

    Vec<D> v_new = v + total * (in.kick / m);
    if ((flags & in.absorb_bit) != 0) {
      const Vec<D> lost = absorb(n, begin, end, flags, v, total, v_new);
      work[7] += dot(lost, (v + v_new) * (0.5 * in.kick));
      total += lost;
    }
    Vec<D> reaction = Vec<D>::zero();
    if ((flags & in.fixed_bits) != 0) hold(n, flags, m, v, total, v_new, reaction);

    const Vec<D> way = (v + v_new) * (0.5 * in.kick);
    work[0] += dot(f.element, way);
    for (int c = 0; c < kExtraClasses; ++c) work[1 + c] += dot(f.extra[c], way);
    work[4] += dot(weight, way);
    work[5] += dot(reaction, way);
    if (in.resisting > 0) work[6] += dot(drag, way);
    set_row<D>(out.v, n, v_new);
    set_row<D>(out.x, n, row<D>(out.x, n) + v_new * in.dt);
  }

 private:
  KOKKOS_FUNCTION
  void let_go(Index n, std::uint32_t flags) const {
    if ((flags & in.fixed_bits) != 0) set_row<D>(out.reaction, n, Vec<D>::zero());
  }

  struct Forces {
    Vec<D> element = Vec<D>::zero();
    Vec<D> extra[kExtraClasses] = {Vec<D>::zero(), Vec<D>::zero(), Vec<D>::zero()};
  };

  /// Three floats are read as four, which become doubles at once: the fourth is the next corner's
  /// or lies in the room behind the last element (scene/model_builder.cpp), and is left out.
  static constexpr int kRead = D == 3 && std::is_same_v<F, float> ? 4 : D;

  KOKKOS_FORCEINLINE_FUNCTION
  Vec<D> gather(Index begin, Index end) const {
    double sum[kRead] = {};
    for (Index k = begin; k < end; ++k) {
      const F* corner = element_force + static_cast<std::ptrdiff_t>(in.corner_list(k)) * D;
      for (int d = 0; d < kRead; ++d) sum[d] += corner[d];
    }
    Vec<D> f;
    for (int d = 0; d < D; ++d) f[d] = sum[d];
    return f;
  }

  /// Nodes that came from splits stand far from their corners' forces: asked for ahead of time,
  /// first the numbers of the corners, then the forces.
  KOKKOS_FORCEINLINE_FUNCTION
  void fetch_ahead(Index n) const {
    if (n + kAhead >= nodes) return;
    if ((in.flags(n + kAhead) & extra_any) != 0) fetch(&in.corner_list(in.corners(n + kAhead, 0)));
    if ((in.flags(n) & extra_any) == 0) return;
    for (Index k = in.corners(n, 0); k < in.corners(n, 1); ++k) {
      const auto at = static_cast<std::ptrdiff_t>(in.corner_list(k)) * D;
      fetch(element_force + at);
      for (int c = 0; c < kExtraClasses; ++c)
        if ((in.flags(n) & in.extra_bit[c]) != 0) fetch(in.extra[c].data() + at);
    }
  }

  static constexpr Index kAhead = 12;

  /// All classes in one round over the corners. A class that the node does not have reads the
  /// force of one that it has and takes nothing of it: no branch that cannot be foretold.
  KOKKOS_FORCEINLINE_FUNCTION
  void gather_all(Index begin, Index end, std::uint32_t flags, Forces& f) const {
    const double* base[kExtraClasses];
    double share[kExtraClasses];
    const double* at_hand = nullptr;
    for (int c = 0; c < kExtraClasses; ++c)
      if ((flags & in.extra_bit[c]) != 0) at_hand = in.extra[c].data();
    for (int c = 0; c < kExtraClasses; ++c) {
      const bool has = (flags & in.extra_bit[c]) != 0;
      base[c] = has ? in.extra[c].data() : at_hand;
      share[c] = has ? 1.0 : 0.0;
    }
    for (Index k = begin; k < end; ++k) {
      const auto at = static_cast<std::ptrdiff_t>(in.corner_list(k)) * D;
      for (int d = 0; d < D; ++d) f.element[d] += element_force[at + d];
      for (int c = 0; c < kExtraClasses; ++c)
        for (int d = 0; d < D; ++d) f.extra[c][d] += share[c] * base[c][at + d];
    }
  }

  /// Force of the boundary on a node that lets waves out; its velocity after the kick.
  KOKKOS_FUNCTION
  Vec<D> absorb(Index n, Index begin, Index end, std::uint32_t flags, const Vec<D>& v,
                const Vec<D>& total, Vec<D>& v_new) const {
    Sym<D> c = Sym<D>::zero();
    for (Index k = begin; k < end; ++k) {
      const Index corner = in.corner_list(k);
      const Index at = in.absorber(corner / (D + 1));
      if (at < 0) continue;
      for (int i = 0; i < Sym<D>::size; ++i) c.s[i] += in.absorbing(at, corner % (D + 1), i);
    }
    const auto boundary = static_cast<Index>(flags >> in.boundary_shift);
    const std::uint32_t held = flags & in.fixed_bits;
    for (int d = 0; d < D; ++d)
      if ((held & (1u << d)) != 0) v_new[d] = in.boundary_velocity(boundary, d);
    absorbing_kick(in.mass(n), in.kick, c, v, total, held, v_new);
    return (c * (v + v_new)) * -0.5;
  }

  KOKKOS_FUNCTION
  Vec<D> resist(std::uint32_t flags, const Vec<D>& v, const Vec<D>& total) const {
    Vec<D> drag = Vec<D>::zero();
    for (int d = 0; d < D; ++d) {
      if ((flags & in.fixed_bits & (1u << d)) != 0 || v[d] == 0) continue;
      const double size = in.resisting * Kokkos::abs(total[d]);
      drag[d] = v[d] > 0 ? -size : size;
    }
    return drag;
  }

  KOKKOS_FUNCTION
  void hold(Index n, std::uint32_t flags, double m, const Vec<D>& v, const Vec<D>& total,
            Vec<D>& v_new, Vec<D>& reaction) const {
    const auto boundary = static_cast<Index>(flags >> in.boundary_shift);
    const bool rigid = (flags & in.rigid_bit) != 0;
    if (rigid) v_new = of_rigid_body(n, boundary);
    for (int d = 0; d < D; ++d) {
      if ((flags & in.fixed_bits & (1u << d)) == 0) continue;
      if (!rigid) v_new[d] = in.boundary_velocity(boundary, d);
      reaction[d] = m * (v_new[d] - v[d]) / in.kick - total[d];
    }
    set_row<D>(out.reaction, n, reaction);
  }

  KOKKOS_FUNCTION
  Vec<D> of_rigid_body(Index n, Index body) const {
    const Vec<D> arm = row<D>(in.reference, n) - row<D>(in.rigid_origin, body);
    Vec<D> v = row<D>(in.rigid_velocity, body);
    for (int i = 0; i < D; ++i)
      for (int j = 0; j < D; ++j) v[i] += in.rigid_change(body, i, j) * arm[j];
    return v;
  }
};

}  // namespace

template <int D>
void node_motion(Index nodes, const NodeMotionIn<D>& in, const NodeMotionOut<D>& out) {
  const std::uint32_t any = in.extra_bit[0] | in.extra_bit[1] | in.extra_bit[2];
  const auto run = [&](const auto* force) {
    using F = std::remove_cv_t<std::remove_pointer_t<decltype(force)>>;
    for_each_summed<kWorks>("breccia::motion::node_motion", nodes, out.work,
                            NodeMotionLoop<D, F>{in, force, out, any, nodes});
  };
  if (in.element_force.single.extent(0) > 0)
    run(in.element_force.single.data());
  else
    run(in.element_force.wide.data());
}

template void node_motion<2>(Index, const NodeMotionIn<2>&, const NodeMotionOut<2>&);
template void node_motion<3>(Index, const NodeMotionIn<3>&, const NodeMotionOut<3>&);

}  // namespace breccia
