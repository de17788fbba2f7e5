#include "io/digest.hpp"

#include <algorithm>
#include <bit>
#include <cstring>

namespace breccia {
namespace {

// Odd constants with about half of their bits set (the fraction of the golden ratio, and one of its
// multiples).
constexpr std::uint64_t kMultiply = 0x9E3779B97F4A7C15u;
constexpr std::uint64_t kFinish = 0xD6E8FEB86659FD93u;

// Multiplying carries a bit upwards only; the shift between brings the top ones down before the
// second one.
std::uint64_t stir(std::uint64_t state, std::uint64_t word) {
  const std::uint64_t h = (state ^ word) * kMultiply;
  return std::rotl((h ^ (h >> 32)) * kFinish, 29);
}

std::uint64_t spread(std::uint64_t h) {
  h = (h ^ (h >> 32)) * kFinish;
  h = (h ^ (h >> 32)) * kFinish;
  return h ^ (h >> 32);
}

}  // namespace

void Digest::take_block(const unsigned char* block) {
  std::array<std::uint64_t, kLanes> word;
  std::memcpy(word.data(), block, kBlock);
  for (std::size_t k = 0; k < kLanes; ++k) lane_[k] = stir(lane_[k], word[k]);
}

void Digest::update(const void* data, std::size_t bytes) {
  const auto* next = static_cast<const unsigned char*>(data);
  length_ += bytes;
  while (bytes > 0) {
    if (rest_size_ == 0 && bytes >= kBlock) {
      take_block(next);
      next += kBlock;
      bytes -= kBlock;
      continue;
    }
    const std::size_t piece = std::min(bytes, kBlock - rest_size_);
    std::memcpy(rest_.data() + rest_size_, next, piece);
    rest_size_ += piece;
    next += piece;
    bytes -= piece;
    if (rest_size_ == kBlock) {
      take_block(rest_.data());
      rest_size_ = 0;
    }
  }
}

std::uint64_t Digest::value() const {
  Digest last = *this;
  std::fill(last.rest_.begin() + static_cast<std::ptrdiff_t>(rest_size_), last.rest_.end(), 0);
  last.take_block(last.rest_.data());
  std::uint64_t h = spread(length_);
  for (const std::uint64_t lane : last.lane_) h = spread(stir(h, lane));
  return h;
}

std::string hex16(std::uint64_t value) {
  constexpr std::string_view digits = "0123456789abcdef";
  std::string text(16, '0');
  for (std::size_t k = 0; k < 16; ++k) text[15 - k] = digits[(value >> (4 * k)) & 15u];
  return text;
}

std::string fingerprint(std::string_view text) {
  Digest digest;
  digest.update(text);
  return hex16(digest.value());
}

}  // namespace breccia
