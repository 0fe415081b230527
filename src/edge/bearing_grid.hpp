#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>

namespace berm::edge::bearing_grid {

/// Sectors of two degrees, counted from straight behind counterclockwise.
inline constexpr int kSectors = 180;

/// A bearing without trigonometry: y / (|x| + |y|), turned into a number that rises from straight behind
/// counterclockwise, seen from above, as the bearing does. NaN gives any.
inline constexpr int kTurnsPerQuadrant = 1024;
[[nodiscard]] inline std::uint16_t turn_of(float x, float y) {
  const float sum = std::abs(x) + std::abs(y);
  const float slant = sum > 0.0F ? y / sum : 0.0F;
  const float turn = x >= 0.0F ? slant : std::copysign(2.0F, y) - slant;
  constexpr float kLast = 4.0F * kTurnsPerQuadrant - 1.0F;
  const float place = (turn + 2.0F) * static_cast<float>(kTurnsPerQuadrant);
  return static_cast<std::uint16_t>(std::min(place > 0.0F ? place : 0.0F, kLast));
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

}  // namespace berm::edge::bearing_grid

namespace berm {
namespace bearing_grid = edge::bearing_grid;
}  // namespace berm
