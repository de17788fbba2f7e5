#include "scene/frame_builder.hpp"

namespace breccia {

template <int D>
FrameBuilder<D>::FrameBuilder(const Model<D>& model, const Clock& clock, const Picture& picture,
                              const Fragments& fragments)
    : time_(clock.time),
      step_(clock.step),
      picture_(picture),
      with_cracks_(model.store.template has<FaceStatus>()),
      body_(model.mesh.body.begin(), model.mesh.body.end()),
      fragment_(fragments.of_element.begin(), fragments.of_element.end()) {
  const auto host = [](const auto& view) {
    return Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{}, view);
  };
  const auto x = host(model.store.template get<NodePosition<D>>());
  const auto reference = host(model.store.template get<NodeReference<D>>());
  const auto v = host(model.store.template get<NodeVelocity<D>>());
  const auto nodes = host(model.store.template get<ElementNodes<D>>());
  for (Index n = 0; n < model.nodes(); ++n)
    for (int d = 0; d < D; ++d) {
      points_.push_back(x(n, d));
      displacement_.push_back(x(n, d) - reference(n, d));
      velocity_.push_back(v(n, d));
    }
  for (Index e = 0; e < model.elements(); ++e)
    for (int a = 0; a <= D; ++a) connectivity_.push_back(nodes(e, a));
  if (with_cracks_) add_cracks(picture.cracks);
  if (model.scene->has("contact")) chains_.emplace(D, picture.touches, fragments);
}

template <int D>
void FrameBuilder<D>::add_cracks(const std::vector<CrackFace>& cracks) {
  for (const CrackFace& face : cracks) {
    for (int c = 0; c < D; ++c) {
      crack_connectivity_.push_back(static_cast<std::int32_t>(crack_points_.size()) / D);
      for (int d = 0; d < D; ++d) crack_points_.push_back(face.point[c][d]);
    }
    damage_.push_back(face.damage);
    mode_.push_back(face.mode);
    opening_.push_back(face.opening);
    slip_.push_back(face.slip);
    status_.push_back(face.status);
    break_time_.push_back(face.time);
    energy_.push_back(face.energy / face.area);
  }
}

template <int D>
void FrameBuilder<D>::write(FrameSeries& series) const {
  Frame frame;
  frame.dimension = D;
  frame.points = points_;
  frame.cell = D == 2 ? CellType::triangle : CellType::tetrahedron;
  frame.connectivity = connectivity_;
  frame.time = time_;
  frame.step = step_;
  frame.point_arrays.push_back({"displacement", "m", D, std::span<const double>(displacement_)});
  frame.point_arrays.push_back({"velocity", "m/s", D, std::span<const double>(velocity_)});
  for (const PictureField& field : picture_.node_fields)
    frame.point_arrays.push_back(
        {field.name, field.unit, field.components, std::span<const double>(field.values)});
  frame.cell_arrays.push_back({"body", "1", 1, std::span<const std::int32_t>(body_)});
  frame.cell_arrays.push_back({"fragment", "1", 1, std::span<const std::int32_t>(fragment_)});
  for (const PictureField& field : picture_.element_fields)
    frame.cell_arrays.push_back(
        {field.name, field.unit, field.components, std::span<const double>(field.values)});
  std::vector<SideFrame> sides;
  if (with_cracks_) sides.push_back({SideKind::cracks, as_frame(cracks(), time_, step_)});
  if (chains_) sides.push_back({SideKind::contacts, chains_->frame(time_, step_)});
  series.write(frame, sides);
}

template <int D>
std::size_t FrameBuilder<D>::bytes() const {
  std::size_t numbers = points_.size() + displacement_.size() + velocity_.size();
  for (const auto* fields : {&picture_.node_fields, &picture_.element_fields})
    for (const PictureField& field : *fields) numbers += field.values.size();
  numbers += crack_points_.size() + damage_.size() * 6;
  const std::size_t labels = connectivity_.size() + body_.size() + fragment_.size() +
                             crack_connectivity_.size() + status_.size();
  return numbers * sizeof(double) + labels * sizeof(std::int32_t);
}

template <int D>
CrackFrame FrameBuilder<D>::cracks() const {
  CrackFrame cracks;
  cracks.dimension = D;
  cracks.points = crack_points_;
  cracks.connectivity = crack_connectivity_;
  cracks.damage = damage_;
  cracks.mode = mode_;
  cracks.opening = opening_;
  cracks.slip = slip_;
  cracks.status = status_;
  cracks.time = break_time_;
  cracks.energy = energy_;
  return cracks;
}

template class FrameBuilder<2>;
template class FrameBuilder<3>;

}  // namespace breccia
