#pragma once
#include "core/schema.hpp"
#include "step/module.hpp"

#include <memory>
#include <vector>

namespace breccia {

/// The one list of modules: those that the scene calls for, in the order in which their tasks
/// run within a stage.
template <int D>
std::vector<std::unique_ptr<Module<D>>> make_modules(const Settings& scene);

/// The keys of the modules that have sections of their own.
void declare_module_keys(Schema& schema);

/// Names of the effects of this build, and whether the scene calls for each.
struct EffectState {
  std::string name;
  bool on;
};
std::vector<EffectState> effects_of(const Settings& scene);

}  // namespace breccia
