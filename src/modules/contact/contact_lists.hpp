#pragma once
#include "loops/contact_force.hpp"
#include "loops/contact_release.hpp"
#include "loops/contact_search.hpp"
#include "loops/contact_surface.hpp"
#include "modules/contact/contact_flyers.hpp"
#include "step/clock.hpp"
#include "step/model.hpp"
#include "step/observation.hpp"

namespace breccia {

/// What a scene says of the lists.
struct ContactListKeys {
  double skin;      ///< least reach of the search, over the mean size of elements at surfaces
  bool by_parts;    ///< pairs of whole parts of faces, for the distributed potential
  bool at_corners;  ///< contact points are the faces' nodes
};

/// Surface, targets and candidate pairs of a model, and when they are made anew (ALGORITHMS,
/// at once when the sides of a released face meet, and before long while it is open;
/// otherwise before any node has moved by half the skin since the last search. Nodes are looked at
/// every step, or less often while they are slow. Pieces that fly clear of all others do not count.
template <int D>
class ContactLists {
 public:
  /// What this rank holds of the scene; it outlives the lists.
  void follow(const Part& part) { part_ = &part; }
  /// Free faces of the mesh.
  void prepare(const Model<D>& model, const ContactListKeys& keys);
  /// First surface and search; no point remembers anything.
  void start(Model<D>& model, const ContactStiffness<D>& rule);
  /// After `archive` has read the lists: what follows from them.
  void resume(Model<D>& model, const ContactStiffness<D>& rule);
  /// The search stage of a step.
  void look(Model<D>& model, const Clock& clock, const ContactStiffness<D>& rule);

  const ContactSurface<D>& surface() const { return surface_; }
  const ContactPairs<D>& pairs() const { return pairs_; }
  const ContactPointData<D>& point() const { return point_; }
  const ContactSignals& signals() const { return signals_; }
  /// Changes whenever pairs or their nodes have.
  std::int64_t version() const { return version_; }
  /// True once after the potential was computed anew.
  bool take_jump() { return std::exchange(jumped_, false); }
  static ContactHistory<D> history(const Model<D>& model);
  std::size_t bytes() const;
  void archive(Archive& archive);

 private:
  ReleasedFaces<D> faces(const Model<D>& model) const;
  void list_free_facets(const Model<D>& model);
  ContactWay way(const Model<D>& model);
  bool pressed(Model<D>& model, const Clock& clock);
  bool far(Model<D>& model, const Clock& clock, const ContactWay& now);
  bool deepen(Model<D>& model, const Clock& clock);
  void make_signals();
  void clear(Model<D>& model) const;
  void make_surface(Model<D>& model);
  double skin() const;
  void make_pairs(Model<D>& model, const ContactStiffness<D>& rule);
  void attach(Model<D>& model, const ContactStiffness<D>& rule);
  void carry(Model<D>& model, bool released);
  double mean_size() const;
  bool has_own_pairs() const;
  void find_pieces(const Model<D>& model);
  void give_surface(std::vector<double>& facets, std::vector<double>& targets) const;
  void take_surface(const std::vector<double>& facets, const std::vector<double>& targets);
  void give_pairs(std::vector<double>& list) const;
  void take_pairs(const std::vector<double>& list);

  const Part* part_ = nullptr;
  ContactSurface<D> surface_;
  ContactNodes<D> nodes_;  ///< of the last search and split, see listed_splits_
  ContactPairs<D> pairs_;
  ContactPointData<D> point_;
  ContactSignals signals_;
  ContactScratch<D> scratch_;
  ContactSearchScratch<D> search_scratch_;
  ContactFlyers<D> flyers_;
  ContactHistory<D> spare_;
  Array<Index> free_facet_, old_facet_;
  Array<Index> piece_;         ///< per element, see whole_pieces
  Array<std::uint8_t> cut_;    ///< per element that names a piece: a face of it was inserted
  Array<std::uint8_t> known_;  ///< per face: released, and part of the surface
  Array<Index> fresh_;         ///< released faces that are not part of it yet
  Index old_facets_ = 0, fresh_count_ = 0;
  double skin_share_ = 0, skin_ = 0;
  double size_ = 0;   ///< mean size of elements behind the surface, m
  double chase_ = 0;  ///< way of the fastest node in kSearchSteps steps, at the last look, m
  std::int64_t layers_ = 2, splits_ = 0, surface_splits_ = 0, listed_splits_ = -1, releases_ = 0;
  std::int64_t seen_releases_ = 0, patience_ = 0;  ///< last step in which open faces may wait
  std::int64_t last_look_ = 0, next_look_ = 0;
  std::int64_t version_ = 0;
  std::int64_t changes_ = 0;  ///< of Model::surface_changes that the surface knows
  bool deeper_exist_ = false, jumped_ = false, by_parts_ = false;
};

}  // namespace breccia
