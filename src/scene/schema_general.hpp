#pragma once
#include "core/schema.hpp"

namespace breccia {

/// The keys that belong to no optional effect: title, [run], [[body]], [material.*], [gravity],
/// [[boundary]], [[sensor]], [output], [[check]]; and the rules between them.
void declare_general_keys(Schema& schema);

}  // namespace breccia
