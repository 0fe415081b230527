#pragma once

#include <bit>
#include <cstddef>
#include <cstring>

namespace berm {

static_assert(std::endian::native == std::endian::little, "files are little-endian and are copied as they are");

/// The value at `bytes`, which need not be aligned.
template <typename Value>
[[nodiscard]] Value load(const std::byte* bytes) {
  Value value{};
  std::memcpy(&value, bytes, sizeof(Value));
  return value;
}

template <typename Value>
void store(std::byte* bytes, Value value) {
  std::memcpy(bytes, &value, sizeof(Value));
}

}  // namespace berm
