#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <span>

namespace berm::bearing_grid {

/// Places around a machine on a grid of bearings times logarithms of range: its cells look alike near and far, and a
/// straight line is a smooth one in it.
inline constexpr int kSectors = 180;
inline constexpr int kBins = 100;
inline constexpr float kFirstRange_m = 2.0F;
inline constexpr float kBinRatio = 0.04F;  ///< a bin is this share of its range long: as long as a sector is wide

/// Bin of a range, squared: the last from 105 m to infinity, the first for NaN.
[[nodiscard]] inline int bin_of(float range_squared_m2) {
  const float bin = (0.5F / kBinRatio) * std::log(range_squared_m2 / (kFirstRange_m * kFirstRange_m));
  return static_cast<int>(bin > 0.0F ? std::min(bin, static_cast<float>(kBins - 1)) : 0.0F);
}

/// Range at which bin `bin` begins.
[[nodiscard]] inline float range_of(int bin) {
  return kFirstRange_m * std::exp(kBinRatio * static_cast<float>(bin));
}

[[nodiscard]] inline float bearing_of(int sector) {
  constexpr float kStep_rad = 2.0F * std::numbers::pi_v<float> / static_cast<float>(kSectors);
  return (static_cast<float>(sector) + 0.5F) * kStep_rad - std::numbers::pi_v<float>;
}

/// A bearing without trigonometry: y / (|x| + |y|), turned into a number that rises from straight behind
/// counterclockwise, seen from above, as the bearing does. NaN gives any.
inline constexpr int kTurnsPerQuadrant = 1024;
[[nodiscard]] inline std::uint16_t turn_of(float x, float y) {
  const float sum = std::abs(x) + std::abs(y);
  const float slant = sum > 0.0F ? y / sum : 0.0F;
  const float turn = x >= 0.0F ? slant : std::copysign(2.0F, y) - slant;
  constexpr float kLast = 4.0F * kTurnsPerQuadrant - 1.0F;
  const float place = (turn + 2.0F) * static_cast<float>(kTurnsPerQuadrant);
  const float bounded = place > 0.0F ? place : 0.0F;
  // By way of 32 bits: compilers know no vectors that take a float to 16.
  return static_cast<std::uint16_t>(static_cast<std::int32_t>(bounded < kLast ? bounded : kLast));
}

/// Sector of each turn. Borders of sectors are met to a twentieth of a sector.
class SectorTable {
 public:
  SectorTable() {
    for (std::size_t i = 0; i < sectors_.size(); ++i) {
      const double turn = (static_cast<double>(i) + 0.5) / kTurnsPerQuadrant - 2.0;  // -2 and 2: straight behind
      const double y = turn < -1.0 ? -2.0 - turn : (turn > 1.0 ? 2.0 - turn : turn);
      const double x = 1.0 - std::abs(turn);
      const double share = (std::atan2(y, x) + std::numbers::pi) / (2.0 * std::numbers::pi);
      sectors_[i] = static_cast<std::uint8_t>(std::min(static_cast<int>(share * kSectors), kSectors - 1));
    }
  }

  [[nodiscard]] std::uint8_t operator[](std::uint16_t turn) const { return sectors_[turn]; }
  [[nodiscard]] std::uint8_t of(float x, float y) const { return sectors_[turn_of(x, y)]; }

 private:
  std::array<std::uint8_t, std::size_t{4} * kTurnsPerQuadrant> sectors_{};
};

/// Sectors one after the other, counterclockwise, maybe across straight behind.
struct Arc {
  int first = 0;
  int count = 0;

  [[nodiscard]] std::size_t sector(int i) const { return static_cast<std::size_t>((first + i) % kSectors); }
  [[nodiscard]] bool holds(int sector) const { return (sector - first + kSectors) % kSectors < count; }
};

/// The sectors without the widest gap of unseen ones; `seen` has a 1 for every sector that is. A full turn begins and
/// ends straight behind.
[[nodiscard]] inline Arc find_arc(std::span<const std::uint8_t> seen) {
  int gap_begin = 0;
  int gap = 0;
  int run = 0;
  for (int i = 0; i < 2 * kSectors; ++i) {
    run = seen[static_cast<std::size_t>(i % kSectors)] != 0 ? 0 : std::min(run + 1, kSectors);
    if (run > gap) {
      gap = run;
      gap_begin = i - run + 1;
    }
  }
  return {.first = gap == 0 ? 0 : (gap_begin + gap) % kSectors, .count = kSectors - gap};
}

}  // namespace berm::bearing_grid
