#pragma once
#include "loops/element_stress.hpp"
#include "loops/interface_views.hpp"

namespace breccia {

/// What splitting looks at and changes. The star of a family is the stretch of the corner list that
/// belongs to it, sorted by node, then corner (ALGORITHMS ).
template <int D>
struct StarMap {
  FaceMap<D> faces;
  ConstArray<std::uint8_t> status;  ///< of faces; inserted ones no longer bond
  Connectivity<D> element_nodes;
  ConstRanges family_corners;
  Ranges node_corners;
  Array<Index> corner_list;

  KOKKOS_FUNCTION
  static Index element(Index corner) { return corner / (D + 1); }
  KOKKOS_FUNCTION
  static int local(Index corner) { return static_cast<int>(corner % (D + 1)); }
  /// Local face number m, counted without the one opposite local node a.
  KOKKOS_FUNCTION
  static int face_at(int a, int m) { return m < a ? m : m + 1; }
  KOKKOS_FUNCTION
  Index node(Index corner) const { return element_nodes(element(corner), local(corner)); }
};

/// Room for the stars of the touched families. A place is a corner of one of these stars; place
/// numbers inside a star count from its first corner in the list.
template <int D>
struct StarWork {
  Index families = 0;
  Array<Index> family;  ///< touched families, ascending
  Array<Index> begin;   ///< first place of each
  Array<Index> fresh;   ///< how many new nodes it needs, then the number of its first one
  Array<Index> root;    ///< first place of the place's component
  Array<Index> owner;   ///< node that the place gets
  Kokkos::View<Index* [D], Rows, Memory> link;  ///< place across each face, or none
  // Of the balance, one per component at its root, but for the weights.
  Kokkos::View<double* [D], Rows, Memory> weight;  ///< m2 of a corner to be activated, else 0
  Array<double> mass;
  Vectors<D> wanted, potential, residual, direction, image;

  /// Makes room for so many places.
  void reserve(Index places);
};

/// Mass of the corners of an element, kg; one that is being excavated loses it.
template <int D>
struct CornerMass {
  ElementStress<D> shape;
  ConstArray<double> density;  ///< per material, kg/m3

  KOKKOS_FUNCTION
  double operator()(Index e) const {
    const double carried = shape.share.extent(0) > 0 ? shape.share(e) : 1.0;
    return carried * density(shape.material(e)) * shape.volume(e) / (D + 1);
  }
};

/// The steps of splitting, each one launch over the touched families, which do not interfere.
template <int D>
struct Stars {
  StarMap<D> map;
  StarWork<D> work;

  /// Places the stars one after the other; returns the places.
  Index place() const;

  /// Components of each star, joined through faces that still bond, and how many new
  /// nodes they need: per old node the component with its smallest corner keeps the node.
  void find_components() const;

  /// Numbers the new nodes by family, then by smallest corner; returns how many.
  Index number_new_nodes() const;

  /// Writes the owner of each place; new node first + k is a copy of node parent(k).
  void name_owners(Index first, const Array<Index>& parent) const;

  /// Gives the corners of split families to their new nodes: connectivity, the stretch of the
  /// corner list, masses as sums over corners in ascending order; sets `bit` in the nodes' flags.
  void relabel(const CornerMass<D>& corner_mass, const Array<double>& node_mass,
               const Array<std::uint32_t>& flags, std::uint32_t bit) const;
};

extern template struct StarWork<2>;
extern template struct StarWork<3>;
extern template struct Stars<2>;
extern template struct Stars<3>;

}  // namespace breccia
