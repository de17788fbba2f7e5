#include "modules/excavation/excavation.hpp"

#include "core/log.hpp"
#include "loops/excavation.hpp"
#include "modules/excavation/floating_pieces.hpp"
#include "step/stress_view.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace breccia {

namespace {

/// Share that is left at time t: 1 - s^2 (3 - 2 s), written so that nothing cancels near its end.
double share_at(double t, double at, double duration) {
  const double s = (t - at) / duration;
  if (s <= 0) return 1;
  if (s >= 1) return 0;
  return (1 - s) * (1 - s) * (1 + 2 * s);
}

void fill(const Array<double>& share, const Block& block, double value) {
  for_each(
      "breccia::excavation::share", block.begin, block.end,
      KOKKOS_LAMBDA(Index e) { share(e) = value; });
}

/// What is gone joins nothing any more: the rim's nodes may split.
void cut(const Array<std::uint8_t>& status, const Array<Index>& rim) {
  for_each(
      "breccia::excavation::cut", static_cast<Index>(rim.extent(0)),
      KOKKOS_LAMBDA(Index i) { status(rim(i)) = face_status::cut; });
}

/// 1 + the number of the excavation that an element belongs to, or 0.
template <int D>
std::vector<Index> marks(const Model<D>& model) {
  std::vector<Index> mark(model.mesh.element.size(), 0);
  for (const Block& block : model.blocks)
    std::fill(mark.begin() + block.begin, mark.begin() + block.end, block.excavation + 1);
  return mark;
}

}  // namespace

template <int D>
void ExcavationModule<D>::declare(Model<D>& model) {
  model.store.template add<ElementShare>(key());
  for (const Settings& section : model.scene->list("excavate")) {
    Course course;
    course.at = section.number("at");
    course.duration = section.number("release");
    courses_.push_back(course);
  }
  model.excavations.assign(courses_.size(), {});
  model_ = &model;
}

template <int D>
void ExcavationModule<D>::bind(Model<D>& model) {
  Kokkos::deep_copy(model.store.template get<ElementShare>(), 1.0);
  resume(model);
}

template <int D>
void ExcavationModule<D>::resume(Model<D>& model) {
  const std::vector<Index> mark = marks(model);
  std::vector<std::uint8_t> touched(model.mesh.point.size(), 0);
  for (std::size_t e = 0; e < mark.size(); ++e)
    if (mark[e] > 0)
      for (const Index n : model.mesh.element[e]) touched[static_cast<std::size_t>(n)] = 1;
  std::vector<Index> families;
  for (std::size_t n = 0; n < touched.size(); ++n)
    if (touched[n]) families.push_back(static_cast<Index>(n));
  families_ = to_device("breccia::excavation::families", families);
  rows_ = ChunkSums<1>("breccia::excavation::rows",
                       static_cast<std::size_t>(chunks_of(static_cast<Index>(families.size()))));
  std::vector<double> density;
  for (const Material& material : model.materials) density.push_back(material.density);
  density_ = to_device("breccia::excavation::density", density);

  std::vector<std::vector<Index>> rim(courses_.size());
  for (std::size_t f = 0; f < model.topology.shared.size(); ++f) {
    const SharedFace& face = model.topology.shared[f];
    const Index left = mark[static_cast<std::size_t>(face.left)];
    const Index right = mark[static_cast<std::size_t>(face.right)];
    if (left == right) continue;
    for (const Index side : {left, right})
      if (side > 0) rim[static_cast<std::size_t>(side - 1)].push_back(static_cast<Index>(f));
  }
  for (std::size_t i = 0; i < rim.size(); ++i)
    courses_[i].rim = to_device("breccia::excavation::rim", rim[i]);
}

template <int D>
void ExcavationModule<D>::enlist(Model<D>& model, Plan& plan) {
  plan.add(Stage::search, "excavation::release", key(),
           [this, &model](const Clock& clock) { release(model, clock); })
      .template reading<NodeCorners, CornerList, ElementNodes<D>>()
      .template writing<ElementShare, NodeMass, NodeVelocity<D>>();
  plan.add(Stage::node_force, "excavation::book", key(),
           [this, &model](const Clock&) { book_release(model); })
      .template reading<ElementShare>();
}

template <int D>
void ExcavationModule<D>::release(Model<D>& model, const Clock& clock) {
  if (clock.step == 0) warn_of_floating_pieces(model);
  bool changed = false;
  for (std::size_t i = 0; i < courses_.size(); ++i) {
    Excavation& now = model.excavations[i];
    Course& course = courses_[i];
    course.before = now.share;
    now.gone = now.share == 0;
    now.share = std::min(now.share, share_at(clock.time, course.at, course.duration));
    if (now.share == course.before) continue;
    changed = true;
    for (const Block& block : model.blocks)
      if (block.excavation == static_cast<Index>(i))
        fill(model.store.template get<ElementShare>(), block, now.share);
    if (now.share == 0 && model.store.template has<FaceStatus>())
      cut(model.store.template get<FaceStatus>(), course.rim);
    if (now.share == 0 || course.before == 1) ++model.surface_changes;
  }
  if (changed) take_masses(model);
}

template <int D>
void ExcavationModule<D>::take_masses(Model<D>& model) const {
  const Store& s = model.store;
  const ExcavatedMass<D> in{families_,
                            s.get<FamilyCorners>(),
                            s.get<CornerList>(),
                            s.get<ElementNodes<D>>(),
                            {stress_of(model), density_},
                            s.get_or_empty<NodeAddedMass>()};
  model.left_with_mass += take_mass(in, s.get<NodeMass>(), s.get<NodeVelocity<D>>(), rows_);
}

/// What the elements of an excavation would store if they carried all of their stress, J; -1 where
/// nothing of it is left to tell.
template <int D>
double ExcavationModule<D>::whole_energy(const Model<D>& model, std::size_t number) const {
  const double share = model.excavations[number].share;
  if (!(share > 0)) return -1;
  double stored = 0;
  for (std::size_t b = 0; b < model.blocks.size(); ++b)
    if (model.blocks[b].excavation == static_cast<Index>(number)) stored += model.stored_in(b);
  return stored / share;
}

// The share s falls while the elements' energy s W changes by s dW + W ds: the first part is the
// work of their forces, the second is gone. Both by the rule of trapezes, as the leapfrog's.
template <int D>
void ExcavationModule<D>::book_release(Model<D>& model) {
  for (std::size_t i = 0; i < courses_.size(); ++i) {
    Course& course = courses_[i];
    const double share = model.excavations[i].share;
    if (share == course.before) continue;
    const double now = whole_energy(model, i);
    const double last = course.energy < 0 ? now : course.energy;
    taken_ += 0.5 * ((now < 0 ? last : now) + last) * (course.before - share);
    course.energy = now;
  }
}

template <int D>
void ExcavationModule<D>::book(Model<D>& model, Ledger& ledger) const {
  ledger.add("EXCAVATED", EnergyKind::dissipated, taken_ + model.left_with_mass);
}

template <int D>
void ExcavationModule<D>::draw(Model<D>& model, Picture& picture) const {
  PictureField present{"present", "1", 1, std::vector<double>(model.mesh.element.size(), 1.0)};
  for (const Block& block : model.blocks)
    if (block.excavation != kNone)
      std::fill(present.values.begin() + block.begin, present.values.begin() + block.end,
                model.excavations[static_cast<std::size_t>(block.excavation)].share);
  picture.element_fields.push_back(std::move(present));
}

template <int D>
void ExcavationModule<D>::warn_of_floating_pieces(const Model<D>& model) const {
  const std::vector<Index> mark = marks(model);
  const auto flags = to_host(model.store.template get<NodeFlags>(), model.nodes());
  const auto family = to_host(model.store.template get<NodeFamily>(), model.nodes());
  std::vector<std::uint8_t> held(model.mesh.point.size(), 0);
  for (std::size_t n = 0; n < flags.size(); ++n)
    if ((flags[n] & (node_flag::fixed_any | node_flag::absorb)) != 0)
      held[static_cast<std::size_t>(family[n])] = 1;
  for (const FloatingPiece& piece : floating_pieces(model.mesh, model.topology, mark, held)) {
    std::string place;
    for (int d = 0; d < D; ++d) place += fmt::format("{}{:.6g}", d ? ", " : "", piece.place[d]);
    log::warning(
        fmt::format("the excavation leaves a piece of {} elements and {:.4g} {} at ({}) m that "
                    "nothing holds any more: it may fall or fly away",
                    piece.elements, piece.volume, D == 2 ? "m2" : "m3", place));
  }
}

template <int D>
std::size_t ExcavationModule<D>::bytes() const {
  std::size_t rims = 0;
  for (const Course& course : courses_) rims += course.rim.span();
  return (families_.span() + rims) * sizeof(Index) +
         (density_.span() + rows_.span()) * sizeof(double);
}

template <int D>
void ExcavationModule<D>::archive(Archive& archive) {
  for (std::size_t i = 0; i < courses_.size(); ++i) {
    const std::string name = fmt::format("excavation.{}.", i);
    Excavation& now = model_->excavations[i];
    archive.number(name + "share", now.share);
    std::int64_t gone = now.gone ? 1 : 0;
    archive.integer(name + "gone", gone);
    now.gone = gone != 0;
    archive.number(name + "energy", courses_[i].energy);
  }
  archive.number("excavation.taken", taken_);
  archive.number("excavation.left_with_mass", model_->left_with_mass);
  archive.integer("excavation.surface_changes", model_->surface_changes);
}

template class ExcavationModule<2>;
template class ExcavationModule<3>;

}  // namespace breccia
