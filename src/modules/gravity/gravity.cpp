#include "modules/gravity/gravity.hpp"

namespace breccia {

template <int D>
void Gravity<D>::bind(Model<D>& model) {
  const std::vector<double>& acceleration = model.scene->at("gravity").vector("acceleration");
  for (int d = 0; d < D; ++d) model.gravity[d] = acceleration[static_cast<std::size_t>(d)];
}

template class Gravity<2>;
template class Gravity<3>;

}  // namespace breccia
