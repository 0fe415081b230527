#pragma once

#include <algorithm>
#include <cstdint>
#include <cstring>

namespace berm {

/// Values are compared so many at a time: as many must be readable behind the last one.
constexpr std::uint32_t kCountLanes = 8;

/// How many of `count` values lie in [low, low + width]. Written with vectors because no compiler finds them in the
/// plain loop; g++ and clang turn them into whatever the processor has.
[[nodiscard]] inline std::uint32_t count_between(const std::uint16_t* values, std::uint32_t count, std::uint16_t low,
                                                 std::uint16_t width) {
  using Lanes = std::uint16_t __attribute__((vector_size(2 * kCountLanes)));
  constexpr Lanes kNumbers = {0, 1, 2, 3, 4, 5, 6, 7};
  constexpr std::uint32_t kMostAtATime = 65528;  // the sum of the lanes must not need more than 16 bits
  const Lanes width_of_all = Lanes{} + width;
  std::uint32_t found = 0;
  while (count > 0) {
    const std::uint32_t part = std::min(count, kMostAtATime);
    Lanes sums = {};
    for (std::uint32_t k = 0; k < part; k += kCountLanes) {
      Lanes lanes;
      std::memcpy(&lanes, values + k, sizeof(lanes));
      const auto left = static_cast<std::uint16_t>(std::min(part - k, kCountLanes));
      // Below `low` the difference wraps to a large number. True is -1.
      sums -= reinterpret_cast<Lanes>(((lanes - low) <= width_of_all) & (kNumbers < Lanes{} + left));
    }
    std::uint64_t halves[2];
    std::memcpy(halves, &sums, sizeof(sums));
    found += static_cast<std::uint32_t>((halves[0] + halves[1]) * 0x0001000100010001U >> 48U);
    values += part;
    count -= part;
  }
  return found;
}

}  // namespace berm
