#pragma once
#include "core/config.hpp"
#include "core/schema.hpp"
#include "core/settings.hpp"

namespace breccia {

/// Reads one raw value as its key demands: kind, unit, range, length.
///
/// `dimensions` is 2 or 3, or 0 when the scene does not say (then both lengths pass).
/// \throws Error whose place is that of the value and whose cause does not name the key.
Settings::Value read_key_value(const Key& key, const Config& raw, int dimensions);

}  // namespace breccia
