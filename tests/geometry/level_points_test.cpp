#include "berm/geometry/level_points.hpp"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <random>

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include "berm/geometry/bearing_grid.hpp"
#include "support/random_points.hpp"

namespace berm {
namespace {

TEST(LevelPoints, AreThePointsInTheLevelledFrame) {
  EXPECT_TRUE(rc::check([] {
    const Pose T_level_sensor =
        Pose::from_yaw_pitch_roll(*rc::gen::inRange(-30, 31) * 0.1, *rc::gen::inRange(-15, 16) * 0.1,
                                  *rc::gen::inRange(-30, 31) * 0.1, {1.0, -2.0, *rc::gen::inRange(-10, 50) * 0.1});
    std::mt19937 random(*rc::gen::arbitrary<std::uint32_t>());
    const auto coordinate = [&random] { return static_cast<float>(random() % 20001) * 0.01F - 100.0F; };
    PointChannels points;
    const std::size_t count = *rc::gen::inRange<std::size_t>(0, 50);
    for (std::size_t i = 0; i < count; ++i) {
      points.x.push_back(coordinate());
      points.y.push_back(coordinate());
      points.z.push_back(coordinate());
    }
    LevelPoints level;
    level.fill({.x = points.x, .y = points.y, .z = points.z}, T_level_sensor);
    RC_ASSERT(std::abs(double{level.sensor_height_m} - T_level_sensor.translation_m().z()) < 1e-6);
    RC_ASSERT(level.x.size() == count && level.y.size() == count && level.z.size() == count);
    RC_ASSERT(level.range2.size() == count && level.turn.size() == count);
    for (std::size_t i = 0; i < count; ++i) {
      const Eigen::Vector3d p = T_level_sensor * Eigen::Vector3d(points.x[i], points.y[i], points.z[i]);
      RC_ASSERT((p - Eigen::Vector3d(level.x[i], level.y[i], level.z[i])).norm() < 1e-3);
      RC_ASSERT(level.range2[i] == level.x[i] * level.x[i] + level.y[i] * level.y[i]);
      RC_ASSERT(level.turn[i] == bearing_grid::turn_of(level.x[i], level.y[i]));
    }
  }));
}

TEST(LevelPoints, OfAnyNumbersHaveABearingInTheTable) {
  const PointChannels points = test::random_points(5000, 1, {});
  LevelPoints level;
  level.fill({.x = points.x, .y = points.y, .z = points.z}, Pose::from_yaw_pitch_roll(1.0, 0.2, -0.3, {0.0, 0.0, 2.0}));
  for (const std::uint16_t turn : level.turn) {
    ASSERT_LT(turn, 4 * bearing_grid::kTurnsPerQuadrant);
  }
}

}  // namespace
}  // namespace berm
