#pragma once
#include "core/schema.hpp"
#include "modules/fracture/interface_laws.hpp"

namespace breccia {

/// Whether a scene has fractures that interfaces act on: all kinds but open ones.
bool has_existing_laws(const Settings& scene);

/// Appends the laws of [[fractures]], of their patches and of grains. Throws Error with place.
void read_existing_laws(const Settings& scene, InterfaceLaws& laws);

/// Gives faces between grains, then faces that lie on fractures the laws of these; a face on two
/// has that of the later one.
template <int D>
void put_existing_laws(const InterfaceLaws& laws, const Model<D>& model, std::vector<Index>& law);

/// Laws of healed fractures and grains, the weakest grade of each.
std::vector<Index> weakest_existing(const InterfaceLaws& laws);

/// The keys of the laws in [[fractures]].
void declare_existing_law_keys(Schema& schema);

}  // namespace breccia
