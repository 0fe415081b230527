#pragma once

#include <cstdint>
#include <span>

namespace berm {

/// What divides the left of a road from its right (E step 4): two bearings from the sensor, where the road leaves the
/// view ahead and behind. Bearings in [-pi, pi], from x over y.
struct RoadDivide {
  float ahead_rad = 0.0F;
  float behind_rad = 3.14159265F;

  [[nodiscard]] bool is_left(float x_m, float y_m) const;
};

/// By the median of the sectors without an edge, ahead and behind apart; straight ahead, or straight behind, where
/// there is none. Sectors are counted from straight behind over the right; 1 in `has_edge`: there is an edge.
[[nodiscard]] RoadDivide divide_road(std::span<const std::uint8_t> has_edge);

}  // namespace berm
