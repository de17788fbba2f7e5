#include "scene/part_pictures.hpp"

#include <cstring>

namespace breccia {

namespace {

template <class T>
std::vector<char> bytes_of(const std::vector<T>& values) {
  std::vector<char> bytes(values.size() * sizeof(T));
  std::memcpy(bytes.data(), values.data(), bytes.size());
  return bytes;
}

template <class T>
std::vector<T> values_of(const std::vector<char>& bytes) {
  std::vector<T> values(bytes.size() / sizeof(T));
  std::memcpy(values.data(), bytes.data(), bytes.size());
  return values;
}

/// Nodes that this rank owns, and one corner of each by its number in the whole scene.
struct OwnNodes {
  std::vector<Index> node, corner;

  template <int D>
  explicit OwnNodes(const Model<D>& model) {
    const auto mass = to_host(model.store.template get<NodeMass>(), model.nodes());
    const auto range = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{},
                                                           model.store.template get<NodeCorners>());
    const auto list = to_host(model.store.template get<CornerList>(),
                              model.store.template get<CornerList>().extent(0));
    for (Index n = 0; n < model.nodes(); ++n) {
      if (!(mass[static_cast<std::size_t>(n)] > 0)) continue;
      const Index c = list[static_cast<std::size_t>(range(n, 0))];
      node.push_back(n);
      corner.push_back(model.part.element_number(c / (D + 1)) * (D + 1) + c % (D + 1));
    }
  }
};

template <int D>
void collect_field(const World& world, const OwnNodes& own, Simulation<D>* whole,
                   PictureField& field) {
  const auto width = static_cast<std::size_t>(field.components);
  std::vector<double> values;
  for (const Index n : own.node)
    values.insert(values.end(), &field.values[static_cast<std::size_t>(n) * width],
                  &field.values[static_cast<std::size_t>(n) * width] + width);
  const auto corners = world.collect(bytes_of(own.corner)), rows = world.collect(bytes_of(values));
  if (whole == nullptr) return;
  const auto nodes = Kokkos::create_mirror_view_and_copy(
      Kokkos::HostSpace{}, whole->model().store.template get<ElementNodes<D>>());
  field.values.assign(static_cast<std::size_t>(whole->model().nodes()) * width, 0.0);
  for (std::size_t r = 0; r < corners.size(); ++r) {
    const auto corner = values_of<Index>(corners[r]);
    const auto row = values_of<double>(rows[r]);
    for (std::size_t i = 0; i < corner.size(); ++i) {
      const auto n = static_cast<std::size_t>(nodes(corner[i] / (D + 1), corner[i] % (D + 1)));
      std::copy_n(&row[i * width], width, &field.values[n * width]);
    }
  }
}

}  // namespace

template <int D>
void draw_parts(Simulation<D>& local, Simulation<D>* whole, Picture& picture) {
  const Part& part = local.model().part;
  for (const auto& module : local.modules())
    if (module->draws_forces()) module->draw(local.model(), picture);
  const OwnNodes own(local.model());
  for (PictureField& field : picture.node_fields) collect_field(*part.world, own, whole, field);
  std::vector<Touch> touches;
  for (Touch touch : picture.touches) {
    if (!part.owns_element(touch.element)) continue;
    touch.element = part.element_number(touch.element);
    touch.target = part.element_number(touch.target);
    touches.push_back(touch);
  }
  picture.touches.clear();
  for (const std::vector<char>& bytes : part.world->collect(bytes_of(touches)))
    for (const Touch& touch : values_of<Touch>(bytes)) picture.touches.push_back(touch);
}

template void draw_parts(Simulation<2>&, Simulation<2>*, Picture&);
template void draw_parts(Simulation<3>&, Simulation<3>*, Picture&);

}  // namespace breccia
