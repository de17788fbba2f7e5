#include "modules/fracture/crack_pictures.hpp"

#include "fields/interface_fields.hpp"
#include "modules/fracture/fracture_fields.hpp"
#include "point/interface_frame.hpp"
#include "point/seismic_moment.hpp"

namespace breccia {

namespace {

/// Where a face is, and what its corners have gone through.
template <int D>
struct CrackLook {
  InterfaceMap<D> map;
  ConstConnectivity<D> nodes;
  ConstVectors<D> x;
  ConstArray<Index> family;
  ConstArray<std::uint8_t> status;
  ConstCornerStates<D> state;
  ConstCornerEnergies<D> energy;
  Array<double> break_time;
  ConstArray<Index> material;  ///< of elements
  ConstVectors<2> lame;        ///< of materials

  KOKKOS_FUNCTION
  void middle(Index i, Vec<D> (&m)[D]) const {
    for (int c = 0; c < D; ++c)
      m[c] = (face_point(map.faces, nodes, x, map.record(i).face, 0, c) +
              face_point(map.faces, nodes, x, map.record(i).face, 1, c)) *
             0.5;
  }

  /// Energies of opening and sliding, J.
  KOKKOS_FUNCTION
  Vec<2> spent(Index i) const {
    Vec<2> sum = Vec<2>::zero();
    for (int c = 0; c < D; ++c) {
      if (map.active(i, c) == 0) continue;
      sum[0] += energy(i, c).tension * map.record(i).area / D;
      sum[1] += energy(i, c).shear * map.record(i).area / D;
    }
    return sum;
  }

  /// 1 tension ... 2 shear
  KOKKOS_FUNCTION
  static double mode(const Vec<2>& spent) {
    const double all = spent[0] + spent[1];
    return all > 0 ? 1 + spent[1] / all : 1;
  }

  /// Mean opening and slip of the corners, m.
  KOKKOS_FUNCTION
  Vec<2> gap(Index face, const InterfaceFrame<D>& frame) const {
    Vec<2> mean = Vec<2>::zero();
    for (int c = 0; c < D; ++c) {
      const Vec<D> jump = frame.to_local(face_point(map.faces, nodes, x, face, 1, c) -
                                         face_point(map.faces, nodes, x, face, 0, c));
      double slip = 0;
      for (int d = 1; d < D; ++d) slip += jump[d] * jump[d];
      mean[0] += jump[0] / D;
      mean[1] += Kokkos::sqrt(slip) / D;
    }
    return mean;
  }

  /// Mean Lame constants of both sides, Pa.
  KOKKOS_FUNCTION
  HenckyElastic sides(Index face) const {
    const Index l = material(map.faces.elements(face, 0));
    const Index r = material(map.faces.elements(face, 1));
    return {0.5 * (lame(l, 0) + lame(r, 0)), 0.5 * (lame(l, 1) + lame(r, 1))};
  }

  KOKKOS_FUNCTION
  Event event(Index i, double time) const {
    Vec<D> m[D];
    middle(i, m);
    const InterfaceFrame<D> frame = frame_of(m);
    const Vec<D> n = frame.normal();
    const Vec<2> e = spent(i), g = gap(map.record(i).face, frame);
    const HenckyElastic law = sides(map.record(i).face);
    const double area = map.record(i).area;
    Event event{time, {0, 0, 0}, {0, 0, 0}, mode(e), area,
                e[0], e[1],      g[0],      g[1],    area * moment_per_area(law, g[0], g[1])};
    break_time(i) = time;
    for (int d = 0; d < D; ++d) {
      for (int c = 0; c < D; ++c) event.place[d] += m[c][d] / D;
      event.normal[d] = n[d];
    }
    return event;
  }

  KOKKOS_FUNCTION
  CrackFace face(Index i) const {
    Vec<D> m[D];
    middle(i, m);
    const InterfaceRecord& r = map.record(i);
    const InterfaceFrame<D> frame = frame_of(m);
    CrackFace face{};
    for (int c = 0; c < D; ++c) {
      for (int d = 0; d < D; ++d) face.point[c][d] = m[c][d];
      const auto at = map.faces.left(r.face, c);
      face.family[c] = family(nodes(at.element, at.node));
      if (map.active(i, c) != 0) face.damage += state(i, c).damage / D;
    }
    const Vec<2> g = gap(r.face, frame), e = spent(i);
    face.opening = g[0];
    face.slip = g[1];
    const CohesiveState<D>& first = state(i, 0);  // a fault has no strength and slides
    const bool fault = first.damage >= 1 && first.strength == 0 && first.cohesion == 0;
    face.mode = fault ? 2 : mode(e);
    face.status = status(r.face);
    face.area = r.area;
    face.energy = e[0] + e[1];
    face.time = face.status == face_status::released ? break_time(i) : -1;
    return face;
  }
};

template <int D>
CrackLook<D> look_at(const Model<D>& model) {
  const Store& s = model.store;
  return {interface_map<D>(s),           s.get<ElementNodes<D>>(),    s.get<NodePosition<D>>(),
          s.get<NodeFamily>(),           s.get<FaceStatus>(),         s.get<InterfaceStates<D>>(),
          s.get<InterfaceEnergies<D>>(), s.get<InterfaceBreakTime>(), s.get<ElementMaterial>(),
          s.get<MaterialLame>()};
}

}  // namespace

template <int D>
std::vector<Event> break_events(const Model<D>& model, const Array<Index>& changed, Index count,
                                double time) {
  const auto look = look_at(model);
  const auto list = allocate<Array<Event>>("breccia::fracture::events", count);
  for_each(
      "breccia::fracture::events", count,
      KOKKOS_LAMBDA(Index k) { list(k) = look.event(changed(k), time); });
  return to_host(list, count);
}

template <int D>
std::vector<CrackFace> crack_faces(const Model<D>& model) {
  const Index count = model.store.count(Entity::interface);
  const auto look = look_at(model);
  const auto list = allocate<Array<CrackFace>>("breccia::fracture::crack_faces", count);
  for_each(
      "breccia::fracture::crack_faces", count, KOKKOS_LAMBDA(Index i) { list(i) = look.face(i); });
  std::vector<CrackFace> faces;
  for (const CrackFace& face : to_host(list, count)) faces.push_back(face);
  return faces;
}

template std::vector<Event> break_events<2>(const Model<2>&, const Array<Index>&, Index, double);
template std::vector<Event> break_events<3>(const Model<3>&, const Array<Index>&, Index, double);
template std::vector<CrackFace> crack_faces<2>(const Model<2>&);
template std::vector<CrackFace> crack_faces<3>(const Model<3>&);

}  // namespace breccia
