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
  void archive(Archive& archive) override;

 private:
  /// What loads a face: the law of its course over time, its force of a fixed direction.
  struct FaceLoad {
    Index law;
    Vec<D> dead;                  ///< N
    double share = 1, delay = 0;  ///< of a face at a distance from the source, 1 and s
  };
  /// A pressure that also acts on faces that break open from where it acts.
  struct Spreading {
    Index law;
    std::vector<char> wet;  ///< per point of the mesh: touched by a face under pressure
  };
  /// Which law moves each component of a node; -1: none.
  using Sources = std::array<Index, D>;

  void read(const Model<D>& model);
  void read_laws(const Model<D>& model);
  void hold(const Model<D>& model, const Settings& section, Index law, const Region& region);
  void load(const Model<D>& model, Index law, const Region& region, const Settings& section);
  /// Force on a face at the full factor of its law, of a fixed direction, N.
  Vec<D> dead_force(const Model<D>& model, const Settings& section, const ElementFace& face) const;
  void let_out(const Model<D>& model, Index law, const ElementFace& face, const Settings& section);
  void make_absorbers(Model<D>& model);
  void start_spreading(const Model<D>& model, Index law, const Region& region,
                       const Settings& section);
  /// The load of a pressure on a face: what distance from its source leaves of it, and when.
  FaceLoad pressure_on(const Model<D>& model, Index law, const ElementFace& face) const;
  /// Takes in the released faces that hang together with faces under pressure; whether any came.
  bool spread(const Model<D>& model);
  bool spread(const Model<D>& model, Spreading& spreading);
  void mark_loaded(Model<D>& model) const;
  void make_rows(std::vector<Index>& row_of_node);
  void make_faces();

  bool moves_ = false, loads_ = false;
  Index constant_ = 0;  ///< number of the law that is one at all times
  std::vector<BoundaryLaw<D>> laws_;
  std::vector<std::array<double, 2>> tables_;
  std::vector<Sources> node_sources_;                        ///< per node, while reading
  std::map<ElementFace, std::vector<FaceLoad>> face_loads_;  ///< while reading
  std::vector<Spreading> spreading_;
  std::int64_t releases_seen_ = -1;
  std::map<ElementFace, Index> absorbing_;  ///< faces that let waves out, and their section
  std::vector<Sources> rows_;
  BoundaryMotionIn<D> motion_;
  SurfaceLoadIn<D> load_;
};

}  // namespace breccia
