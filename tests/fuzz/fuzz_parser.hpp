#pragma once

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <span>

#include "berm/core/error.hpp"

namespace berm::test {

/// Stops the fuzzer where a result contradicts what a parser promises.
inline void demand(bool promise) {
  if (!promise) {
    std::abort();
  }
}

/// Runs `parse` on the input of a fuzz target. A parser may refuse bytes by a FileError and by nothing else.
template <typename Parse>
int fuzz_parser(const std::uint8_t* data, std::size_t size, Parse&& parse) {
  try {
    parse(std::as_bytes(std::span(data, size)));
  } catch (const FileError&) {
  }
  return 0;
}

}  // namespace berm::test
