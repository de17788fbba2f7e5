#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

namespace breccia {

/// Number types that files of Breccia may hold.
enum class DataType : std::uint8_t { f64, f32, i32, i64, u8, u64 };

template <class T>
constexpr DataType data_type_of() {
  using V = std::remove_cv_t<T>;
  if constexpr (std::is_same_v<V, double>) return DataType::f64;
  if constexpr (std::is_same_v<V, float>) return DataType::f32;
  if constexpr (std::is_same_v<V, std::int32_t>) return DataType::i32;
  if constexpr (std::is_same_v<V, std::int64_t>) return DataType::i64;
  if constexpr (std::is_same_v<V, std::uint8_t>) return DataType::u8;
  if constexpr (std::is_same_v<V, std::uint64_t>) return DataType::u64;
}

constexpr std::size_t size_of(DataType type) {
  switch (type) {
    case DataType::f64:
    case DataType::i64:
    case DataType::u64:
      return 8;
    case DataType::f32:
    case DataType::i32:
      return 4;
    case DataType::u8:
      return 1;
  }
  return 0;
}

constexpr std::string_view name_of(DataType type) {
  switch (type) {
    case DataType::f64:
      return "float64";
    case DataType::f32:
      return "float32";
    case DataType::i32:
      return "int32";
    case DataType::i64:
      return "int64";
    case DataType::u8:
      return "uint8";
    case DataType::u64:
      return "uint64";
  }
  return "unknown";
}

/// Type and shape of an array in a file; row-major, slowest index first.
struct ArrayInfo {
  DataType type = DataType::f64;
  std::vector<std::size_t> shape;

  std::size_t count() const {
    std::size_t n = 1;
    for (const std::size_t extent : shape) n *= extent;
    return n;
  }
  std::size_t bytes() const { return count() * size_of(type); }
};

/// Host memory that somebody else owns, with its type and shape; what every writer of this folder
/// takes.
struct ArrayView : ArrayInfo {
  const void* data = nullptr;
};

/// View of a contiguous range of numbers (vector, span, array) with the given shape; empty shape:
/// one row of all.
template <class Range>
ArrayView view_of(const Range& values, std::vector<std::size_t> shape = {}) {
  const std::span all(values);
  using T = typename decltype(all)::element_type;
  if (shape.empty()) shape = {all.size()};
  return {{data_type_of<T>(), std::move(shape)}, all.data()};
}

}  // namespace breccia
