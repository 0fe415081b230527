#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "berm/snow/snow.hpp"

namespace berm::bench {

/// The rule that every snow filter has to beat: nearer than 17 m and intensity 0.
class BareRule final : public SnowFilter {
 public:
  [[nodiscard]] SnowResult process(const PointsView& points, const Pose& /*T_base_sensor*/) override {
    constexpr float kMaxRange_m = 17.0F;
    falling_.assign(points.size(), 0);
    std::size_t count = 0;
    for (std::size_t i = 0; i < points.intensity.size(); ++i) {
      const float square = points.x[i] * points.x[i] + points.y[i] * points.y[i] + points.z[i] * points.z[i];
      const bool flake = (square > 0.0F) & (square < kMaxRange_m * kMaxRange_m) & (points.intensity[i] == 0.0F);
      falling_[i] = flake ? 1 : 0;
      count += flake ? 1U : 0U;
    }
    return {.falling = falling_, .count = count, .limits = {}};
  }

 private:
  std::vector<std::uint8_t> falling_;
};

}  // namespace berm::bench
