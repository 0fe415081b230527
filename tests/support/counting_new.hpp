#pragma once

#include <cstddef>

namespace berm::test {

/// Bytes that `new` has given out and `delete` has not taken back. A program that links counting_new.cpp counts.
[[nodiscard]] std::size_t allocated_bytes();
/// The most that this was since `reset_peak`.
[[nodiscard]] std::size_t peak_bytes();
void reset_peak();
/// How often `new` was called.
[[nodiscard]] std::size_t allocations();

}  // namespace berm::test
