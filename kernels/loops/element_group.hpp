#pragma once
#include "base/composite.hpp"
#include "loops/element.hpp"

namespace breccia {

/// Local nodes of a group of sub-elements that are computed together: a composite, or one simplex.
template <int D, int Group>
inline constexpr int kGroupNodes = Group == 1 ? D + 1 : composite_nodes<D, Group>;

template <int D, int Group>
KOKKOS_FORCEINLINE_FUNCTION
constexpr int group_node(int sub, int corner) {
  if constexpr (Group == 1)
    return corner;
  else
    return composite_node<D, Group>(sub, corner);
}

template <int D, int Group>
KOKKOS_FORCEINLINE_FUNCTION
constexpr CompositePlace group_place(int node) {
  if constexpr (Group == 1)
    return {0, node};
  else
    return composite_place<D, Group>(node);
}

/// The groups that one pack computes: lane l has group `first` + l of the block that begins with
/// element `begin`. Lanes behind the last group repeat it and write nothing.
template <int Group, class R>
struct GroupLanes {
  static constexpr int W = lanes<R>();
  static constexpr int kGroup = Group;
  Index begin, first, groups;
  const std::uint8_t* own;  ///< per element: 1 where sums count it; null: everywhere

  KOKKOS_FORCEINLINE_FUNCTION
  bool counts(int lane) const { return own == nullptr || own[element(lane, 0)] != 0; }
  KOKKOS_FORCEINLINE_FUNCTION
  int count() const { return first + W <= groups ? W : static_cast<int>(groups - first); }
  KOKKOS_FORCEINLINE_FUNCTION
  Index element(int lane, int sub) const {
    const Index group = first + lane < groups ? first + lane : groups - 1;
    return begin + group * Group + sub;
  }

  /// Element constants: side by side where groups are single elements (fields of elements have
  /// room for a whole pack behind the last one, scene/model_builder.cpp), else a stride apart.
  template <class Field, class... Place>
  KOKKOS_FORCEINLINE_FUNCTION
  R read(const Field& field, int sub, Place... place) const {
    if constexpr (Group == 1)
      return load<R>(&field(begin + first, place...));
    else
      return fill<R>([&](int l) { return field(element(l, sub), place...); });
  }
  template <class Field, class... Place>
  KOKKOS_FORCEINLINE_FUNCTION
  void write(const R& value, const Field& field, int sub, Place... place) const {
    double v[W];
    store(value, v);
    for (int l = 0; l < count(); ++l) field(element(l, sub), place...) = v[l];
  }

  /// Vectors of the groups' nodes; in single precision less that of the first one, the differences
  /// being taken in double.
  template <int D, class Nodes, class Field>
  KOKKOS_FORCEINLINE_FUNCTION
  void gather(const Nodes& nodes, const Field& field,
              Vec<D, R> (&to)[kGroupNodes<D, Group>]) const {
    if constexpr (kSingle<R>) {
      WideNodes<D> wide;
      gather_wide(nodes, field, wide);
      for (int a = 0; a < kGroupNodes<D, Group>; ++a)
        for (int d = 0; d < D; ++d) to[a][d] = narrow(wide.at[a][d]);
    } else {
      for (int a = 0; a < kGroupNodes<D, Group>; ++a) {
        Index n[W];
        numbers<D>(nodes, a, n);
        for (int d = 0; d < D; ++d) to[a][d] = fill<R>([&](int l) { return field(n[l], d); });
      }
    }
  }

  // In single precision: registers of doubles, two to a register of floats.
  using Wide = std::conditional_t<kIsPack<R>, HostPack, double>;
  static constexpr int kWide = lanes<Wide>(), kParts = kWide < W ? W / kWide : 1;

  /// Vectors of the groups' nodes less that of the first one.
  template <int D>
  struct WideNodes {
    Wide at[kGroupNodes<D, Group>][D][kParts];
  };

  template <int D, class Nodes, class Field>
  KOKKOS_FORCEINLINE_FUNCTION
  void gather_wide(const Nodes& nodes, const Field& field, WideNodes<D>& to) const {
    Wide origin[D][kParts];
    for (int a = 0; a < kGroupNodes<D, Group>; ++a) {
      Index n[W];
      numbers<D>(nodes, a, n);
      for (int d = 0; d < D; ++d)
        for (int p = 0; p < kParts; ++p) {
          const Wide value = fill<Wide>([&](int l) { return field(n[p * kWide + l], d); });
          if (a == 0) origin[d][p] = value;
          to.at[a][d][p] = value - origin[d][p];
        }
    }
  }

  template <int D>
  KOKKOS_FORCEINLINE_FUNCTION
  static Mat<D, Wide> wide_edges(const WideNodes<D>& x, int sub, int part) {
    Mat<D, Wide> g;
    for (int j = 0; j < D; ++j)
      for (int i = 0; i < D; ++i)
        g(i, j) = x.at[group_node<D, Group>(sub, j + 1)][i][part] -
                  x.at[group_node<D, Group>(sub, 0)][i][part];
    return g;
  }

  template <class Field, class... Place>
  KOKKOS_FORCEINLINE_FUNCTION
  Wide read_wide(const Field& field, int part, int sub, Place... place) const {
    if constexpr (Group == 1)
      return load<Wide>(&field(begin + first + part * kWide, place...));
    else
      return fill<Wide>([&](int l) { return field(element(part * kWide + l, sub), place...); });
  }

  KOKKOS_FORCEINLINE_FUNCTION
  static R narrow(const Wide (&wide)[kParts]) {
    double lane[W];
    for (int p = 0; p < kParts; ++p) store(wide[p], lane + p * kWide);
    return load<R>(static_cast<const double*>(lane));
  }

 private:
  /// Node numbers at local node a of the groups.
  template <int D, class Nodes>
  KOKKOS_FORCEINLINE_FUNCTION
  void numbers(const Nodes& nodes, int a, Index (&n)[W]) const {
    const CompositePlace place = group_place<D, Group>(a);
    for (int l = 0; l < W; ++l) n[l] = nodes(element(l, place.sub), place.corner);
  }
};

/// Edge matrix [a1 - a0, ...] of a sub-element from vectors of the group's nodes.
template <int D, int Group, class R>
KOKKOS_FORCEINLINE_FUNCTION
Mat<D, R> sub_edges(const Vec<D, R> (&a)[kGroupNodes<D, Group>], int sub) {
  Mat<D, R> g;
  for (int j = 0; j < D; ++j)
    for (int i = 0; i < D; ++i)
      g(i, j) = a[group_node<D, Group>(sub, j + 1)][i] - a[group_node<D, Group>(sub, 0)][i];
  return g;
}

}  // namespace breccia
