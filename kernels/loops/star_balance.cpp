#include "loops/star_balance.hpp"

#include "loops/face_traction.hpp"
#include "point/cohesive_encode.hpp"
#include "point/interface_frame.hpp"

namespace breccia {

namespace {

template <int D>
struct BalanceLoop {
  StarBalanceIn<D> in;
  StarBalanceOut<D> out;

  static constexpr double kFlat = 1e-12;

  /// Places [first, last) of one old node, in a star whose first place is `place` and whose first
  /// corner is `begin` in the corner list.
  struct Group {
    Index begin, place, first, last;
  };

  KOKKOS_FUNCTION
  void operator()(Index t) const {
    const Index begin = in.map.family_corners(in.work.family(t), 0);
    const Index n = in.map.family_corners(in.work.family(t), 1) - begin;
    Group g{begin, in.work.begin(t), 0, 0};
    for (; g.first < n; g.first = g.last) {
      const Index node = in.map.node(in.map.corner_list(begin + g.first));
      g.last = in.map.node_corners(node, 1) - begin;
      Index components = 0;
      for (Index i = g.first; i < g.last; ++i) components += root(g, i) == i ? 1 : 0;
      if (components < 2) continue;
      weigh(g);
      sum_forces(g);
      solve(g, components);
      activate(g, in.flags(node));
    }
  }

 private:
  KOKKOS_FUNCTION
  Index root(const Group& g, Index i) const { return in.work.root(g.place + i); }
  KOKKOS_FUNCTION
  Index corner(const Group& g, Index i) const { return in.map.corner_list(g.begin + i); }

  /// Area of each corner that is to be activated; a corner inside one component stays locked.
  KOKKOS_FUNCTION
  void weigh(const Group& g) const {
    for (Index i = g.first; i < g.last; ++i) {
      const Index e = in.map.element(corner(g, i));
      const int a = in.map.local(corner(g, i));
      for (int m = 0; m < D; ++m) {
        double weight = 0;
        const Index j = in.work.link(g.place + i, m);
        if (j >= g.first && j < g.last && root(g, j) != root(g, i)) {
          const Index face = in.map.faces.of_element(e, in.map.face_at(a, m));
          const Index k = in.of_face(face);
          const bool fresh = k != kNone && out.active(k, in.map.faces.corner_at(face, e, a)) == 0;
          weight = fresh ? in.record(k).area / D : 0;
        }
        in.work.weight(g.place + i, m) = weight;
      }
    }
  }

  /// wanted = m_c a - f_c at the root of each component, potential = 0.
  KOKKOS_FUNCTION
  void sum_forces(const Group& g) const {
    const StarWork<D>& w = in.work;
    double mass = 0;
    Vec<D> total = Vec<D>::zero();
    for (Index i = g.first; i < g.last; ++i) {
      w.mass(g.place + i) = 0;
      for (int d = 0; d < D; ++d) w.wanted(g.place + i, d) = w.potential(g.place + i, d) = 0;
      const Index c = g.place + root(g, i);  // c <= place + i, so it is cleared already
      const double m = in.corner_mass(in.map.element(corner(g, i)));
      w.mass(c) += m;
      mass += m;
      for (int d = 0; d < D; ++d) {
        double f = 0;
        for (int k = 0; k < kCornerForceClasses; ++k)
          if (in.force[k].present())
            f += in.force[k](in.map.element(corner(g, i)), in.map.local(corner(g, i)), d);
        w.wanted(c, d) -= f;
        total[d] += f;
      }
    }
    for (Index i = g.first; i < g.last; ++i)
      for (int d = 0; d < D; ++d)
        w.wanted(g.place + i, d) += w.mass(g.place + i) * (total[d] / mass);
  }

  /// to = L from, L the Laplacian of the components with the corner areas as weights.
  KOKKOS_FUNCTION
  void apply(const Group& g, const Vectors<D>& from, const Vectors<D>& to) const {
    for (Index i = g.first; i < g.last; ++i) {
      const Index p = g.place + root(g, i);
      if (root(g, i) == i)
        for (int d = 0; d < D; ++d) to(p, d) = 0;
      for (int m = 0; m < D; ++m) {
        const double weight = in.work.weight(g.place + i, m);
        if (weight == 0) continue;
        const Index q = g.place + root(g, in.work.link(g.place + i, m));
        for (int d = 0; d < D; ++d) to(p, d) += weight * (from(p, d) - from(q, d));
      }
    }
  }

  KOKKOS_FUNCTION
  Vec<D> product(const Group& g, const Vectors<D>& a, const Vectors<D>& b) const {
    Vec<D> sum = Vec<D>::zero();
    for (Index i = g.first; i < g.last; ++i)
      if (root(g, i) == i)
        for (int d = 0; d < D; ++d) sum[d] += a(g.place + i, d) * b(g.place + i, d);
    return sum;
  }

  /// residual = direction = wanted - L potential, its mean taken off: the sum over the components
  /// is zero but for round-off, which no potential could balance.
  KOKKOS_FUNCTION
  void start_round(const Group& g, Index components) const {
    const StarWork<D>& w = in.work;
    apply(g, w.potential, w.image);
    Vec<D> mean = Vec<D>::zero();
    for (Index i = g.first; i < g.last; ++i)
      for (int d = 0; d < D; ++d) {
        w.residual(g.place + i, d) = 0;
        if (root(g, i) != i) continue;
        w.residual(g.place + i, d) = w.wanted(g.place + i, d) - w.image(g.place + i, d);
        mean[d] += w.residual(g.place + i, d) / components;
      }
    for (Index i = g.first; i < g.last; ++i)
      for (int d = 0; d < D; ++d) {
        if (root(g, i) == i) w.residual(g.place + i, d) -= mean[d];
        w.direction(g.place + i, d) = w.residual(g.place + i, d);
      }
  }

  /// Conjugate gradients, each component of motion for itself, started anew from the true residual
  /// so that only round-off is left. The graph is connected, the system singular but consistent.
  KOKKOS_FUNCTION
  void solve(const Group& g, Index components) const {
    constexpr int kRounds = 3;
    constexpr double kEnough = 1e-33;  // of the square
    const Vec<D> enough = product(g, in.work.wanted, in.work.wanted) * kEnough;
    for (int round = 0; round < kRounds; ++round) {
      start_round(g, components);
      Vec<D> left = product(g, in.work.residual, in.work.residual);
      for (Index k = 0; k < components + 2; ++k) {
        bool done = true;
        for (int d = 0; d < D; ++d) done = done && left[d] <= enough[d];
        if (done) break;
        left = descend(g, left, enough);
      }
    }
  }

  KOKKOS_FUNCTION
  double heaviest(const Group& g) const {
    double most = 0;
    for (Index i = g.first; i < g.last; ++i)
      for (int m = 0; m < D; ++m) most = Kokkos::max(most, in.work.weight(g.place + i, m));
    return most;
  }

  KOKKOS_FUNCTION
  Vec<D> descend(const Group& g, const Vec<D>& left, const Vec<D>& enough) const {
    const StarWork<D>& w = in.work;
    apply(g, w.direction, w.image);
    const Vec<D> curvature = product(g, w.direction, w.image);
    const Vec<D> length = product(g, w.direction, w.direction);
    Vec<D> step, turn;
    for (int d = 0; d < D; ++d) {
      // A direction without curvature is one that moves all components together: round-off.
      const bool bends = curvature[d] > kFlat * heaviest(g) * length[d];
      step[d] = left[d] > enough[d] && bends ? left[d] / curvature[d] : 0;
    }
    for (Index i = g.first; i < g.last; ++i)
      for (int d = 0; d < D; ++d) {
        if (root(g, i) != i) continue;
        w.potential(g.place + i, d) += step[d] * w.direction(g.place + i, d);
        w.residual(g.place + i, d) -= step[d] * w.image(g.place + i, d);
      }
    const Vec<D> now = product(g, w.residual, w.residual);
    for (int d = 0; d < D; ++d) turn[d] = left[d] > 0 ? now[d] / left[d] : 0;
    for (Index i = g.first; i < g.last; ++i)
      for (int d = 0; d < D; ++d)
        w.direction(g.place + i, d) =
            w.residual(g.place + i, d) + turn[d] * w.direction(g.place + i, d);
    return now;
  }

  /// Encodes the tractions of the corners with a weight, once each, from the left side.
  KOKKOS_FUNCTION
  void activate(const Group& g, std::uint32_t flags) const {
    for (Index i = g.first; i < g.last; ++i) {
      const Index e = in.map.element(corner(g, i));
      const int a = in.map.local(corner(g, i));
      for (int m = 0; m < D; ++m) {
        const Index face = in.map.faces.of_element(e, in.map.face_at(a, m));
        if (in.work.weight(g.place + i, m) == 0 || in.map.faces.elements(face, 0) != e) continue;
        const Index p = g.place + root(g, i);
        const Index q = g.place + root(g, in.work.link(g.place + i, m));
        Vec<D> traction;
        for (int d = 0; d < D; ++d) traction[d] = in.work.potential(p, d) - in.work.potential(q, d);
        encode_corner(face, in.map.faces.corner_at(face, e, a), flags, traction);
      }
    }
  }

  KOKKOS_FUNCTION
  void encode_corner(Index face, int c, std::uint32_t flags, Vec<D> traction) const {
    Vec<D> x[D];  // the mid-surface, as in interface_force
    for (int b = 0; b < D; ++b)
      x[b] = (face_point(in.map.faces, in.map.element_nodes, in.x, face, 0, b) +
              face_point(in.map.faces, in.map.element_nodes, in.x, face, 1, b)) *
             0.5;
    const std::uint32_t fixed_any = ((1u << D) - 1) * in.fixed_x;
    if ((flags & fixed_any) != 0) {
      const FaceTraction<D> mean = face_traction(in.map.faces, in.corner_mass.shape, face);
      for (int d = 0; d < D; ++d)
        if ((flags & (in.fixed_x << d)) != 0) traction[d] = mean.traction[d];
    }
    const Index k = in.of_face(face);
    const InterfaceRecord& record = in.record(k);
    const InterfaceLaw& law = in.laws(record.law);
    const InterfaceFrame<D> frame = frame_of(x);
    const Vec<D> local = frame.to_local(traction);
    if (law.fault)
      encode_fault(k, c, law, frame, local);
    else
      encode_cohesive(k, c, law, local);
    for (int d = 0; d < D; ++d) out.force(k, c, d) = traction[d] * (record.area / D);
    out.active(k, c) = 1;
  }

  KOKKOS_FUNCTION
  void encode_cohesive(Index k, int c, const InterfaceLaw& law, const Vec<D>& local) const {
    const InterfaceRecord& record = in.record(k);
    CohesiveStrength strength = law.strength;
    strength.tension *= record.dynamic_share;
    strength.cohesion *= record.dynamic_share;
    out.state(k, c) = law.z_curve ? encode<D, ZCurve>(strength, record.springs, local)
                                  : encode<D, LinearSoftening>(strength, record.springs, local);
    out.energy(k, c) = {0, 0, 0, 0, encoded_energy(record.springs, out.state(k, c))};
  }

  /// A fault under tension opens: its first force is not that of the elements.
  KOKKOS_FUNCTION
  void encode_fault(Index k, int c, const InterfaceLaw& law, const InterfaceFrame<D>& frame,
                    const Vec<D>& local) const {
    const Fault<D> fault{law.friction, in.record(k).springs};
    Vec<D> load = Vec<D>::zero();
    for (int i = 0; i < D; ++i)
      for (int j = 0; j < D; ++j) load[i] += law.load(i, j) * frame.normal()[j];
    out.fault(k, c) = fault.encode(local, frame.to_local(load));
    out.energy(k, c) = {0, 0, 0, 0, fault.stored(out.fault(k, c))};
    out.state(k, c) = encode<D, LinearSoftening>({}, in.record(k).springs, Vec<D>::zero());
  }
};

}  // namespace

template <int D>
void balance_stars(const StarBalanceIn<D>& in, const StarBalanceOut<D>& out) {
  for_each("breccia::fracture::balance", in.work.families, BalanceLoop<D>{in, out});
}

template void balance_stars<2>(const StarBalanceIn<2>&, const StarBalanceOut<2>&);
template void balance_stars<3>(const StarBalanceIn<3>&, const StarBalanceOut<3>&);

}  // namespace breccia
