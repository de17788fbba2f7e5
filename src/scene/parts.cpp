#include "scene/parts.hpp"

#include "core/error.hpp"
#include "fields/interface_fields.hpp"
#include "mesh/composite.hpp"
#include "mesh/whole_pieces.hpp"
#include "modules/fracture/fracture_fields.hpp"
#include "scene/model_builder.hpp"

#include <algorithm>
#include <cmath>

namespace breccia {

namespace {

/// How far around its elements a rank knows others, over the widest skin of contact: two bodies may
/// come nearer to each other by the rest before it must look around again.
constexpr double kReach = 3;
/// Rings of elements around a contact target that its depth may depend on.
constexpr int kDepthRings = 6;
/// Steps between two looks at speeds, and how much they may grow in between.
constexpr std::int64_t kLook = 16;
constexpr double kCaution = 1.25;

template <int D>
std::vector<AxisBox<D>> boxes_of(const Model<D>& model) {
  const auto x = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{},
                                                     model.store.template get<NodePosition<D>>());
  const auto nodes = Kokkos::create_mirror_view_and_copy(
      Kokkos::HostSpace{}, model.store.template get<ElementNodes<D>>());
  std::vector<AxisBox<D>> boxes(model.mesh.element.size());
  for (Index e = 0; e < model.elements(); ++e)
    for (std::size_t d = 0; d < D; ++d) {
      AxisBox<D>& box = boxes[static_cast<std::size_t>(e)];
      box.low[d] = box.high[d] = x(nodes(e, 0), d);
      for (int a = 1; a <= D; ++a) {
        box.low[d] = std::min(box.low[d], x(nodes(e, a), d));
        box.high[d] = std::max(box.high[d], x(nodes(e, a), d));
      }
    }
  return boxes;
}

/// Elements that stay together: composites, and the elements of a rigid body.
template <int D>
std::vector<Index> clusters_of(const Model<D>& model) {
  std::vector<Index> cluster = composite_of_elements(model.mesh);
  std::vector<Index> of_body(model.mesh.body_names.size(), kNone);
  for (std::size_t e = 0; e < cluster.size(); ++e) {
    const Index body = model.mesh.body[e];
    if (!model.material_of_body(body).rigid) continue;
    Index& first = of_body[static_cast<std::size_t>(body)];
    if (first == kNone) first = cluster[e];
    cluster[e] = first;
  }
  std::vector<Index> number(cluster.size(), kNone);
  Index count = 0;
  for (Index& c : cluster) {
    Index& n = number[static_cast<std::size_t>(c)];
    if (n == kNone) n = count++;
    c = n;
  }
  return cluster;
}

/// All elements of the composites that some of them belong to.
template <int D>
std::vector<Index> whole_composites(const Mesh<D>& mesh, const std::vector<Index>& elements) {
  const std::vector<Index> composite = composite_of_elements(mesh);
  std::vector<std::uint8_t> chosen(mesh.element.size(), 0);
  for (const Index e : elements) chosen[static_cast<std::size_t>(composite[e])] = 1;
  std::vector<Index> all;
  for (Index e = 0; e < mesh.elements(); ++e)
    if (chosen[static_cast<std::size_t>(composite[e])]) all.push_back(e);
  return all;
}

/// Pieces of the whole scene that cannot touch themselves, numbered from 0 on.
template <int D>
void share_pieces(const Model<D>& whole, const std::vector<Index>& elements, Part& part) {
  std::vector<std::uint8_t> rigid;
  for (const Index body : whole.mesh.body) rigid.push_back(whole.material_of_body(body).rigid);
  std::vector<Index> piece = whole_pieces(whole.mesh, whole.topology, rigid);
  std::vector<Index> number(piece.size(), kNone);
  for (Index& p : piece) {
    if (p == kNone) continue;
    Index& n = number[static_cast<std::size_t>(p)];
    if (n == kNone) n = part.pieces++;
    p = n;
  }
  for (const Index e : elements) part.piece.push_back(piece[static_cast<std::size_t>(e)]);
}

struct NewNode {
  Index family, corner;  ///< the first of its corners
};

template <int D>
std::vector<NewNode> nodes_from(Index first, Index end, const Store& s) {
  const auto list =
      allocate<Array<NewNode>>("breccia::halo::new_nodes", static_cast<std::size_t>(end - first));
  const Ranges corners = s.get<NodeCorners>();
  const Array<Index> corner = s.get<CornerList>(), family = s.get<NodeFamily>();
  for_each(
      "breccia::halo::new_nodes", first, end, KOKKOS_LAMBDA(Index n) {
        list(n - first) = {family(n), corner(corners(n, 0))};
      });
  return to_host(list, static_cast<std::size_t>(end - first));
}

/// Place of a number in an ascending list.
Index place_in(const std::vector<Index>& list, Index number) {
  return static_cast<Index>(std::lower_bound(list.begin(), list.end(), number) - list.begin());
}

}  // namespace

namespace {

[[noreturn]] void refuse(const Settings& section, const std::string& key, const std::string& what) {
  throw section.error(key, what + " on one rank only so far",
                      "start one rank with more --threads (docs/ranks.md)");
}

/// What many ranks cannot do yet.
void refuse_on_many(const Settings& scene) {
  for (const Settings& body : scene.list("body"))
    if (body.flag("rigid")) refuse(body, "rigid", "rigid bodies move");
  for (const Settings& section : scene.list("excavate"))
    refuse(section, "", "a scene is excavated");
  for (const Settings& section : scene.list("boundary"))
    if (section.has("on_new_faces")) refuse(section, "on_new_faces", "a pressure spreads");
  if (scene.at("run").has("rest")) refuse(scene.at("run.rest"), "", "a scene is brought to rest");
  if (scene.has("contact") && scene.at("contact").text("force") == "distributed_potential")
    refuse(scene.at("contact"), "force", "the distributed potential works");
}

template <int D>
Partition cut(const World& world, const Model<D>& whole) {
  refuse_on_many(*whole.scene);
  try {
    return partition(whole.mesh, whole.topology, world.size(), clusters_of(whole));
  } catch (const Error& error) {
    throw Error("mpirun, " + std::to_string(world.size()) + " ranks", error.cause(),
                "start fewer ranks: elements, composites and rigid bodies stay in one piece");
  }
}

}  // namespace

template <int D>
Parts<D>::Parts(const World& world, const Model<D>& whole)
    : Parts(world, whole, cut(world, whole)) {}

template <int D>
Parts<D>::Parts(const World& world, const Model<D>& whole, Partition partition)
    : world_(&world),
      whole_(&whole),
      partition_(std::move(partition)),
      nodes_(world),
      faces_(world),
      corners_out_(static_cast<std::size_t>(world.size())),
      nodes_in_(corners_out_) {
  part_ = take_part(whole.mesh, whole.topology, known_elements(whole));
  own_families(whole);
}

template <int D>
std::vector<Index> Parts<D>::known_elements(const Model<D>& whole) {
  std::vector<Index> known;
  for (Index e = 0; e < whole.elements(); ++e)
    if (partition_.part[static_cast<std::size_t>(e)] == world_->rank()) known.push_back(e);
  const auto grow = [&](int rings) {
    known = whole_composites(whole.mesh, with_neighbours(whole.mesh, whole.topology, known, rings));
  };
  grow(1);
  if (!whole.scene->has("contact")) return known;
  // What may touch the elements so far; what may touch that; and as much around it as the depth of
  // a target depends on.
  reach_ = kReach * whole.part.skin;
  const std::vector<AxisBox<D>> boxes = boxes_of(whole);
  for (int layer = 0; layer < 2; ++layer) known = boxes_near<D>(boxes, known, reach_);
  grow(kDepthRings);
  return known;
}

template <int D>
bool Parts<D>::outdated(const Model<D>& local, const Clock& clock) {
  if (!(reach_ > 0) || clock.step < next_look_) return false;
  const Store& s = local.store;
  const auto v = s.get<NodeVelocity<D>>();
  const auto mass = s.get<NodeMass>();
  double fastest = 0;
  count_launch();
  Kokkos::parallel_reduce(
      "breccia::parts::fastest",
      Kokkos::RangePolicy<Exec, Kokkos::IndexType<Index>>(0, local.nodes()),
      KOKKOS_LAMBDA(Index n, double& most) {
        const double speed = mass(n) > 0 ? norm2(row<D>(v, n)) : 0.0;
        most = speed > most ? speed : most;
      },
      Kokkos::Max<double>(fastest));
  const double now = world_->largest(std::sqrt(fastest));
  if (next_look_ > 0) way_ += kCaution * std::max(now, speed_) * (clock.time - seen_);
  speed_ = now;
  seen_ = clock.time;
  next_look_ = clock.step + kLook;  // above zero from now on
  const double ahead = kCaution * now * static_cast<double>(kLook) * clock.dt;
  return 2 * (way_ + ahead) > reach_ - local.part.skin;
}

/// A family belongs to the rank of its first element, or to that of its rigid body.
template <int D>
void Parts<D>::own_families(const Model<D>& whole) {
  for (const Index family : part_.family) {
    Index decides = kNone;
    for (Index k = whole.topology.family_start[family]; k < whole.topology.family_start[family + 1];
         ++k) {
      const Index e = whole.topology.family_corner[k] / (D + 1);
      if (decides == kNone) decides = e;
      if (whole.material_of_body(whole.mesh.body[e]).rigid) decides = e;
    }
    family_owner_.push_back(partition_.part[static_cast<std::size_t>(decides)]);
  }
}

template <int D>
void Parts<D>::fill(Model<D>& local) {
  const Model<D>& whole = *whole_;
  local.scene = whole.scene;
  local.materials = whole.materials;
  local.body_material = whole.body_material;
  local.thickness = whole.thickness;
  local.plane_stress = whole.plane_stress;
  local.mixed = whole.mixed;
  local.gravity = whole.gravity;
  local.mesh = std::move(part_.mesh);
  local.topology = std::move(part_.topology);
  for (const Index e : part_.element) {
    if (!whole.initial_stress.empty()) local.initial_stress.push_back(whole.initial_stress[e]);
    if (!whole.axes.empty()) local.axes.push_back(whole.axes[e]);
    local.part.owns.push_back(partition_.part[e] == world_->rank() ? 1 : 0);
  }
  for (Block block : whole.blocks) {
    block.begin = place_in(part_.element, block.begin);
    block.end = place_in(part_.element, block.end);
    local.blocks.push_back(block);
  }
  if (local.scene->has("contact")) share_pieces(whole, part_.element, local.part);
  local.part.world = world_;
  local.part.element = part_.element;
  local.part.family = part_.family;
  local.part.face = part_.face;
  local.part.family_owner = family_owner_;
  local.part.own = to_device("breccia::part::own", local.part.owns);
  std::vector<std::uint8_t> sure;
  for (const SharedFace& face : local.topology.shared)
    sure.push_back(local.part.owns[face.left] | local.part.owns[face.right]);
  local.part.sure_face = to_device("breccia::part::sure_face", sure);
  size_store(local);
  whole_ = nullptr;
}

template <int D>
void Parts<D>::connect(Model<D>& local, Plan& plan) {
  const std::string x(NodePosition<D>::info.name), v(NodeVelocity<D>::info.name);
  plan.exchange_by({x, v}, [this, &local](const Clock&) {
    const Store& s = local.store;
    nodes_.exchange(nodes_out_, s.get<NodePosition<D>>(), s.get<NodeVelocity<D>>());
  });
  if (!local.store.template has<FaceStatus>()) return;
  list_faces(local);
  const auto bring = [&](auto field) {
    using Field = decltype(field);
    plan.exchange_by({std::string(Field::info.name)}, [this, &local](const Clock&) {
      faces_.exchange(faces_.out(), local.store.template get<Field>());
    });
  };
  bring(FaceLife{});
  bring(FaceOnset{});
  bring(FaceTipOnset{});
}

/// Who does not own one of a face's elements asks the owner of the left one.
template <int D>
void Parts<D>::list_faces(const Model<D>& local) {
  const auto ranks = static_cast<std::size_t>(world_->size());
  std::vector<std::vector<Index>> wanted(ranks), in(ranks);
  for (std::size_t f = 0; f < part_.face.size(); ++f) {
    const SharedFace& face = local.topology.shared[f];
    if (local.part.owns[face.left] != 0 || local.part.owns[face.right] != 0) continue;
    const auto owner = static_cast<std::size_t>(
        partition_.part[part_.element[static_cast<std::size_t>(face.left)]]);
    wanted[owner].push_back(part_.face[f]);
    in[owner].push_back(static_cast<Index>(f));
  }
  std::vector<std::vector<Index>> out = ask(*world_, wanted);
  for (std::vector<Index>& list : out)
    for (Index& f : list) f = place_in(part_.face, f);
  faces_.set(out, in);
}

/// New nodes of others join the lists by the first of their corners, which they keep for ever.
template <int D>
void Parts<D>::renew(const Model<D>& local) {
  const Store& s = local.store;
  const std::vector<NewNode> fresh = nodes_from<D>(listed_, local.nodes(), s);
  std::vector<std::vector<Index>> wanted(nodes_in_.size());
  for (const NewNode& node : fresh) {
    const Index n = listed_++, first = node.corner;
    const auto owner =
        static_cast<std::size_t>(family_owner_[static_cast<std::size_t>(node.family)]);
    if (owner == static_cast<std::size_t>(world_->rank())) continue;
    wanted[owner].push_back(part_.element[static_cast<std::size_t>(first / (D + 1))] * (D + 1) +
                            first % (D + 1));
    nodes_in_[owner].push_back(n);
  }
  const std::vector<std::vector<Index>> asked = ask(*world_, wanted);
  for (std::size_t r = 0; r < asked.size(); ++r)
    for (const Index c : asked[r])
      corners_out_[r].push_back(place_in(part_.element, c / (D + 1)) * (D + 1) + c % (D + 1));
  nodes_.set(corners_out_, nodes_in_);
  nodes_out_ = allocate<Array<Index>>("breccia::halo::nodes_out",
                                      static_cast<std::size_t>(nodes_.out_count()));
  nodes_at_corners<D>(s.get<ElementNodes<D>>(), nodes_.out(), nodes_.out_count(), nodes_out_);
}

namespace {

/// Interfaces of the listed faces, or none.
Array<Index> interfaces_of(const Array<Index>& faces, Index count, const Array<Index>& of_face) {
  const auto list =
      allocate<Array<Index>>("breccia::halo::interfaces", static_cast<std::size_t>(count));
  for_each(
      "breccia::halo::interfaces", count, KOKKOS_LAMBDA(Index k) { list(k) = of_face(faces(k)); });
  return list;
}

}  // namespace

template <int D>
void Parts<D>::bring_slip(const Model<D>& local) {
  const Store& s = local.store;
  if (!s.has<InterfaceSlip<D>>()) return;
  const Array<Index> of_face = s.get<FaceInterface>();
  const Array<Index> out = interfaces_of(faces_.out(), faces_.out_count(), of_face);
  const Array<Index> in = interfaces_of(faces_.in(), faces_.in_count(), of_face);
  faces_.exchange_rows(out, in, s.get<InterfaceSlip<D>>());
  if (s.has<InterfaceRubbed<D>>()) faces_.exchange_rows(out, in, s.get<InterfaceRubbed<D>>());
}

template <int D>
StableStep Parts<D>::least(const StableStep& mine) const {
  StableStep all = mine;
  all.dt = world_->least(mine.dt);
  all.strain_rate = world_->largest(mine.strain_rate);
  all.rank =
      static_cast<int>(world_->least(mine.dt == all.dt ? world_->rank() : world_->size() - 1));
  if (all.rank != world_->rank()) all.node = kNone;
  all.by_springs = world_->any(all.rank == world_->rank() && mine.by_springs);
  return all;
}

template <int D>
std::size_t Parts<D>::bytes() const {
  return nodes_.bytes() + faces_.bytes() + nodes_out_.span() * sizeof(Index);
}

template class Parts<2>;
template class Parts<3>;

}  // namespace breccia
