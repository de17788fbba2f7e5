#include "harness/contact_world.hpp"

#include "loops/contact_distributed.hpp"
#include "loops/contact_gather.hpp"
#include "loops/contact_release.hpp"
#include "loops/list_tools.hpp"
#include "mesh/whole_pieces.hpp"

#include <algorithm>

namespace breccia {

namespace {
constexpr std::uint8_t kReleased = 2;
constexpr std::uint32_t kBit = 16;
}  // namespace

template <int D>
ContactWorld<D>::ContactWorld(Mesh<D> m) : mesh(std::move(m)), topology(build_topology(mesh)) {
  const auto points = static_cast<std::size_t>(mesh.points());
  const auto elements = static_cast<std::size_t>(mesh.elements());
  for (const Point<D>& p : mesh.point) {
    Vec<D> at;
    for (int d = 0; d < D; ++d) at[d] = p[d];
    x.push_back(at);
  }
  v.assign(points, Vec<D>::zero());
  released.assign(topology.shared.size(), 0);
  nodes_ = Connectivity<D>("nodes", elements);
  const auto nodes = Kokkos::create_mirror_view(nodes_);
  for (std::size_t e = 0; e < elements; ++e)
    for (int a = 0; a <= D; ++a) nodes(e, a) = mesh.element[e][a];
  Kokkos::deep_copy(nodes_, nodes);
  x_ = Vectors<D>("x", points);
  v_ = Vectors<D>("v", points);
  reference_ = Vectors<D>("reference", points);
  upload();
  Kokkos::deep_copy(reference_, x_);
  corners_ = Ranges("corners", points);
  const auto corners = Kokkos::create_mirror_view(corners_);
  for (std::size_t n = 0; n < points; ++n)
    for (int s = 0; s < 2; ++s) corners(n, s) = topology.family_start[n + s];
  Kokkos::deep_copy(corners_, corners);
  corner_list_ = to_device("corner_list", topology.family_corner);
  std::vector<Index> free;
  for (const ElementFace& f : topology.free) free.push_back(f.element * (D + 1) + f.face);
  free_ = to_device("free", free);
  material_ = Array<Index>("material", elements);
  std::vector<std::uint8_t> code;
  face_elements_ = Ranges("face_elements", topology.shared.size());
  const auto sides = Kokkos::create_mirror_view(face_elements_);
  for (std::size_t i = 0; i < topology.shared.size(); ++i) {
    const SharedFace& f = topology.shared[i];
    sides(i, 0) = f.left;
    sides(i, 1) = f.right;
    code.push_back(static_cast<std::uint8_t>(f.left_face | f.right_face << 2 | f.rotation << 4));
  }
  Kokkos::deep_copy(face_elements_, sides);
  code_ = to_device("code", code);
  flags_ = Array<std::uint32_t>("flags", points);
  force_ = CornerForces<D>("force", elements);
  signals_.value = Array<Index>("signals", ContactSignals::count);
}

template <int D>
void ContactWorld<D>::upload() const {
  const auto hx = Kokkos::create_mirror_view(x_);
  const auto hv = Kokkos::create_mirror_view(v_);
  for (std::size_t n = 0; n < x.size(); ++n)
    for (int d = 0; d < D; ++d) {
      hx(n, d) = x[n][d];
      hv(n, d) = v[n][d];
    }
  Kokkos::deep_copy(x_, hx);
  Kokkos::deep_copy(v_, hv);
}

template <int D>
void ContactWorld<D>::update_surface() {
  std::vector<std::uint8_t> status;
  for (const char r : released) status.push_back(r ? kReleased : 0);
  status_ = to_device("status", status);
  ContactSurfaceIn<D> in;
  in.nodes = mesh.points();
  in.elements = mesh.elements();
  in.faces = static_cast<Index>(released.size());
  in.element_nodes = nodes_;
  in.reference = reference_;
  in.corners = corners_;
  in.corner_list = corner_list_;
  in.free_facet = free_;
  in.face_status = status_;
  in.face_code = code_;
  in.face_elements = face_elements_;
  in.released = kReleased;
  in.layers = layers;
  update_contact_surface(in, scratch_, surface);
}

template <int D>
void ContactWorld<D>::tell_pieces() {
  const auto elements = static_cast<std::size_t>(mesh.elements());
  const auto piece =
      to_device("piece", whole_pieces(mesh, topology, std::vector<std::uint8_t>(elements, 0)));
  ReleasedFaces<D> in;
  in.status = status_;
  in.elements = face_elements_;
  find_whole_pieces<D>(in, piece, Array<std::uint8_t>("cut", elements), surface);
}

template <int D>
void ContactWorld<D>::search() {
  upload();
  clear_contact<D>(surface, pairs, mesh.points(), flags_, kBit, force_);
  take_contact_places<D>(x_, surface);
  search_contacts(surface, skin + (distributed ? contact_part_reach(surface) : 0), search_scratch_,
                  pairs);
  make_room(pairs.pair_own, pairs.pairs);
  refresh_point_nodes(surface, pairs);
  flag_contact<D>(surface, pairs, nodes_, flags_, kBit);
  ContactStiffness<D> rule;
  rule.fixed = stiffness;
  rule.damping = xi;
  Kokkos::View<double* [2], Rows, Memory> material("material", 1);
  Kokkos::deep_copy(material, 1.0);
  rule.material = material;
  set_contact_points<D>(surface, pairs, material_, rule, point_);
  history.element = decltype(history.element)("element", pairs.points);
  Kokkos::deep_copy(history.element, kNone);
  history.state = decltype(history.state)("state", pairs.points);
  if (law.kind != FrictionKind::coulomb) {
    history.rubbed = decltype(history.rubbed)("rubbed", pairs.points);
    laws_ = to_device("laws", std::vector<FrictionLaw>{law});
  }
  lost_ = ChunkSums<3>("lost", chunks_of(pairs.points));
  table_ = ContactTable("table", 1);
  const auto table = Kokkos::create_mirror_view(table_);
  table(0, 0) = friction;
  table(0, 1) = 1;
  table(0, 2) = 0.3;
  table(0, 3) = 1;
  Kokkos::deep_copy(table_, table);
}

template <int D>
void ContactWorld<D>::force() {
  upload();
  ContactForceIn<D> in;
  in.surface = surface;
  in.pairs = pairs;
  in.point = point_;
  in.x = x_;
  in.v = v_;
  in.element_nodes = nodes_;
  in.element_material = material_;
  in.table = table_;
  in.laws = laws_;
  in.materials = 1;
  in.dt_before = dt_before;
  in.keep = keep;
  in.jumped = jumped;
  in.smooth = smooth;
  const ContactForceOut<D> out{history, signals_, lost_};
  if (distributed) {
    contact_force_distributed<D>(in, out);
    gather_contact_distributed<D>(surface, pairs, force_);
  } else {
    contact_force<D>(in, out);
    gather_contact<D>(surface, pairs, force_);
  }
}

template <int D>
double ContactWorld<D>::stored() const {
  return stored_energy(history, pairs.points);
}

template <int D>
Index ContactWorld<D>::signal(int which) const {
  return to_host(signals_.value, ContactSignals::count)[which];
}

template <int D>
std::vector<Vec<D>> ContactWorld<D>::corner_force() const {
  const auto host = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{}, force_);
  std::vector<Vec<D>> force;
  for (Index e = 0; e < mesh.elements(); ++e)
    for (int a = 0; a <= D; ++a) {
      Vec<D> f;
      for (int d = 0; d < D; ++d) f[d] = host(e, a, d);
      force.push_back(f);
    }
  return force;
}

template <int D>
std::vector<Vec<D>> ContactWorld<D>::node_force() const {
  const std::vector<Vec<D>> corner = corner_force();
  std::vector<Vec<D>> force(x.size(), Vec<D>::zero());
  for (std::size_t c = 0; c < corner.size(); ++c)
    force[mesh.element[c / (D + 1)][c % (D + 1)]] += corner[c];
  return force;
}

template <int D>
Vec<D> ContactWorld<D>::point_force(Index body) const {
  const auto force = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{}, pairs.point_force);
  const auto point = to_host(pairs.point, pairs.points);
  Vec<D> sum = Vec<D>::zero();
  for (Index a = 0; a < pairs.points; ++a)
    if (mesh.body[point[a] / kFacePoints<D> / (D + 1)] == body) sum += row<D>(force, a);
  return sum;
}

template <int D>
Index ContactWorld<D>::touching() const {
  const auto hit = to_host(pairs.hit, pairs.pairs);
  return static_cast<Index>(std::count(hit.begin(), hit.end(), 1));
}

template <int D>
std::vector<std::pair<Index, Index>> ContactWorld<D>::candidates() const {
  const auto point = to_host(pairs.point, pairs.points);
  const auto begin = to_host(pairs.pair_begin, pairs.points + 1);
  const auto target = to_host(pairs.target, pairs.pairs);
  const auto element = to_host(surface.target, surface.targets);
  std::vector<std::pair<Index, Index>> list;
  for (Index a = 0; a < pairs.points; ++a)
    for (Index p = begin[a]; p < begin[a + 1]; ++p) list.emplace_back(point[a], element[target[p]]);
  return list;
}

template <int D>
ContactWay ContactWorld<D>::way() const {
  upload();
  ContactNodes<D> list;
  list_contact_nodes(surface, mesh.points(), list);
  return contact_way<D>(x_, v_, list, Kokkos::subview(signals_.value, ContactSignals::rim));
}

template <int D>
std::vector<double> ContactWorld<D>::node_stiffness() const {
  Array<double> stiffness_at("stiffness", mesh.points());
  ContactStiffnessIn<D> in;
  in.surface = surface;
  in.pairs = pairs;
  in.point = point_;
  in.element_material = material_;
  in.table = table_;
  in.materials = 1;
  in.element_nodes = nodes_;
  in.corners = corners_;
  in.corner_list = corner_list_;
  in.flags = flags_;
  in.bit = kBit;
  in.nodes = mesh.points();
  in.corner = CornerNumbers<D>("corner", mesh.elements());
  find_contact_stiffness(in);
  add_contact_stiffness(in, stiffness_at);
  return to_host(stiffness_at, mesh.points());
}

template class ContactWorld<2>;
template class ContactWorld<3>;

}  // namespace breccia
