#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>

namespace berm::bearing_grid {

/// The boundary of a piste is looked for on a grid of bearings times logarithms of range: cells of it look alike near
/// and far, and a straight boundary is a smooth line in it.
inline constexpr int kSectors = 180;
inline constexpr int kBins = 100;
inline constexpr float kFirstRange_m = 2.0F;
inline constexpr float kBinRatio = 0.04F;  ///< a bin is this share of its range long: as long as a sector is wide

/// First bin of a range, squared; up to 109 m.
[[nodiscard]] inline int bin_of(float range_squared_m2) {
  const float bin = (0.5F / kBinRatio) * std::log(range_squared_m2 / (kFirstRange_m * kFirstRange_m));
  return std::clamp(static_cast<int>(std::max(bin, 0.0F)), 0, kBins - 1);
}

/// Range at which bin `bin` begins.
[[nodiscard]] inline float range_of(int bin) {
  return kFirstRange_m * std::exp(kBinRatio * static_cast<float>(bin));
}

[[nodiscard]] inline float bearing_of(int sector) {
  constexpr float kStep_rad = 2.0F * std::numbers::pi_v<float> / static_cast<float>(kSectors);
  return (static_cast<float>(sector) + 0.5F) * kStep_rad - std::numbers::pi_v<float>;
}

/// Sector of a bearing without trigonometry: y / (|x| + |y|), turned into a number that rises with the bearing, is
/// looked up. Sector 0 begins straight behind and they go counterclockwise, seen from above. Borders of sectors are
/// met to a twentieth of a sector.
class SectorTable {
 public:
  SectorTable() {
    for (std::size_t i = 0; i < sectors_.size(); ++i) {
      const double turn = (static_cast<double>(i) + 0.5) / kPerQuadrant - 2.0;  // -2 and 2: straight behind
      const double y = turn < -1.0 ? -2.0 - turn : (turn > 1.0 ? 2.0 - turn : turn);
      const double x = 1.0 - std::abs(turn);
      const double share = (std::atan2(y, x) + std::numbers::pi) / (2.0 * std::numbers::pi);
      sectors_[i] = static_cast<std::uint8_t>(std::min(static_cast<int>(share * kSectors), kSectors - 1));
    }
  }

  [[nodiscard]] int operator()(float x, float y) const {
    const float sum = std::abs(x) + std::abs(y);
    const float slant = sum > 0.0F ? y / sum : 0.0F;
    const float turn = x >= 0.0F ? slant : std::copysign(2.0F, y) - slant;
    const auto place = static_cast<int>((turn + 2.0F) * static_cast<float>(kPerQuadrant));
    return sectors_[static_cast<std::size_t>(std::clamp(place, 0, static_cast<int>(sectors_.size()) - 1))];
  }

 private:
  static constexpr int kPerQuadrant = 1024;
  std::array<std::uint8_t, 4 * kPerQuadrant> sectors_;
};

}  // namespace berm::bearing_grid
