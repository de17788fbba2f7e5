// What of the contact lists goes into a checkpoint, and what memory they take.
#include "modules/contact/contact_lists.hpp"

namespace breccia {

namespace {

/// The first n rows of a view of numbers, as they are.
template <class View>
void archive_rows(Archive& archive, const std::string& name, View& view, Index n) {
  using Number = typename View::non_const_value_type;
  std::size_t per_row = 1;
  for (unsigned r = 1; r < View::rank; ++r) per_row *= view.extent(r);
  std::vector<std::conditional_t<std::is_same_v<Number, double>, double, std::int64_t>> values;
  if (!archive.loading()) {
    const auto host = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{}, view);
    values.assign(host.data(), host.data() + static_cast<std::size_t>(n) * per_row);
  }
  if constexpr (std::is_same_v<Number, double>)
    archive.numbers(name, values);
  else
    archive.integers(name, values);
  if (!archive.loading()) return;
  view = View("breccia::contact::list", static_cast<std::size_t>(n));
  const auto host = Kokkos::create_mirror_view(view);
  for (std::size_t i = 0; i < values.size(); ++i) host.data()[i] = static_cast<Number>(values[i]);
  Kokkos::deep_copy(view, host);
}

void archive_count(Archive& archive, const std::string& name, Index& count) {
  std::int64_t wide = count;
  archive.integer(name, wide);
  count = static_cast<Index>(wide);
}

template <class... Views>
std::size_t memory_of(const Views&... views) {
  return (std::size_t{0} + ... + (views.span() * sizeof(typename Views::value_type)));
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
  std::int64_t deeper = deeper_exist_ ? 1 : 0;
  archive.integer("contact.deeper_exist", deeper);
  deeper_exist_ = deeper != 0;
  archive_rows(archive, "contact.signals", signals_.value, ContactSignals::count);

  archive_count(archive, "contact.facets", surface_.facets);
  archive_count(archive, "contact.targets", surface_.targets);
  archive_rows(archive, "contact.facet", surface_.facet, surface_.facets);
  archive_rows(archive, "contact.facet_target", surface_.facet_target, surface_.facets);
  archive_rows(archive, "contact.area", surface_.area, surface_.facets);
  archive_rows(archive, "contact.height", surface_.height, surface_.facets);
  archive_rows(archive, "contact.target", surface_.target, surface_.targets);
  archive_rows(archive, "contact.piece", surface_.piece, surface_.targets);
  archive_rows(archive, "contact.rim", surface_.rim, surface_.targets);
  archive_rows(archive, "contact.place", surface_.place, surface_.targets);
  archive_rows(archive, "contact.depth", surface_.depth, surface_.targets);
  archive_rows(archive, "contact.bubble", surface_.bubble, surface_.targets);
  archive_rows(archive, "contact.slope", surface_.slope, surface_.targets);

  archive_count(archive, "contact.points", pairs_.points);
  archive_count(archive, "contact.pairs", pairs_.pairs);
  archive_rows(archive, "contact.point", pairs_.point, pairs_.points);
  archive_rows(archive, "contact.point_facet", pairs_.facet, pairs_.points);
  archive_rows(archive, "contact.pair_begin", pairs_.pair_begin, pairs_.points + 1);
  archive_rows(archive, "contact.pair_target", pairs_.target, pairs_.pairs);
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
