#include "modules/gravity/gravity.hpp"

namespace breccia {

template <int D>
void Gravity<D>::bind(Model<D>& model) {
  const Settings& section = model.scene->at("gravity");
  const std::vector<double>& acceleration = section.vector("acceleration");
  for (int d = 0; d < D; ++d) full_[d] = acceleration[static_cast<std::size_t>(d)];
  if (section.has("ramp")) ramp_.ramp = section.number("ramp");
  model.gravity = full_;
}

template <int D>
void Gravity<D>::enlist(Model<D>& model, Plan& plan) {
  if (!model.scene->at("gravity").has("ramp")) return;
  plan.add(Stage::node_force, "gravity::ramp", key(), [this, &model](const Clock& clock) {
    const Kokkos::View<const double* [2], Kokkos::HostSpace> no_table;
    model.gravity = full_ * ramp_.factor(clock.time, no_table);
  });
}

template class Gravity<2>;
template class Gravity<3>;

}  // namespace breccia
