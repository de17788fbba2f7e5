#pragma once
#include "base/sums.hpp"
#include "base/views.hpp"

namespace breccia {

/// Weighted sum of a node vector over listed nodes, in list order.
template <int D>
Vec<D> sample(const ConstVectors<D>& field, const Array<Index>& nodes,
              const Array<double>& weights);

extern template Vec<2> sample<2>(const ConstVectors<2>&, const Array<Index>&, const Array<double>&);
extern template Vec<3> sample<3>(const ConstVectors<3>&, const Array<Index>&, const Array<double>&);

}  // namespace breccia
