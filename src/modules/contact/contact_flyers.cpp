#include "modules/contact/contact_flyers.hpp"

#include "core/disjoint_sets.hpp"
#include "fields/common_fields.hpp"
#include "loops/list_tools.hpp"

#include <algorithm>
#include <cmath>
#include <map>

namespace breccia {

namespace {

/// With more pieces that fly a search is the cheaper way.
constexpr std::size_t kMostFlying = 64;
/// Share of what is left that the speeds of now may use up before the next look.
constexpr double kRoom = 0.5;
/// Searches to wait for after looks that found nothing: twice as many each time, up to 2 to this.
constexpr std::int64_t kMostMisses = 5;

}  // namespace

template <int D>
void ContactFlyers<D>::start() {
  numbered_ = flies_ = false;
  seen_.clear();
}

template <int D>
bool ContactFlyers<D>::worth_a_look() {
  if (flies_ || wait_ == 0) return true;
  --wait_;
  return false;
}

/// Pieces hang together by faces that have not been released.
template <int D>
void ContactFlyers<D>::number(const Model<D>& model, const ContactSurface<D>& surface) {
  const Store& s = model.store;
  DisjointSets sets(static_cast<std::size_t>(model.elements()));
  std::vector<std::uint8_t> status;
  if (s.has<FaceStatus>()) status = to_host(s.get<FaceStatus>(), s.count(Entity::face));
  for (std::size_t f = 0; f < model.topology.shared.size(); ++f)
    if (status.empty() || status[f] != face_status::released)
      sets.join(model.topology.shared[f].left, model.topology.shared[f].right);
  std::map<Index, Index> number;
  std::vector<Index> of_target = to_host(surface.target, surface.targets);
  for (Index& t : of_target)
    t = number.emplace(sets.root(t), static_cast<Index>(number.size())).first->second;
  pieces_.count = static_cast<Index>(number.size());
  pieces_.of_target = to_device("breccia::contact::piece_of_target", of_target);
  make_room(pieces_.first, pieces_.count);
  make_room(pieces_.numbers, pieces_.count);
  make_room(reach_, pieces_.count);
  box_pieces(surface, pieces_);
  releases_ = model.releases;
  numbered_ = true;
  seen_.clear();
}

template <int D>
double ContactFlyers<D>::number_of(std::size_t piece, int column) const {
  return numbers_[piece * P::columns + static_cast<std::size_t>(column)];
}

/// Whether something went farther since the last look than that look has allowed for.
template <int D>
bool ContactFlyers<D>::late(const Clock& clock, double skin) const {
  for (std::size_t p = 0; p < static_cast<std::size_t>(pieces_.count); ++p) {
    const bool flew = !seen_.empty() && bound_[p] > 0;
    const double room = 0.5 * skin - std::sqrt(number_of(p, flew ? P::spread : P::way));
    if (-room > std::sqrt(number_of(p, flew ? P::turn : P::speed)) * clock.dt_before) return true;
    if (!flew) continue;
    double way = 0;
    for (int d = 0; d < D; ++d)
      way += std::pow(number_of(p, P::shift + d) - seen_[p * D + static_cast<std::size_t>(d)], 2);
    if (std::sqrt(way) > bound_[p]) return true;
  }
  return false;
}

/// Fills `reach_` for the next `time` seconds.
template <int D>
void ContactFlyers<D>::foresee(double time, double skin) {
  const auto count = static_cast<std::size_t>(pieces_.count);
  seen_.assign(count * D, 0.0);
  bound_.assign(count, 0.0);
  for (const Index f : flying_) {
    const auto p = static_cast<std::size_t>(f);
    bound_[p] = std::sqrt(number_of(p, P::speed)) * time / kRoom;
    for (int d = 0; d < D; ++d)
      seen_[p * D + static_cast<std::size_t>(d)] = number_of(p, P::shift + d);
  }
  const auto reach = Kokkos::create_mirror_view(reach_);
  for (std::size_t p = 0; p < count; ++p)
    for (int d = 0; d < D; ++d) {
      const double shift = seen_[p * D + static_cast<std::size_t>(d)];
      reach(p, d) = shift - bound_[p] - 0.5 * skin;
      reach(p, D + d) = shift + bound_[p] + 0.5 * skin;
    }
  Kokkos::deep_copy(reach_, reach);
}

template <int D>
FlyingLook ContactFlyers<D>::look(const Model<D>& model, const Clock& clock,
                                  const ContactSurface<D>& surface, double skin, std::int64_t since,
                                  double longest) {
  if (!numbered_ || releases_ != model.releases) number(model, surface);
  move_pieces<D>(surface, pieces_, model.store.template get<NodePosition<D>>(),
                 model.store.template get<NodeVelocity<D>>());
  const auto host = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{}, pieces_.numbers);
  numbers_.assign(host.data(), host.data() + static_cast<std::size_t>(pieces_.count) * P::columns);
  FlyingLook found;
  // After a restart or a release nobody knows which of them flew.
  const bool known = !flies_ || !seen_.empty();
  found.late = since > 1 && known && late(clock, skin);
  flying_.clear();
  double steps = longest;
  bool whole = true;
  for (std::size_t p = 0; p < static_cast<std::size_t>(pieces_.count); ++p) {
    const bool flies = std::sqrt(number_of(p, P::way)) >= 0.5 * skin;
    const double room = 0.5 * skin - std::sqrt(number_of(p, flies ? P::spread : P::way));
    const double speed = std::sqrt(number_of(p, flies ? P::turn : P::speed));
    if (flies) flying_.push_back(static_cast<Index>(p));
    if (!flies) found.speed = std::max(found.speed, speed);
    whole = whole && room > 0;
    if (speed * clock.dt > 0) steps = std::min(steps, kRoom * room / (speed * clock.dt));
  }
  bool clear = whole && !found.late && !flying_.empty() && flying_.size() <= kMostFlying;
  if (clear) {
    steps = std::floor(std::max(steps, 1.0));
    foresee(steps * clock.dt, skin);
    const Array<Index> list = to_device("breccia::contact::flying", flying_);
    clear = !pieces_near(surface, pieces_, reach_, list, static_cast<Index>(flying_.size()));
  }
  if (clear) {
    misses_ = 0;
    flies_ = true;
    found.steps = static_cast<std::int64_t>(steps);
  } else if (!flies_) {
    misses_ = std::min(misses_ + 1, kMostMisses);
    wait_ = (std::int64_t{1} << misses_) - 1;
  }
  return found;
}

template <int D>
std::size_t ContactFlyers<D>::bytes() const {
  return (pieces_.of_target.span() + pieces_.first.span()) * sizeof(Index) +
         (pieces_.numbers.span() + reach_.span()) * sizeof(double);
}

template <int D>
void ContactFlyers<D>::archive(Archive& archive) {
  std::int64_t flies = flies_ ? 1 : 0;
  archive.integer("contact.flies", flies);
  flies_ = flies != 0;
  archive.integer("contact.flying_misses", misses_);
  archive.integer("contact.flying_wait", wait_);
}

template class ContactFlyers<2>;
template class ContactFlyers<3>;

}  // namespace breccia
