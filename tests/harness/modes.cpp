#include "harness/modes.hpp"

#include <Eigen/Eigenvalues>

namespace breccia {

template <int D>
double largest_rate(SceneWorld<D>& world) {
  const auto position = world.template host<NodePosition<D>>();
  const auto mass = world.template host<NodeMass>();
  const auto nodes = static_cast<int>(world.model().nodes());
  const auto points = world.model().mesh.point;
  // A millionth of an edge: the error of the central difference and round-off are both 1e-10.
  const auto& first = world.model().mesh.element.front();
  const double shift = 1e-6 * norm(vector_of<D>(points[static_cast<std::size_t>(first[0])]) -
                                   vector_of<D>(points[static_cast<std::size_t>(first[1])]));
  Eigen::MatrixXd stiffness(nodes * D, nodes * D);
  const auto forces_at = [&](int n, int d, double by) {
    const double kept = position(n, d);
    position(n, d) = kept + by;
    world.template put<NodePosition<D>>(position);
    evaluate_forces(world, Clock{});
    position(n, d) = kept;
    const auto all = nodal_forces<ElementForce<D>>(world);
    Eigen::VectorXd f(nodes * D);
    for (int m = 0; m < nodes; ++m)
      for (int i = 0; i < D; ++i) f[m * D + i] = all[static_cast<std::size_t>(m)][i];
    return f;
  };
  for (int n = 0; n < nodes; ++n)
    for (int d = 0; d < D; ++d)
      stiffness.col(n * D + d) = (forces_at(n, d, -shift) - forces_at(n, d, shift)) / (2 * shift);
  world.template put<NodePosition<D>>(position);
  for (int i = 0; i < nodes * D; ++i)
    for (int j = 0; j < nodes * D; ++j) stiffness(i, j) /= std::sqrt(mass(i / D) * mass(j / D));
  const Eigen::MatrixXd symmetric = 0.5 * (stiffness + stiffness.transpose());
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(symmetric, Eigen::EigenvaluesOnly);
  return std::sqrt(solver.eigenvalues().maxCoeff());
}

template double largest_rate<2>(SceneWorld<2>&);
template double largest_rate<3>(SceneWorld<3>&);

}  // namespace breccia
