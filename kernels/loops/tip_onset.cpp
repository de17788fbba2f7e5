#include "loops/tip_onset.hpp"

#include "loops/compact.hpp"
#include "loops/face_traction.hpp"

namespace breccia {

namespace {

constexpr std::uint8_t kBonded = 0, kInserted = 1, kTied = 3;  // fields/common_fields.hpp
constexpr Index kLargestStar = 64;  ///< corners at one node: bits of a set

template <int D>
struct FlagLoop {
  TipOnsetIn<D> in;
  ConstArray<Index> list;
  Array<std::uint8_t> flag;

  KOKKOS_FUNCTION
  void operator()(Index t) const {
    const Index family = list.extent(0) > 0 ? list(t) : t;
    bool locked = false;
    for (Index k = in.map.family_corners(family, 0); k < in.map.family_corners(family, 1); ++k) {
      const Index e = in.map.element(in.map.corner_list(k));
      const int a = in.map.local(in.map.corner_list(k));
      for (int m = 0; m < D; ++m) {
        const Index face = in.map.faces.of_element(e, in.map.face_at(a, m));
        if (face == kNone || in.map.status(face) != kInserted) continue;
        locked = locked || in.active(in.of_face(face), in.map.faces.corner_at(face, e, a)) == 0;
      }
    }
    flag(family) = static_cast<std::uint8_t>((flag(family) & tip::notch) |
                                             (locked ? tip::locked : std::uint8_t{0}));
  }
};

template <int D>
struct TipLoop {
  TipOnsetIn<D> in;
  ConstArray<Index> tips;
  Array<Index> choice;

  /// Corners first, first + 1, ... of the corner list: the elements at one node.
  struct Group {
    Index first, size;
  };

  struct Best {
    Index face;
    double share;  ///< of its strength over that at which it is inserted
  };

  KOKKOS_FUNCTION
  void operator()(Index t) const {
    const Index family = tips(t);
    Best best{kNone, 1};
    const Index end = in.map.family_corners(family, 1);
    for (Index k = in.map.family_corners(family, 0); k < end;) {
      const Index node = in.map.node(in.map.corner_list(k));
      const Group g{k, in.map.node_corners(node, 1) - k};
      k += g.size;
      if (g.size < 2 || g.size > kLargestStar || (in.flags(node) & in.fixed) != 0) continue;
      if (strained(g)) look(g, best);
    }
    choice(t) = best.face;
  }

 private:
  KOKKOS_FUNCTION
  Index element(const Group& g, Index i) const {
    return in.map.element(in.map.corner_list(g.first + i));
  }
  KOKKOS_FUNCTION
  int local(const Group& g, Index i) const { return in.map.local(in.map.corner_list(g.first + i)); }
  KOKKOS_FUNCTION
  Index face(const Group& g, Index i, int m) const {
    return in.map.faces.of_element(element(g, i), in.map.face_at(local(g, i), m));
  }

  /// Area of a corner of a face, m2.
  KOKKOS_FUNCTION
  double corner_area(Index f) const {
    Vec<D> x[D];
    face_corners(f, x);
    if constexpr (D == 2)
      return 0.5 * in.thickness * norm(x[1] - x[0]);
    else
      return norm(cross(x[1] - x[0], x[2] - x[0])) / 6;
  }

  KOKKOS_FUNCTION
  void face_corners(Index f, Vec<D> (&x)[D]) const {
    for (int c = 0; c < D; ++c) {
      const auto at = in.map.faces.left(f, c);
      x[c] = row<D>(in.corner_mass.shape.x, in.map.element_nodes(at.element, at.node));
    }
  }

  KOKKOS_FUNCTION
  Vec<D> corner_force(const Group& g, Index i) const {
    Vec<D> f = Vec<D>::zero();
    for (int k = 0; k < kCornerForceClasses; ++k)
      if (in.force[k].present())
        for (int d = 0; d < D; ++d) f[d] += in.force[k](element(g, i), local(g, i), d);
    return f;
  }

  /// No face can be beyond its onset where half the sum of all forces would not do on the
  /// smallest of them.
  KOKKOS_FUNCTION
  bool strained(const Group& g) const {
    double sum = 0, needed = 1e300;
    for (Index i = 0; i < g.size; ++i) {
      sum += norm(corner_force(g, i));
      for (int m = 0; m < D; ++m) {
        const Index f = face(g, i, m);
        if (f == kNone || in.map.status(f) != kBonded) continue;
        const CohesiveOnset& o = in.laws(in.law_of(f)).onset;
        const double shear = o.cohesion / Kokkos::sqrt(1 + o.friction * o.friction);
        needed = Kokkos::min(needed, o.alpha * Kokkos::min(o.tension, shear) * corner_area(f));
      }
    }
    return sum > needed;
  }

  KOKKOS_FUNCTION
  void look(const Group& g, Best& best) const {
    for (Index i = 0; i < g.size; ++i)
      for (int m = 0; m < D; ++m) {
        const Index f = face(g, i, m);
        if (f == kNone || in.map.status(f) != kBonded) continue;
        if (in.map.faces.elements(f, 0) != element(g, i)) continue;
        const double share = share_of(g, i, f);
        if (share >= best.share) best = {f, share};
      }
  }

  /// Corners that hang on corner i through faces that bond, without face f.
  KOKKOS_FUNCTION
  std::uint64_t side_of(const Group& g, Index i, Index f) const {
    std::uint64_t side = std::uint64_t{1} << i, before = 0;
    while (side != before) {
      before = side;
      for (Index j = 0; j < g.size; ++j) {
        if ((side >> j & 1) == 0) continue;
        for (int m = 0; m < D; ++m) {
          const Index link = face(g, j, m);
          if (link == kNone || link == f) continue;
          const std::uint8_t status = in.map.status(link);
          if (status == kBonded || status == kTied)
            side |= bit_of(g, in.map.faces.across(link, element(g, j)));
        }
      }
    }
    return side;
  }

  KOKKOS_FUNCTION
  std::uint64_t bit_of(const Group& g, Index e) const {
    for (Index j = 0; j < g.size; ++j)
      if (element(g, j) == e) return std::uint64_t{1} << j;
    return 0;
  }

  /// First traction of face f, whose left element is at corner i, over the one that inserts it; 0
  /// where the face alone would not open the node.
  KOKKOS_FUNCTION
  double share_of(const Group& g, Index i, Index f) const {
    const std::uint64_t left = side_of(g, i, f);
    if ((left & bit_of(g, in.map.faces.elements(f, 1))) != 0) return 0;
    Vec<D> force[2] = {Vec<D>::zero(), Vec<D>::zero()};
    double mass[2] = {0, 0}, area = corner_area(f);
    for (Index j = 0; j < g.size; ++j) {
      const int side = (left >> j & 1) != 0 ? 0 : 1;
      force[side] += corner_force(g, j);
      mass[side] += in.corner_mass(element(g, j));
      if (side == 0) area += locked_area(g, j, left);
    }
    // What keeps the acceleration of both sides: m_1 a - f_1 with a = (f_1 + f_2)/(m_1 + m_2).
    const Vec<D> hold = force[1] * mass[0] - force[0] * mass[1];
    const Vec<D> traction = hold * (1 / ((mass[0] + mass[1]) * area));
    Vec<D> x[D];
    face_corners(f, x);
    const CohesiveOnset& onset = in.laws(in.law_of(f)).onset;
    const Vec<D> n = frame_of(x).normal();
    const double share = onset.measure(traction, n) / onset.alpha;
    if (share < 1) return share;
    const double grown = dynamic_share(in.map.faces, in.corner_mass.shape, in.velocity, f, onset);
    return onset.scaled(grown).measure(traction, n) / onset.alpha;
  }

  /// Area of the locked corners that would open with it, at corner j of the left side.
  KOKKOS_FUNCTION
  double locked_area(const Group& g, Index j, std::uint64_t left) const {
    double area = 0;
    for (int m = 0; m < D; ++m) {
      const Index f = face(g, j, m);
      if (f == kNone || in.map.status(f) != kInserted) continue;
      const int c = in.map.faces.corner_at(f, element(g, j), local(g, j));
      const std::uint64_t other = bit_of(g, in.map.faces.across(f, element(g, j)));
      if (in.active(in.of_face(f), c) == 0 && other != 0 && (left & other) == 0)
        area += corner_area(f);
    }
    return area;
  }
};

}  // namespace

template <int D>
void flag_tips(const TipOnsetIn<D>& in, const ConstArray<Index>& list, Index count,
               const Array<std::uint8_t>& flag) {
  for_each("breccia::fracture::flag_tips", count, FlagLoop<D>{in, list, flag});
}

template <int D>
Index find_tip_onset(const TipOnsetIn<D>& in, const ConstArray<Index>& tips, Index count,
                     const ConstArray<Index>& tip_of, const Array<Index>& choice,
                     const Array<Index>& found) {
  for_each("breccia::fracture::tip_onset", count, TipLoop<D>{in, tips, choice});
  const StarMap<D> map = in.map;
  const ConstArray<Index> family = in.family;
  // A face between two tips belongs to the first of those that chose it.
  return scan(
      "breccia::fracture::list_tip_onset", count, KOKKOS_LAMBDA(Index t, Index & at, bool last) {
        const Index face = choice(t);
        if (face == kNone) return;
        for (int c = 0; c < D; ++c) {
          const auto corner = map.faces.left(face, c);
          const Index other = tip_of(family(map.element_nodes(corner.element, corner.node)));
          if (other != kNone && other < t && choice(other) == face) return;
        }
        if (last) found(at) = face;
        ++at;
      });
}

template void flag_tips<2>(const TipOnsetIn<2>&, const ConstArray<Index>&, Index,
                           const Array<std::uint8_t>&);
template Index find_tip_onset<2>(const TipOnsetIn<2>&, const ConstArray<Index>&, Index,
                                 const ConstArray<Index>&, const Array<Index>&,
                                 const Array<Index>&);

}  // namespace breccia
