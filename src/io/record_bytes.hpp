#pragma once

#include <bit>
#include <cstring>
#include <string>
#include <type_traits>

namespace berm {

static_assert(std::endian::native == std::endian::little, "files are little-endian and are copied as they are");

/// Appends a number as its bytes.
template <typename Number>
void append_number(std::string& bytes, Number value) {
  static_assert(std::is_arithmetic_v<Number>);
  char raw[sizeof(Number)];
  std::memcpy(raw, &value, sizeof(Number));
  bytes.append(raw, sizeof(Number));
}

}  // namespace berm
