#pragma once
#include "modules/fracture/crack_tips.hpp"
#include "modules/fracture/interface_laws.hpp"
#include "step/model.hpp"

namespace breccia {

/// Replaces bonded faces by interfaces and splits the nodes that this sets free (A-3.3, A-3.4,
/// Fields of nodes and interfaces may grow in here and nowhere else.
template <int D>
class Insertion {
 public:
  /// Room and tables on the device.
  void prepare(const Model<D>& model, const InterfaceLaws& laws);

  /// Inserts the faces whose law says so from the start and splits every node whose elements hang
  /// together at nothing but that node. Returns the number of new interfaces.
  Index start(Model<D>& model);

  /// The check of a step. Returns the number of new interfaces; nothing else has happened when
  /// it is zero.
  Index check(Model<D>& model);

  // The same in parts, between which the ranks tell one another what they have found.
  void mark_onset(Model<D>& model);    ///< writes FaceOnset
  void mark_at_tips(Model<D>& model);  ///< inserts what FaceOnset says, writes FaceTipOnset
  Index finish_check(Model<D>& model);

  /// Splits the nodes at faces that joined what is excavated to the rest.
  void split_rims(Model<D>& model);

  /// Flags of families whose interfaces have changed; `renew_stiffness` looks at these and clears
  /// them.
  const Array<std::uint8_t>& touched() const { return touched_; }
  void renew_stiffness(const Model<D>& model);

  /// Families that the last check, or the last renewal, has found changed.
  const Array<Index>& families() const { return work_.family; }
  Index family_count() const { return work_.families; }
  std::size_t bytes() const;

 private:
  Index start_faults(Model<D>& model);
  Index find_hot(Model<D>& model);
  Index insert_marked(Model<D>& model, const Array<std::uint8_t>& marks);
  TipOnsetIn<D> at_tips(const Model<D>& model) const;
  void insert(Model<D>& model, const Array<Index>& faces, Index count);
  void split(Model<D>& model);
  void list_touched(const Model<D>& model);
  void sum_stiffness(const Model<D>& model) const;
  void balance(const Model<D>& model, const Stars<D>& stars) const;
  void grow_nodes(Model<D>& model, Index needed) const;
  StarMap<D> star_map(const Store& store) const;

  InterfaceLaws table_;
  bool faults_started_ = true;
  Index inserted_ = 0;       ///< so far in this check
  bool faults_now_ = false;  ///< this check starts faults, on some rank
  Array<InterfaceLaw> laws_;
  Array<std::uint16_t> law_of_;  ///< of faces
  Array<InterfaceSide> sides_;
  Array<double> density_;
  Array<Index> hot_, found_, parent_;
  Array<std::uint8_t> mark_, touched_, strained_;
  StarWork<D> work_;
  CrackTips<D> tips_;
};

}  // namespace breccia
