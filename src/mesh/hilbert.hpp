#pragma once

#include <array>
#include <cstdint>

namespace breccia {

/// Position along the Hilbert curve of the cell with these integer coordinates of `bits` bits each
/// (D * bits <= 64). Consecutive positions are neighbouring cells. Method: J. Skilling, Programming
/// the Hilbert curve, AIP Conf. Proc. 707 (2004) 381: undo the rotations of each level from the
/// coarsest, then Gray decode.
template <int D>
std::uint64_t hilbert_position(std::array<std::uint32_t, D> x, int bits) {
  for (int level = bits - 1; level > 0; --level) {
    const std::uint32_t bit = 1u << level;
    const std::uint32_t below = bit - 1;
    for (int k = 0; k < D; ++k) {
      if (x[k] & bit) {
        x[0] ^= below;
      } else {
        const std::uint32_t swap = (x[0] ^ x[k]) & below;
        x[0] ^= swap;
        x[k] ^= swap;
      }
    }
  }
  for (int k = 1; k < D; ++k) x[k] ^= x[k - 1];
  std::uint32_t flip = 0;
  for (int level = bits - 1; level > 0; --level) {
    if (x[D - 1] & (1u << level)) flip ^= (1u << level) - 1;
  }
  std::uint64_t position = 0;
  for (int level = bits - 1; level >= 0; --level) {
    for (int k = 0; k < D; ++k) position = position << 1 | ((x[k] ^ flip) >> level & 1u);
  }
  return position;
}

}  // namespace breccia
