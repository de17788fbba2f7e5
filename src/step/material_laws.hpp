#pragma once
#include "core/schema.hpp"
#include "core/settings.hpp"
#include "point/eos.hpp"
#include "point/plastic_laws.hpp"

#include <optional>
#include <vector>

namespace breccia {

/// What a law shares with the rest of its material.
struct MaterialBasis {
  double density = 0;  ///< kg/m3
  double bulk = 0;     ///< K of the elastic constants, Pa
  double shear = 0;    ///< G, Pa
};

/// The scene keys of one inelastic law: [material.NAME.word].
struct PlasticKeys {
  const char* word;
  const char* doc;
  void (*declare)(SectionBuilder);
  PlasticLaw (*read)(const Settings& law, const MaterialBasis&);  ///< \throws Error: wrong together
};

// The laws that have a file of keys of their own.
PlasticKeys drucker_prager_keys();
PlasticKeys mohr_coulomb_keys();
PlasticKeys holmquist_keys();

/// The scene keys of one equation of state: [material.NAME.eos.word].
struct EosKeys {
  const char* word;
  const char* doc;
  void (*declare)(SectionBuilder);
  void (*read)(const Settings& law, const MaterialBasis&, Eos&);  ///< \throws Error: wrong together
};

/// All of them, in the order of docs/input.md.
const std::vector<PlasticKeys>& plastic_keys();
const std::vector<EosKeys>& eos_keys();

/// The keys of [material.NAME.eos.pores].
void declare_pores(SectionBuilder section);
Pores read_pores(const Settings& section);

/// The law of a material, NoYield where none is given; the equation of state of its section `eos`.
/// \throws Error where values do not go together.
PlasticLaw read_plastic(const Settings& material, const MaterialBasis& basis);
Eos read_eos(const Settings& eos, const MaterialBasis& basis);

/// Largest stress in simple tension that the bulk of a material bears, Pa; nothing where it is not
/// limited.
std::optional<double> tension_of_bulk(const PlasticLaw& law);

}  // namespace breccia
