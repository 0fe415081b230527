#include "berm/core/trajectory.hpp"

#include <limits>

#include <gtest/gtest.h>

#include "berm/core/error.hpp"

namespace berm {
namespace {

Pose at_x(double x_m) {
  return {Eigen::Quaterniond::Identity(), {x_m, 0.0, 0.0}};
}

TEST(Trajectory, KnowsNothingWhenEmpty) {
  const Trajectory trajectory;
  EXPECT_TRUE(trajectory.empty());
  EXPECT_FALSE(trajectory.at(0).has_value());
}

TEST(Trajectory, HasOnlyItsOwnStampWithOnePose) {
  Trajectory trajectory;
  trajectory.append(10, at_x(1.0));
  EXPECT_FALSE(trajectory.at(9).has_value());
  EXPECT_FALSE(trajectory.at(11).has_value());
  ASSERT_TRUE(trajectory.at(10).has_value());
  EXPECT_EQ(trajectory.at(10)->translation_m().x(), 1.0);
}

TEST(Trajectory, InterpolatesBetweenNeighbours) {
  Trajectory trajectory;
  trajectory.append(0, at_x(0.0));
  trajectory.append(100, at_x(10.0));
  trajectory.append(300, at_x(10.0));
  trajectory.append(400, at_x(50.0));
  EXPECT_NEAR(trajectory.at(25)->translation_m().x(), 2.5, 1e-12);
  EXPECT_NEAR(trajectory.at(200)->translation_m().x(), 10.0, 1e-12);
  EXPECT_NEAR(trajectory.at(399)->translation_m().x(), 49.6, 1e-12);
}

TEST(Trajectory, FollowsTheScrewOfATurn) {
  constexpr double kQuarter_rad = 1.57079632679489661923;
  // A quarter of a circle of radius 10 m: halfway lies on the circle, not on its chord.
  Trajectory trajectory;
  trajectory.append(0, Pose::from_yaw_pitch_roll(0.0, 0.0, 0.0, {0.0, -10.0, 0.0}));
  trajectory.append(100, Pose::from_yaw_pitch_roll(kQuarter_rad, 0.0, 0.0, {10.0, 0.0, 0.0}));
  const auto halfway = trajectory.at(50);
  ASSERT_TRUE(halfway.has_value());
  EXPECT_NEAR(halfway->translation_m().norm(), 10.0, 1e-12);
  EXPECT_NEAR(halfway->rotation().angularDistance(Eigen::Quaterniond::Identity()), 0.5 * kQuarter_rad, 1e-12);
}

TEST(Trajectory, GivesItsOwnPosesUnchanged) {
  Trajectory trajectory;
  const Pose pose = Pose::from_yaw_pitch_roll(0.1, 0.2, 0.3, {1e6, -5e6, 1e3});
  trajectory.append(-5, at_x(0.0));
  trajectory.append(7, pose);
  trajectory.append(9, at_x(1.0));
  EXPECT_TRUE(trajectory.at(7)->matrix() == pose.matrix());
}

TEST(Trajectory, KnowsNothingBeforeAndAfter) {
  Trajectory trajectory;
  trajectory.append(0, at_x(0.0));
  trajectory.append(100, at_x(1.0));
  EXPECT_FALSE(trajectory.at(-1).has_value());
  EXPECT_FALSE(trajectory.at(101).has_value());
  EXPECT_TRUE(trajectory.at(0).has_value());
  EXPECT_TRUE(trajectory.at(100).has_value());
}

TEST(Trajectory, RefusesStampsThatDoNotIncrease) {
  Trajectory trajectory;
  trajectory.append(10, at_x(1.0));
  EXPECT_THROW(trajectory.append(10, at_x(2.0)), Error);
  EXPECT_THROW(trajectory.append(9, at_x(2.0)), Error);
  EXPECT_EQ(trajectory.size(), 1U) << "what was refused must leave no trace";
  try {
    trajectory.append(10, at_x(2.0));
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::invalid_argument);
    EXPECT_STREQ(error.what(), "trajectory: stamp 10 ns does not come after 10 ns");
  }
}

TEST(Trajectory, TakesStampsAtBothEndsOfTime) {
  Trajectory trajectory;
  trajectory.append(std::numeric_limits<Stamp>::min(), at_x(0.0));
  trajectory.append(std::numeric_limits<Stamp>::max(), at_x(2.0));
  ASSERT_TRUE(trajectory.at(0).has_value());
  EXPECT_NEAR(trajectory.at(0)->translation_m().x(), 1.0, 1e-9);
}

}  // namespace
}  // namespace berm
