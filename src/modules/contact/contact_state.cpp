// What of the contact lists goes into a checkpoint, and what memory they take.
#include "loops/list_tools.hpp"
#include "modules/contact/contact_lists.hpp"

#include <algorithm>

namespace breccia {

namespace {

template <class... Views>
std::size_t memory_of(const Views&... views) {
  return (std::size_t{0} + ... + (views.span() * sizeof(typename Views::value_type)));
}

/// A view of rows on the host, whose numbers go into a list and come out of it.
template <class View>
class HostTable {
 public:
  explicit HostTable(const View& view)
      : view_(view), host_(Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{}, view)) {
    for (unsigned r = 1; r < View::rank; ++r) width_ *= view.extent(r);
  }
  void put(Index row, std::vector<double>& to) const {
    const auto* from = host_.data() + static_cast<std::size_t>(row) * width_;
    to.insert(to.end(), from, from + width_);
  }
  void take(Index row, const double*& from) {
    auto* to = host_.data() + static_cast<std::size_t>(row) * width_;
    for (std::size_t k = 0; k < width_; ++k)
      to[k] = static_cast<typename View::non_const_value_type>(*from++);
  }
  void finish() const { Kokkos::deep_copy(view_, host_); }

 private:
  View view_;
  typename View::host_mirror_type host_;
  std::size_t width_ = 1;
};

/// The rows of all targets, or of all facets.
template <int D>
auto target_tables(const ContactSurface<D>& s) {
  return std::make_tuple(HostTable(s.rim), HostTable(s.place), HostTable(s.depth),
                         HostTable(s.bubble), HostTable(s.slope));
}
template <int D>
auto facet_tables(const ContactSurface<D>& s) {
  return std::make_tuple(HostTable(s.area), HostTable(s.height));
}

/// Number of an element in this rank's part, or none.
Index element_here(const Part& part, Index element) {
  if (part.whole()) return element;
  const auto found = std::lower_bound(part.element.begin(), part.element.end(), element);
  const bool there = found != part.element.end() && *found == element;
  return there ? static_cast<Index>(found - part.element.begin()) : kNone;
}

/// Rows of a list whose elements are known here, by ascending number: the first of a row is
/// `per_element` times the element and a rest.
using KeptRows = std::vector<std::pair<Index, const double*>>;

void keep(const double* row, Index per_element, const Part& part, KeptRows& rows) {
  const auto number = static_cast<Index>(row[0]);
  const Index e = element_here(part, number / per_element);
  if (e != kNone) rows.emplace_back(e * per_element + number % per_element, row);
}

KeptRows kept_rows(const std::vector<double>& list, std::size_t width, Index per_element,
                   const Part& part) {
  KeptRows rows;
  for (std::size_t at = 0; at < list.size(); at += width) keep(&list[at], per_element, part, rows);
  std::sort(rows.begin(), rows.end());
  return rows;
}

Index place_of(const std::vector<Index>& list, Index number) {
  const auto found = std::lower_bound(list.begin(), list.end(), number);
  return found != list.end() && *found == number ? static_cast<Index>(found - list.begin()) : kNone;
}

}  // namespace

/// Lists depend on when they were made, so they are kept and not made anew.
template <int D>
void ContactLists<D>::archive(Archive& archive) {
  archive.integer("contact.layers", layers_);
  archive.integer("contact.releases", releases_);
  archive.integer("contact.seen_releases", seen_releases_);
  archive.integer("contact.patience", patience_);
  archive.integer("contact.splits", splits_);
  archive.integer("contact.surface_splits", surface_splits_);
  std::vector<double> reach{skin_, chase_};
  archive.numbers("contact.reach", reach);
  skin_ = reach[0];
  chase_ = reach[1];
  archive.integer("contact.last_look", last_look_);
  archive.integer("contact.next_look", next_look_);
  flyers_.archive(archive);
  std::int64_t deeper = deeper_exist_ ? 1 : 0, jumped = jumped_ ? 1 : 0;
  archive.integer("contact.deeper_exist", deeper);
  archive.integer("contact.jumped", jumped);
  deeper_exist_ = deeper != 0;
  jumped_ = jumped != 0;
  make_signals();
  const auto signals = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{}, signals_.value);
  for (Index k = 0; k < ContactSignals::count; ++k) {
    std::int64_t value = signals(k);
    archive.total("contact.signal." + std::to_string(k), value);
    signals(k) = static_cast<Index>(value);
  }
  Kokkos::deep_copy(signals_.value, signals);
  std::vector<double> facets, targets, pairs;
  if (!archive.loading()) {
    give_surface(facets, targets);
    give_pairs(pairs);
  }
  archive.rows("contact.facets", facets);
  archive.rows("contact.targets", targets);
  archive.rows("contact.pairs", pairs);
  if (!archive.loading()) return;
  take_surface(facets, targets);
  take_pairs(pairs);
}

/// Rows by the numbers that elements have in the whole scene.
template <int D>
void ContactLists<D>::give_surface(std::vector<double>& facets,
                                   std::vector<double>& targets) const {
  const auto facet = to_host(surface_.facet, static_cast<std::size_t>(surface_.facets));
  const auto target = to_host(surface_.target, static_cast<std::size_t>(surface_.targets));
  const auto piece = to_host(surface_.piece, target.size());
  const auto of_facets = facet_tables(surface_);
  const auto of_targets = target_tables(surface_);
  for (Index i = 0; i < surface_.facets; ++i) {
    const Index f = facet[static_cast<std::size_t>(i)], e = f / (D + 1);
    if (!part_->owns_element(e)) continue;
    facets.push_back(part_->element_number(e) * (D + 1) + f % (D + 1));
    std::apply([&](const auto&... table) { (table.put(i, facets), ...); }, of_facets);
  }
  for (Index t = 0; t < surface_.targets; ++t) {
    const Index e = target[static_cast<std::size_t>(t)];
    if (!part_->owns_element(e)) continue;
    targets.push_back(part_->element_number(e));
    targets.push_back(piece[static_cast<std::size_t>(t)] == kNone ? 0 : 1);
    std::apply([&](const auto&... table) { (table.put(t, targets), ...); }, of_targets);
  }
}

template <int D>
void ContactLists<D>::take_surface(const std::vector<double>& facets,
                                   const std::vector<double>& targets) {
  constexpr std::size_t kTarget = 3 + (D + 1) * (2 * D + 1) + kChords<D>;
  const KeptRows facet_rows = kept_rows(facets, 3, D + 1, *part_);
  const KeptRows target_rows = kept_rows(targets, kTarget, 1, *part_);
  surface_.facets = static_cast<Index>(facet_rows.size());
  surface_.targets = static_cast<Index>(target_rows.size());
  make_room(surface_.area, surface_.facets);
  make_room(surface_.height, surface_.facets);
  make_room(surface_.rim, surface_.targets);
  make_room(surface_.place, surface_.targets);
  make_room(surface_.depth, surface_.targets);
  make_room(surface_.bubble, surface_.targets);
  make_room(surface_.slope, surface_.targets);
  auto of_facets = facet_tables(surface_);
  auto of_targets = target_tables(surface_);
  std::vector<Index> facet, facet_target, target, piece;
  for (const auto& [element, row] : target_rows) {
    const double* at = row + 2;
    std::apply([&](auto&... table) { (table.take(static_cast<Index>(target.size()), at), ...); },
               of_targets);
    target.push_back(element);
    piece.push_back(row[1] != 0 ? 0 : kNone);  // which one, `resume` finds out
  }
  for (const auto& [number, row] : facet_rows) {
    const double* at = row + 1;
    std::apply([&](auto&... table) { (table.take(static_cast<Index>(facet.size()), at), ...); },
               of_facets);
    facet.push_back(number);
    facet_target.push_back(place_of(target, number / (D + 1)));
  }
  const auto finish = [](const auto&... table) { (table.finish(), ...); };
  std::apply(finish, of_facets);
  std::apply(finish, of_targets);
  surface_.facet = to_device("breccia::contact::facet", facet);
  surface_.facet_target = to_device("breccia::contact::facet_target", facet_target);
  surface_.target = to_device("breccia::contact::target", target);
  surface_.piece = to_device("breccia::contact::piece", piece);
}

/// Per point: its number, how many candidates it has, their elements.
template <int D>
void ContactLists<D>::give_pairs(std::vector<double>& list) const {
  constexpr Index kElementPoints = kFacePoints<D> * (D + 1);
  const auto point = to_host(pairs_.point, static_cast<std::size_t>(pairs_.points));
  const auto begin = to_host(pairs_.pair_begin, point.empty() ? 0 : point.size() + 1);
  const auto target = to_host(pairs_.target, static_cast<std::size_t>(pairs_.pairs));
  const auto element = to_host(surface_.target, static_cast<std::size_t>(surface_.targets));
  for (std::size_t a = 0; a < point.size(); ++a) {
    const Index e = point[a] / kElementPoints;
    if (!part_->owns_element(e)) continue;
    list.push_back(part_->element_number(e) * kElementPoints + point[a] % kElementPoints);
    list.push_back(begin[a + 1] - begin[a]);
    for (Index p = begin[a]; p < begin[a + 1]; ++p)
      list.push_back(part_->element_number(
          element[static_cast<std::size_t>(target[static_cast<std::size_t>(p)])]));
  }
}

template <int D>
void ContactLists<D>::take_pairs(const std::vector<double>& list) {
  constexpr Index kElementPoints = kFacePoints<D> * (D + 1);
  KeptRows rows;
  for (std::size_t at = 0; at < list.size(); at += 2 + static_cast<std::size_t>(list[at + 1]))
    keep(&list[at], kElementPoints, *part_, rows);
  std::sort(rows.begin(), rows.end());
  const auto element = to_host(surface_.target, static_cast<std::size_t>(surface_.targets));
  const auto facets = to_host(surface_.facet, static_cast<std::size_t>(surface_.facets));
  std::vector<Index> point, facet, begin{0}, target;
  for (const auto& [number, row] : rows) {
    for (std::size_t k = 0; k < static_cast<std::size_t>(row[1]); ++k) {
      const Index e = element_here(*part_, static_cast<Index>(row[2 + k]));
      const Index t = e == kNone ? kNone : place_of(element, e);
      if (t != kNone) target.push_back(t);
    }
    if (static_cast<Index>(target.size()) == begin.back()) continue;
    point.push_back(number);
    begin.push_back(static_cast<Index>(target.size()));
    facet.push_back(place_of(facets, number / kFacePoints<D>));
  }
  pairs_.points = static_cast<Index>(point.size());
  pairs_.pairs = static_cast<Index>(target.size());
  pairs_.point = to_device("breccia::contact::point", point);
  pairs_.facet = to_device("breccia::contact::point_facet", facet);
  pairs_.pair_begin = to_device("breccia::contact::pair_begin", begin);
  pairs_.target = to_device("breccia::contact::pair_target", target);
}

template <int D>
std::size_t ContactLists<D>::bytes() const {
  const auto& s = surface_;
  const auto& p = pairs_;
  const auto& c = scratch_;
  const auto& b = search_scratch_;
  return flyers_.bytes() +
         memory_of(s.facet, s.facet_target, s.area, s.height, s.target, s.rim, s.piece, s.nodes,
                   s.place, s.depth, s.bubble, s.slope, old_facet_, free_facet_, known_, fresh_,
                   piece_, cut_, nodes_.node, nodes_.mark, nodes_.place) +
         memory_of(p.point, p.facet, p.pair_begin, p.target, p.own_begin, p.come_begin, p.come,
                   p.element, p.nodes, p.hit, p.pair_distance, p.pair_force, p.pair_weight,
                   p.point_force) +
         memory_of(point_.constants, point_.material, spare_.element, spare_.state, spare_.rubbed) +
         memory_of(c.surface, c.height, c.level, c.edge, c.chosen, c.ring, c.nearest, c.nearer,
                   c.bubble, c.depth, c.gradient) +
         memory_of(b.bins.begin, b.bins.fill, b.bins.tag, b.bins.target, b.bins.piece, b.bins.box,
                   b.count, b.first, b.active, b.kept, b.found_begin, b.found);
}

template void ContactLists<2>::archive(Archive&);
template void ContactLists<3>::archive(Archive&);
template std::size_t ContactLists<2>::bytes() const;
template std::size_t ContactLists<3>::bytes() const;

}  // namespace breccia
