#include "road_exits.hpp"

#include <cmath>
#include <cstdint>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

namespace berm {
namespace {

constexpr float kExitDegree = std::numbers::pi_v<float> / 180.0F;

/// Road along a bearing, seen up to a range.
void add_road(float bearing_deg, float range_m, Traces& traces) {
  for (float r = 10.0F; r <= range_m; r += 0.5F) {
    traces.x.push_back(r * std::cos(bearing_deg * kExitDegree));
    traces.y.push_back(r * std::sin(bearing_deg * kExitDegree));
  }
}

RoadDivide exits_of(const Traces& traces) {
  RoadView view;
  view.clear();
  return find_exits(traces, std::vector<std::uint8_t>(traces.x.size(), 1), view);
}

TEST(RoadExits, AreWhereTheRoadIsSeenFarthest) {
  Traces traces;
  add_road(25.0F, 38.0F, traces);
  add_road(-10.0F, 20.0F, traces);
  add_road(170.0F, 30.0F, traces);
  const RoadDivide exits = exits_of(traces);
  EXPECT_NEAR(exits.ahead_rad, 25.0F * kExitDegree, 4.0F * kExitDegree);
  EXPECT_NEAR(exits.behind_rad, 170.0F * kExitDegree, 4.0F * kExitDegree);
}

TEST(RoadExits, AreNotToTheSideWhereDustHidesTheRoadAhead) {
  Traces traces;
  add_road(10.0F, 18.0F, traces);
  add_road(65.0F, 35.0F, traces);
  EXPECT_NEAR(exits_of(traces).ahead_rad, 10.0F * kExitDegree, 4.0F * kExitDegree);
}

TEST(RoadExits, AreStraightWhereNoRoadIsSeen) {
  const RoadDivide exits = exits_of(Traces{});
  EXPECT_NEAR(exits.ahead_rad, 0.0F, 1e-3F);
  EXPECT_NEAR(std::abs(exits.behind_rad), 180.0F * kExitDegree, 1e-3F);
}

}  // namespace
}  // namespace berm
