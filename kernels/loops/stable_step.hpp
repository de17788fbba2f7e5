#pragma once
#include "base/views.hpp"

namespace breccia {

/// Stable step of the leapfrog with the current geometry (ALGORITHMS ).
///
/// Element e has the bound omega_e^2 = c^2 (D + 1) sum_a 1 / h_a^2 with its present heights, raised
/// for stiffness-proportional damping xi by (sqrt(1 + xi^2) - xi)^-2. Pressed elements are stiffer
/// than their constants say: the tangent along a principal axis is (lambda + 2 mu - tau_i) / J, so
/// rho c^2 = lambda + 2 mu + max(0, -tau_min). Because the quadratic form of the whole is the sum
/// of those of its parts, the largest rate of the assembly is at most
///   max over nodes of ( sum_e omega_e^2 m_e / m_n + s_n / m_n ),
/// m_e the element's share of the nodal mass m_n, s_n twice the stiffness of the springs at n.
/// An element that is being excavated loses stiffness and mass alike; one that is gone has neither.
template <int D>
struct StableStepIn {
  Index elements, nodes;
  ConstConnectivity<D> element_nodes;
  ConstVectors<D> x, v;
  ConstMatrices<D> reference;
  Kokkos::View<const Index*, Memory> material;
  ConstVectors<2> lame;                         ///< lambda, mu per material, Pa
  Kokkos::View<const double*, Memory> damping;  ///< per material
  ConstRanges corners;
  Kokkos::View<const Index*, Memory> corner_list;
  Kokkos::View<const double*, Memory> mass;
  Kokkos::View<const double*, Memory> stiffness;  ///< per node, N/m; empty: no springs
  ConstFullTensors<D> stress;                     ///< Cauchy, Pa; empty: from the shapes
  Kokkos::View<const double*, Memory> modulus;    ///< P-wave modulus now, Pa; 0 or empty: by lame
  Kokkos::View<const double*, Memory> share;      ///< of its stiffness that is left; empty: all
  double thickness;
  double factor_bulk, factor_springs;  ///< shares of the bound that are used
  Array<double> rate;                  ///< one per element, N/m
  bool renew_rates;                    ///< false: the shapes have hardly changed since `rate`
};

struct StableStep {
  double dt = 0;   ///< s
  Index node = 0;  ///< node that sets it
  bool by_springs = false;
  /// Largest rate of deformation of an element, 1/s, where the shapes were looked at; else 0.
  double strain_rate = 0;
  int rank = 0;  ///< whose node it is
};

template <int D>
StableStep stable_step(const StableStepIn<D>& in);

extern template StableStep stable_step<2>(const StableStepIn<2>&);
extern template StableStep stable_step<3>(const StableStepIn<3>&);

}  // namespace breccia
