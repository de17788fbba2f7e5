#pragma once
#include <cstdint>

namespace breccia {

/// Entity number inside one rank; 32 bits because kernels gather with it.
using Index = std::int32_t;

/// Number that is unique over all ranks and never reused.
using GlobalId = std::int64_t;

/// Stands for "none" where an entity may be missing (the other side of a free face, say).
inline constexpr Index kNone = -1;

}  // namespace breccia
