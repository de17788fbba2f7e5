#pragma once
#include "base/views.hpp"

#include <string_view>

namespace breccia {

/// What a field has one value for. `interface` counts inserted faces, `contact_point` the points
/// near another piece; they and `node` change their number.
enum class Entity {
  node,
  corner,
  element,
  element_word,  ///< kWordBits elements in a row
  family,
  face,
  interface,
  boundary,
  absorber,
  material,
  contact_point,
  rigid,
  count_
};

inline constexpr int kEntities = static_cast<int>(Entity::count_);

enum class Restart : bool { no, yes };

/// What is said about a field once, where it is declared.
struct FieldInfo {
  std::string_view name;
  Entity entity;
  std::string_view unit;
  Restart restart;
  std::string_view text;
};

}  // namespace breccia
