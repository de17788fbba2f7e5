#pragma once
#include <array>
#include <cmath>
#include <cstdint>

namespace breccia {

/// Random numbers without state: the same (seed, stream, id, draw) gives the same number on every
/// machine, for any number of threads and in any order.
///
/// Philox4x32-10: Salmon, Moraes, Dror, Shaw (2011), "Parallel random numbers: as easy as 1, 2, 3",
/// doi:10.1145/2063384.2063405.
struct Random {
  std::uint64_t seed = 0;    ///< of the scene
  std::uint32_t stream = 0;  ///< one per purpose, so that two fields are independent

  using Block = std::array<std::uint32_t, 4>;

  /// 128 random bits from a 128-bit counter and a 64-bit key.
  static constexpr Block philox(Block c, std::array<std::uint32_t, 2> key) {
    for (int round = 0; round < 10; ++round) {
      const std::uint64_t p0 = 0xD2511F53ULL * c[0];
      const std::uint64_t p1 = 0xCD9E8D57ULL * c[2];
      c = {static_cast<std::uint32_t>(p1 >> 32) ^ c[1] ^ key[0], static_cast<std::uint32_t>(p1),
           static_cast<std::uint32_t>(p0 >> 32) ^ c[3] ^ key[1], static_cast<std::uint32_t>(p0)};
      key[0] += 0x9E3779B9U;
      key[1] += 0xBB67AE85U;
    }
    return c;
  }

  [[nodiscard]] constexpr Block bits(std::uint64_t id, std::uint32_t draw = 0) const {
    return philox(
        {static_cast<std::uint32_t>(id), static_cast<std::uint32_t>(id >> 32), draw, stream},
        {static_cast<std::uint32_t>(seed), static_cast<std::uint32_t>(seed >> 32)});
  }

  /// In [0, 1), 53 random bits.
  [[nodiscard]] constexpr double uniform(std::uint64_t id, std::uint32_t draw = 0) const {
    const Block b = bits(id, draw);
    const std::uint64_t both = (static_cast<std::uint64_t>(b[0]) << 32) | b[1];
    return static_cast<double>(both >> 11) * 0x1.0p-53;
  }

  /// Mean 0, variance 1 (Box and Muller 1958).
  [[nodiscard]] double normal(std::uint64_t id, std::uint32_t draw = 0) const {
    const Block b = bits(id, draw);
    const std::uint64_t low = (static_cast<std::uint64_t>(b[0]) << 32) | b[1];
    const std::uint64_t high = (static_cast<std::uint64_t>(b[2]) << 32) | b[3];
    const double u = (static_cast<double>(low >> 11) + 0.5) * 0x1.0p-53;
    const double angle = 6.283185307179586476925 * static_cast<double>(high >> 11) * 0x1.0p-53;
    return std::sqrt(-2.0 * std::log(u)) * std::cos(angle);
  }
};

}  // namespace breccia
