#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>

namespace berm {

/// Counts the values of runs that lie in a band. Written with vectors because a loop over a dozen values is none to a
/// compiler; g++ and clang turn them into whatever the processor has.
class BandCount {
  static constexpr std::uint32_t kLanes = 8;
  static constexpr std::uint32_t kShort = 5 * kLanes;

 public:
  /// So many values must be readable behind the last one of a run.
  static constexpr std::uint32_t kMargin = kShort;

  /// Counts what lies in [low, low + width].
  BandCount(std::uint16_t low, std::uint16_t width) : low_(low), width_(width) {}

  void add(const std::uint16_t* values, std::uint32_t count) {
    // Most runs are short: looking at all lanes in any case is cheaper than asking how many there are.
    const std::uint16_t* mask = kMask.data() + kShort - std::min(count, kShort);
    for (std::uint32_t k = 0; k < kShort; k += kLanes) {
      add_masked(values + k, mask + k);
    }
    if (count > kShort) {
      add_long(values + kShort, count - kShort);
    }
  }

  [[nodiscard]] std::uint32_t total() const {
    std::uint64_t halves[2];
    std::memcpy(halves, &sums_, sizeof(sums_));
    return beyond_ + static_cast<std::uint32_t>((halves[0] + halves[1]) * 0x0001000100010001U >> 48U);
  }

 private:
  using Lanes = std::uint16_t __attribute__((vector_size(2 * kLanes)));

  /// kShort ones, then as many zeros: of what is read from entry kShort - n on, n lanes count.
  static constexpr auto kMask = [] {
    std::array<std::uint16_t, 2 * std::size_t{kShort}> mask{};
    for (std::size_t i = 0; i < kShort; ++i) {
      mask[i] = 1;
    }
    return mask;
  }();

  void add_masked(const std::uint16_t* values, const std::uint16_t* mask) {
    Lanes lanes;
    Lanes counts;
    std::memcpy(&lanes, values, sizeof(lanes));
    std::memcpy(&counts, mask, sizeof(counts));
    // Below `low` the difference wraps to a large number.
    sums_ += reinterpret_cast<Lanes>((lanes - low_) <= Lanes{} + width_) & counts;
  }

  void add_long(const std::uint16_t* values, std::uint32_t count) {
    constexpr std::uint32_t kMostAtATime = 4096;  // what nine runs leave in the lanes must not need more than 16 bits
    for (; count > kMostAtATime; values += kMostAtATime, count -= kMostAtATime) {
      add_groups(values, kMostAtATime);
      beyond_ = total();
      sums_ = Lanes{};
    }
    add_groups(values, count);
  }

  void add_groups(const std::uint16_t* values, std::uint32_t count) {
    std::uint32_t k = 0;
    for (; k + kLanes <= count; k += kLanes) {
      add_masked(values + k, kMask.data());
    }
    add_masked(values + k, kMask.data() + kShort - (count - k));
  }

  std::uint16_t low_;
  std::uint16_t width_;
  std::uint32_t beyond_ = 0;
  Lanes sums_ = {};
};

}  // namespace berm
