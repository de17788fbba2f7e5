#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace breccia {

/// 64-bit checksum of a stream of bytes, the same on every machine of one byte order. Every step is
/// a bijection of the 8-byte word it takes in, so damage confined to one word is found with
/// certainty, any other with 1 - 2^-64. It guards against accidents, not against people.
class Digest {
 public:
  void update(const void* data, std::size_t bytes);
  void update(std::string_view text) { update(text.data(), text.size()); }
  /// Checksum of all bytes so far; the stream may go on afterwards.
  std::uint64_t value() const;

 private:
  static constexpr std::size_t kLanes = 4;
  static constexpr std::size_t kBlock = kLanes * sizeof(std::uint64_t);
  void take_block(const unsigned char* block);

  std::array<std::uint64_t, kLanes> lane_ = {1, 2, 3, 4};
  std::array<unsigned char, kBlock> rest_ = {};
  std::size_t rest_size_ = 0;
  std::uint64_t length_ = 0;
};

/// 16 hexadecimal digits of a 64-bit number.
std::string hex16(std::uint64_t value);

/// Short name of a text (a resolved scene, a build description) as 16 hexadecimal digits: equal
/// texts, equal names.
std::string fingerprint(std::string_view text);

}  // namespace breccia
