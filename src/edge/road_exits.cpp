#include "road_exits.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace berm {
namespace {

constexpr float kHalfTurn_rad = std::numbers::pi_v<float>;
constexpr float kFarShare = 0.7F;  // of the farthest: what is seen so far counts
/// No road bends away more sharply within the range of a sensor: the chord of 40 m in a bend of 30 m radius leaves at
/// 42 degrees, more if the machine drives askew. What lies beyond is seen over a berm, or where dust hides the road.
constexpr float kAside_rad = kHalfTurn_rad / 3.0F;
constexpr float kLessAside = 0.6F;  // of the bearing, whose cosine a range counts by: roads go on rather than turn

/// Mean bearing, from the direction `middle_rad`, of the sectors near it that are seen far.
float exit_bearing(std::span<const float> reach_m, float middle_rad) {
  const auto count = static_cast<int>(reach_m.size());
  const float step_rad = 2.0F * kHalfTurn_rad / static_cast<float>(count);
  const auto aside = static_cast<int>(std::lround(kAside_rad / step_rad));
  const auto first = static_cast<int>(std::lround((middle_rad + kHalfTurn_rad) / step_rad)) - aside;
  const auto bearing_rad = [&](int i) { return (static_cast<float>(i - aside) + 0.5F) * step_rad; };
  const auto reach = [&](int i) {
    return std::cos(kLessAside * bearing_rad(i)) * reach_m[static_cast<std::size_t>((first + i + count) % count)];
  };
  float farthest_m = 0.0F;
  for (int i = 0; i < 2 * aside; ++i) {
    farthest_m = std::max(farthest_m, reach(i));
  }
  float sum = 0.0F;
  float weights = 1e-6F;
  for (int i = 0; i < 2 * aside; ++i) {
    const float weight = std::max(reach(i) - kFarShare * farthest_m, 0.0F);
    sum += weight * bearing_rad(i);
    weights += weight;
  }
  return middle_rad + sum / weights;
}

}  // namespace

RoadDivide find_exits(const Traces& traces, std::span<const std::uint8_t> on_road, const RoadView& view) {
  std::array<float, RoadView::kSectors> reach_m{};
  for (std::size_t i = 0; i < on_road.size(); ++i) {
    if (on_road[i] != 0 && !view.hides(traces.x[i], traces.y[i])) {
      float& reach = reach_m[view.sector_of(traces.x[i], traces.y[i])];
      reach = std::max(reach, traces.x[i] * traces.x[i] + traces.y[i] * traces.y[i]);
    }
  }
  for (float& reach : reach_m) {
    reach = std::sqrt(reach);
  }
  return {.ahead_rad = exit_bearing(reach_m, 0.0F), .behind_rad = exit_bearing(reach_m, kHalfTurn_rad)};
}

}  // namespace berm
