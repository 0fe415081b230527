#include "berm/snow/box_snow.hpp"

#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "berm/core/error.hpp"

namespace berm {
namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

std::vector<int> marks(const PointChannels& channels, const Pose& T_base_sensor = {}) {
  const PointCloud cloud{PointChannels(channels)};
  BoxSnow box({});
  const SnowResult result = box.process(cloud.view(), T_base_sensor);
  return {result.falling.begin(), result.falling.end()};
}

TEST(BoxSnow, NothingComesOfNothing) {
  const PointCloud cloud;
  BoxSnow box({});
  const SnowResult result = box.process(cloud.view(), {});
  EXPECT_EQ(result.count, 0U);
  EXPECT_TRUE(result.limits.no_points);
}

TEST(BoxSnow, TheBoxIsOpenAndTheIntensitiesAreClosed) {
  const PointChannels channels = {.x = {2.0F, 2.001F, 5.999F, 6.0F, 4.0F, 4.0F, 4.0F, -4.0F},
                                  .y = {0, 0, 0, 0, 0, 0, 30.0F, 0},
                                  .z = {0, 0, 0, 0, 0, 0, 0, 0},
                                  .intensity = {0, 0, 4.0F, 0, 4.001F, -1.0F, 2.0F, 0}};
  EXPECT_EQ(marks(channels), (std::vector<int>{0, 1, 1, 0, 0, 0, 1, 0}));
}

TEST(BoxSnow, IsMeasuredAheadOfTheMachine) {
  // Nose down by 60 degrees: a point 6 m along the beam lies 3 m ahead of the sensor, which sits 1 m ahead.
  const Pose T_base_sensor = Pose::from_yaw_pitch_roll(0.0, std::numbers::pi / 3.0, 0.0, {1.0, 0.0, 3.0});
  const PointChannels channels = {.x = {6.0F, 1.9F, 10.2F}, .y = {0, 0, 0}, .z = {0, 0, 0}, .intensity = {0, 0, 0}};
  EXPECT_EQ(marks(channels, T_base_sensor), (std::vector<int>{1, 0, 0}));
}

TEST(BoxSnow, WhatIsNoPointIsNoFlake) {
  // In the base frame the no-return would lie in the box.
  const Pose T_base_sensor = Pose::from_yaw_pitch_roll(0.0, 0.0, 0.0, {3.0, 0.0, 2.0});
  const PointChannels channels = {.x = {0, kNan, 1.0F, 1.0F, 1.0F},
                                  .y = {0, 0, kNan, 1e30F, 0},
                                  .z = {0, 0, 0, 0, 0},
                                  .intensity = {0, 0, 0, 0, kNan}};
  EXPECT_EQ(marks(channels, T_base_sensor), (std::vector<int>{0, 0, 0, 0, 0}));
}

TEST(BoxSnow, WithoutIntensityThereIsNoFlake) {
  const PointCloud cloud(PointChannels{.x = {3.0F, 4.0F}, .y = {0, 0}, .z = {0, 0}});
  BoxSnow box({});
  const SnowResult result = box.process(cloud.view(), {});
  EXPECT_EQ(result.count, 0U);
  EXPECT_EQ(result.falling.size(), 2U);
  EXPECT_TRUE(result.limits.no_intensity);
  EXPECT_TRUE(result.limits.no_returns_dropped);
  EXPECT_FALSE(result.limits.no_points);
}

TEST(BoxSnow, ABoxWithoutRoomIsRefused) {
  EXPECT_THROW(BoxSnow({.min_x_m = 6.0, .max_x_m = 6.0}), ConfigError);
  EXPECT_THROW(BoxSnow({.max_intensity = 300.0}), ConfigError);
}

}  // namespace
}  // namespace berm
