#pragma once

#include <bit>
#include <cstring>
#include <span>
#include <string>
#include <type_traits>

namespace berm {

static_assert(std::endian::native == std::endian::little, "answers are little endian");

/// Appends a number as its bytes.
template <typename Number>
void append_bytes(std::string& bytes, Number value) {
  static_assert(std::is_arithmetic_v<Number>);
  char raw[sizeof(Number)];
  std::memcpy(raw, &value, sizeof(Number));
  bytes.append(raw, sizeof(Number));
}

/// Appends the bytes of an array.
template <typename Number>
void append_array(std::string& bytes, std::span<const Number> values) {
  static_assert(std::is_arithmetic_v<Number>);
  bytes.append(reinterpret_cast<const char*>(values.data()), values.size_bytes());
}

}  // namespace berm
