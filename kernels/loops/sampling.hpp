#pragma once
#include "base/sums.hpp"
#include "base/views.hpp"
#include "loops/element_stress.hpp"

namespace breccia {

/// Weighted sum of a node vector over listed nodes, in list order.
template <int D>
Vec<D> sample(const ConstVectors<D>& field, const Array<Index>& nodes,
              const Array<double>& weights);

/// Where in the material a stress is wanted: barycentric shares of the corners of an element.
template <int D>
struct StressPoint {
  Index element;
  Kokkos::Array<double, D + 1> shares;
};

/// Cauchy stress at a point, Pa. The stress of a simplex is constant and right at its centroid
/// only;
/// the averages over the elements around each corner, weighted by volume, vary linearly between
/// the corners and are of second order inside a mesh. Only elements of the point's own material
/// count, for stress may jump from one to the next, and of what is excavated what is left.
template <int D>
Sym<D> sample_stress(const ElementStress<D>& stress, const ConstRanges& corners,
                     const Array<Index>& corner_list, const StressPoint<D>& at);

extern template Sym<2> sample_stress<2>(const ElementStress<2>&, const ConstRanges&,
                                        const Array<Index>&, const StressPoint<2>&);
extern template Sym<3> sample_stress<3>(const ElementStress<3>&, const ConstRanges&,
                                        const Array<Index>&, const StressPoint<3>&);
extern template Vec<2> sample<2>(const ConstVectors<2>&, const Array<Index>&, const Array<double>&);
extern template Vec<3> sample<3>(const ConstVectors<3>&, const Array<Index>&, const Array<double>&);

}  // namespace breccia
