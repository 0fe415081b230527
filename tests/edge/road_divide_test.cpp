#include "road_divide.hpp"

#include <cstddef>
#include <cstdint>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

namespace berm {
namespace {

constexpr std::size_t kSectors = 360;
constexpr float kDegree = std::numbers::pi_v<float> / 180.0F;

/// Edges everywhere but in the `count` sectors around each of the bearings.
std::vector<std::uint8_t> free_around(const std::vector<int>& bearings_deg, int count) {
  std::vector<std::uint8_t> has_edge(kSectors, 1);
  for (const int bearing : bearings_deg) {
    for (int i = -count; i < count; ++i) {
      has_edge[static_cast<std::size_t>((bearing + 180 + i + 360) % 360)] = 0;
    }
  }
  return has_edge;
}

TEST(RoadDivide, IsWhereTheRoadLeavesTheView) {
  const RoadDivide divide = divide_road(free_around({40, 170}, 10));
  EXPECT_NEAR(divide.ahead_rad, 40.0F * kDegree, 1.5F * kDegree);
  EXPECT_NEAR(divide.behind_rad, 170.0F * kDegree, 1.5F * kDegree);
}

TEST(RoadDivide, IsFoundAcrossStraightBehind) {
  const RoadDivide divide = divide_road(free_around({0, 179}, 10));
  EXPECT_TRUE(divide.is_left(-10.0F, 3.0F));
  EXPECT_FALSE(divide.is_left(-10.0F, -3.0F));
}

TEST(RoadDivide, PutsAPlaceInABendOnTheSideOfTheRoad) {
  const RoadDivide divide = divide_road(free_around({40, 150}, 10));
  EXPECT_TRUE(divide.is_left(0.0F, 10.0F));
  EXPECT_FALSE(divide.is_left(10.0F, 2.0F)) << "left of the nose, right of the road";
  EXPECT_FALSE(divide.is_left(-10.0F, 0.5F));
  EXPECT_FALSE(divide.is_left(0.0F, -10.0F));
}

TEST(RoadDivide, IsStraightAheadWhereNoSectorIsFree) {
  const RoadDivide divide = divide_road(std::vector<std::uint8_t>(kSectors, 1));
  EXPECT_TRUE(divide.is_left(1.0F, 0.1F));
  EXPECT_FALSE(divide.is_left(1.0F, -0.1F));
  EXPECT_TRUE(divide.is_left(-1.0F, 0.1F));
  EXPECT_FALSE(divide.is_left(-1.0F, -0.1F));
}

TEST(RoadDivide, IsStraightAheadOnAPlain) {
  const RoadDivide divide = divide_road(std::vector<std::uint8_t>(kSectors, 0));
  EXPECT_NEAR(divide.ahead_rad, 0.0F, 1.5F * kDegree);
  EXPECT_TRUE(divide.is_left(-5.0F, 1.0F));
}

}  // namespace
}  // namespace berm
