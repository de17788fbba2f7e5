#include "modules/contact/contact_pictures.hpp"

#include "loops/list_tools.hpp"

namespace breccia {

template <int D>
std::vector<Touch> find_touches(const Model<D>& model, const ContactSurface<D>& surface,
                                const ContactPairs<D>& pairs) {
  Array<Index> begin;
  const Index count = list_begins(
      "breccia::contact::count_touches", pairs.points,
      KOKKOS_LAMBDA(Index a) {
        Index n = 0;
        for (Index p = pairs.pair_begin(a); p < pairs.pair_begin(a + 1); ++p) n += pairs.hit(p);
        return n;
      },
      begin);
  const Array<Touch> list("breccia::contact::touches", static_cast<std::size_t>(count));
  const ConstVectors<D> x = model.store.template get<NodePosition<D>>();
  for_each(
      "breccia::contact::touches", pairs.points, KOKKOS_LAMBDA(Index a) {
        const Index point = pairs.point(a);
        Touch touch{};
        for (int k = 0; k < D; ++k)
          for (int d = 0; d < D; ++d)
            touch.place[d] += face_weight<D>(point % kFacePoints<D>, k, surface.own_weight) *
                              x(pairs.nodes(a, k), d);
        touch.element = point / kFacePoints<D> / (D + 1);
        Index to = begin(a);
        for (Index p = pairs.pair_begin(a); p < pairs.pair_begin(a + 1); ++p) {
          if (pairs.hit(p) == 0) continue;
          for (int d = 0; d < D; ++d) touch.force[d] = pairs.pair_force(p, d);
          touch.target = surface.target(pairs.target(p));
          list(to++) = touch;
        }
      });
  return to_host(list, static_cast<std::size_t>(count));
}

template <int D>
PictureField draw_contact_force(const Model<D>& model) {
  const Store& s = model.store;
  const auto force =
      Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{}, s.get<ContactForce<D>>());
  const auto nodes =
      Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{}, s.get<ElementNodes<D>>());
  PictureField field{"contact_force", "N", D, {}};
  field.values.assign(static_cast<std::size_t>(model.nodes()) * D, 0.0);
  for (Index e = 0; e < model.elements(); ++e)
    for (int a = 0; a <= D; ++a)
      for (int d = 0; d < D; ++d)
        field.values[static_cast<std::size_t>(nodes(e, a)) * D + d] += force(e, a, d);
  return field;
}

template std::vector<Touch> find_touches<2>(const Model<2>&, const ContactSurface<2>&,
                                            const ContactPairs<2>&);
template std::vector<Touch> find_touches<3>(const Model<3>&, const ContactSurface<3>&,
                                            const ContactPairs<3>&);
template PictureField draw_contact_force<2>(const Model<2>&);
template PictureField draw_contact_force<3>(const Model<3>&);

}  // namespace breccia
