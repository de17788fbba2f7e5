#pragma once
#include "comm/halo.hpp"
#include "comm/partition.hpp"
#include "loops/stable_step.hpp"
#include "mesh/part.hpp"
#include "step/clock.hpp"
#include "step/model.hpp"
#include "step/plan.hpp"

#include <vector>

namespace breccia {

/// A scene dealt out to ranks (ALGORITHMS A-9): which elements this rank owns, which it knows as
/// ghosts, and what neighbours tell one another in every step. Ghosts are computed like the rank's
/// own elements, from the same positions and in the same order, hence with the same bits.
template <int D>
class Parts {
 public:
  /// Cuts the whole model. Throws Error on all ranks when there are too many of them.
  Parts(const World& world, const Model<D>& whole);
  /// The same elements for each rank, but what is around them now, after things have moved.
  Parts(const World& world, const Model<D>& whole, Partition partition);

  /// The model of this rank: mesh, blocks, room in the store.
  void fill(Model<D>& local);
  /// Exchanges of the fields that tasks read with ghosts; before the plan is finished.
  void connect(Model<D>& local, Plan& plan);
  /// After nodes have split, on whatever rank, and before the first step. Collective.
  void renew(const Model<D>& local);

  /// What contact hands over from interfaces that others know all about; after a release.
  void bring_slip(const Model<D>& local);
  /// Whether things may have moved so far that a rank needs to know other elements; to be asked in
  /// every step. Collective now and then.
  bool outdated(const Model<D>& local, const Clock& clock);

  /// The smallest step of all ranks, with whose it is. Collective.
  StableStep least(const StableStep& mine) const;

  const Partition& partition() const { return partition_; }
  const World& world() const { return *world_; }
  std::size_t bytes() const;
  /// Bytes that this rank has sent so far.
  std::int64_t sent() const { return nodes_.sent() + faces_.sent(); }
  int neighbours() const { return nodes_.neighbours(); }

 private:
  std::vector<Index> known_elements(const Model<D>& whole);
  void own_families(const Model<D>& whole);
  void list_faces(const Model<D>& local);

  const World* world_;
  const Model<D>* whole_;  ///< while the model is made
  Partition partition_;
  MeshPart<D> part_;
  std::vector<int> family_owner_;
  Halo nodes_, faces_;
  std::vector<std::vector<Index>> corners_out_, nodes_in_;  ///< per rank
  Array<Index> nodes_out_;
  Index listed_ = 0;  ///< nodes that are in the lists
  double reach_ = 0;  ///< m, how far around its elements a rank knew all others when it was made
  double way_ = 0;    ///< m, that nothing has surpassed since
  double speed_ = 0, seen_ = 0;  ///< largest speed at the last look and its time, m/s and s
  std::int64_t next_look_ = 0;
};

extern template class Parts<2>;
extern template class Parts<3>;

}  // namespace breccia
