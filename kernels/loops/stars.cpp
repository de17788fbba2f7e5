#include "loops/stars.hpp"

namespace breccia {

namespace {

constexpr bool bonds(std::uint8_t status) {
  return status == 0 || status == 3;  // bonded, tied (fields/common_fields.hpp)
}

template <int D>
struct ComponentLoop {
  StarMap<D> map;
  StarWork<D> work;

  KOKKOS_FUNCTION
  void operator()(Index t) const {
    const Index begin = map.family_corners(work.family(t), 0);
    const Index n = map.family_corners(work.family(t), 1) - begin;
    const Index place = work.begin(t);
    for (Index i = 0; i < n; ++i) link(begin, n, place, i);
    while (spread(begin, n, place)) {
    }
    Index fresh = 0;
    for (Index i = 0; i < n; ++i) {
      const Index node = map.node(map.corner_list(begin + i));
      if (work.root(place + i) == i && map.node_corners(node, 0) != begin + i) ++fresh;
    }
    work.fresh(t) = fresh;
  }

 private:
  KOKKOS_FUNCTION
  void link(Index begin, Index n, Index place, Index i) const {
    const Index corner = map.corner_list(begin + i);
    const Index e = map.element(corner);
    work.root(place + i) = i;
    for (int m = 0; m < D; ++m) {
      const Index face = map.faces.of_element(e, map.face_at(map.local(corner), m));
      Index across = kNone;
      if (face != kNone) {
        const Index other = map.faces.across(face, e);
        for (Index j = 0; j < n; ++j)
          if (map.element(map.corner_list(begin + j)) == other) across = j;
      }
      work.link(place + i, m) = across;
    }
  }

  /// One sweep of the smallest place number through bonding faces; true while something changes.
  KOKKOS_FUNCTION
  bool spread(Index begin, Index n, Index place) const {
    bool changed = false;
    for (Index i = 0; i < n; ++i) {
      const Index corner = map.corner_list(begin + i);
      for (int m = 0; m < D; ++m) {
        const Index j = work.link(place + i, m);
        if (j == kNone) continue;
        const int f = map.face_at(map.local(corner), m);
        if (!bonds(map.status(map.faces.of_element(map.element(corner), f)))) continue;
        const Index a = work.root(place + i), b = work.root(place + j);
        if (a == b) continue;
        work.root(place + i) = work.root(place + j) = a < b ? a : b;
        changed = true;
      }
      work.root(place + i) = work.root(place + work.root(place + i));
    }
    return changed;
  }
};

template <int D>
struct OwnerLoop {
  StarMap<D> map;
  StarWork<D> work;
  Index first;
  Array<Index> parent;

  KOKKOS_FUNCTION
  void operator()(Index t) const {
    const Index begin = map.family_corners(work.family(t), 0);
    const Index n = map.family_corners(work.family(t), 1) - begin;
    const Index place = work.begin(t);
    Index next = work.fresh(t);
    for (Index i = 0; i < n; ++i) {
      const Index root = work.root(place + i);
      const Index node = map.node(map.corner_list(begin + i));
      if (root != i) {
        work.owner(place + i) = work.owner(place + root);
      } else if (map.node_corners(node, 0) == begin + i) {
        work.owner(place + i) = node;
      } else {
        parent(next) = node;
        work.owner(place + i) = first + next++;
      }
    }
  }
};

template <int D>
struct RelabelLoop {
  StarMap<D> map;
  StarWork<D> work;
  CornerMass<D> corner_mass;
  Array<double> node_mass;
  Array<std::uint32_t> flags;
  std::uint32_t bit;

  KOKKOS_FUNCTION
  void operator()(Index t) const {
    const Index begin = map.family_corners(work.family(t), 0);
    const Index end = map.family_corners(work.family(t), 1);
    const Index place = work.begin(t);
    bool split = false;
    for (Index k = begin; k < end; ++k) {
      const Index corner = map.corner_list(k), owner = work.owner(place + k - begin);
      Index& node = map.element_nodes(map.element(corner), map.local(corner));
      split = split || node != owner;
      node = owner;
    }
    if (!split) return;
    sort(begin, end);
    for (Index k = begin; k < end;) {
      const Index node = map.node(map.corner_list(k));
      map.node_corners(node, 0) = k;
      // Without mass before: the node of another rank, or of elements that are gone.
      const bool heavy = node_mass(node) > 0;
      double mass = 0;
      for (; k < end && map.node(map.corner_list(k)) == node; ++k)
        mass += corner_mass(map.element(map.corner_list(k)));
      map.node_corners(node, 1) = k;
      if (heavy) node_mass(node) = mass;
      flags(node) |= bit;
    }
  }

 private:
  /// By node, then corner; stars are small and nearly sorted.
  KOKKOS_FUNCTION
  void sort(Index begin, Index end) const {
    for (Index k = begin + 1; k < end; ++k) {
      const Index corner = map.corner_list(k), node = map.node(corner);
      Index j = k;
      for (; j > begin; --j) {
        const Index before = map.corner_list(j - 1), its_node = map.node(before);
        if (its_node < node || (its_node == node && before < corner)) break;
        map.corner_list(j) = before;
      }
      map.corner_list(j) = corner;
    }
  }
};

}  // namespace

template <int D>
void StarWork<D>::reserve(Index places) {
  if (static_cast<Index>(root.extent(0)) >= places) return;
  const std::size_t n = static_cast<std::size_t>(places) * 3 / 2;
  root = allocate<Array<Index>>("breccia::fracture::root", n);
  owner = allocate<Array<Index>>("breccia::fracture::owner", n);
  link = allocate<decltype(link)>("breccia::fracture::link", n);
  weight = allocate<decltype(weight)>("breccia::fracture::weight", n);
  mass = allocate<Array<double>>("breccia::fracture::star_mass", n);
  for (Vectors<D>* v : {&wanted, &potential, &residual, &direction, &image})
    *v = allocate<Vectors<D>>("breccia::fracture::balance", n);
}

template <int D>
Index Stars<D>::place() const {
  const auto& [m, w] = *this;
  const ConstRanges corners = m.family_corners;
  const Array<Index> family = w.family, begin = w.begin;
  return scan(
      "breccia::fracture::place_stars", w.families, KOKKOS_LAMBDA(Index t, Index & at, bool last) {
        if (last) begin(t) = at;
        at += corners(family(t), 1) - corners(family(t), 0);
      });
}

template <int D>
void Stars<D>::find_components() const {
  for_each("breccia::fracture::components", work.families, ComponentLoop<D>{map, work});
}

template <int D>
Index Stars<D>::number_new_nodes() const {
  const Array<Index> fresh = work.fresh;
  return scan(
      "breccia::fracture::new_nodes", work.families, KOKKOS_LAMBDA(Index t, Index & at, bool last) {
        const Index n = fresh(t);
        if (last) fresh(t) = at;
        at += n;
      });
}

template <int D>
void Stars<D>::name_owners(Index first, const Array<Index>& parent) const {
  for_each("breccia::fracture::owners", work.families, OwnerLoop<D>{map, work, first, parent});
}

template <int D>
void Stars<D>::relabel(const CornerMass<D>& corner_mass, const Array<double>& node_mass,
                       const Array<std::uint32_t>& flags, std::uint32_t bit) const {
  for_each("breccia::fracture::relabel", work.families,
           RelabelLoop<D>{map, work, corner_mass, node_mass, flags, bit});
}

template struct StarWork<2>;
template struct StarWork<3>;
template struct Stars<2>;
template struct Stars<3>;

}  // namespace breccia
