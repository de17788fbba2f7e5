#pragma once
#include "loops/boundary.hpp"
#include "step/module.hpp"

#include <map>

namespace breccia {

/// Prescribed motions and surface loads: every [[boundary]] of the scene.
template <int D>
class Boundary final : public Module<D> {
 public:
  static bool wanted(const Settings& scene) { return !scene.list("boundary").empty(); }
  std::string key() const override { return "boundary"; }
  void declare(Model<D>& model) override;
  void bind(Model<D>& model) override;
  void resume(Model<D>& model) override;
  void enlist(Model<D>& model, Plan& plan) override;

 private:
  /// Which law moves each component of a node; -1: none.
  using Sources = std::array<Index, D>;

  void read(const Model<D>& model);
  void read_laws(const Model<D>& model);
  void hold(const Model<D>& model, const Settings& section, Index law, const Region& region);
  void load(const Model<D>& model, Index law, const Region& region, const Settings& section);
  void make_rows(std::vector<Index>& row_of_node);
  void make_faces();

  bool moves_ = false, loads_ = false;
  std::vector<BoundaryLaw<D>> laws_;
  std::vector<std::array<double, 2>> tables_;
  std::vector<Sources> node_sources_;                    ///< per node, while reading
  std::map<ElementFace, std::vector<Index>> face_laws_;  ///< while reading
  std::map<ElementFace, double> face_area_;
  std::vector<Sources> rows_;
  BoundaryMotionIn<D> motion_;
  SurfaceLoadIn<D> load_;
};

}  // namespace breccia
