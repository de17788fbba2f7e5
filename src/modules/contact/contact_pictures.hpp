#pragma once
#include "loops/contact_lists.hpp"
#include "step/model.hpp"
#include "step/observation.hpp"

#include <vector>

namespace breccia {

/// The contact points that press, as the last force loop left them.
template <int D>
std::vector<Touch> find_touches(const Model<D>& model, const ContactSurface<D>& surface,
                                const ContactPairs<D>& pairs);

/// Forces of contact summed on the nodes, N.
template <int D>
PictureField draw_contact_force(const Model<D>& model);

extern template std::vector<Touch> find_touches<2>(const Model<2>&, const ContactSurface<2>&,
                                                   const ContactPairs<2>&);
extern template std::vector<Touch> find_touches<3>(const Model<3>&, const ContactSurface<3>&,
                                                   const ContactPairs<3>&);
extern template PictureField draw_contact_force<2>(const Model<2>&);
extern template PictureField draw_contact_force<3>(const Model<3>&);

}  // namespace breccia
