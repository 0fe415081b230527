#include <limits>

#include <gtest/gtest.h>

#include "berm/core/error.hpp"
#include "berm/core/stamp.hpp"
#include "berm/odometry/surface_odometry.hpp"
#include "odometry/made_drive.hpp"

namespace berm {
namespace {

using test::made_yard;
using test::MadeScan;
using test::straight;

TEST(OdometryBadInput, RefusesLabelsOfAnotherNumber) {
  SurfaceOdometry odometry({});
  MadeScan scan(made_yard(), straight(0.0), 0.0);
  scan.labels.pop_back();
  EXPECT_THROW((void)odometry.process(scan.input()), Error);
}

TEST(OdometryBadInput, RefusesStampsThatDoNotRise) {
  SurfaceOdometry odometry({});
  const MadeScan scan(made_yard(), straight(0.0), 0.0);
  (void)odometry.process(scan.input());
  EXPECT_THROW((void)odometry.process(scan.input()), Error);
}

TEST(OdometryBadInput, RefusesAConfigurationOutOfRange) {
  EXPECT_THROW(SurfaceOdometry({.fine_voxel_m = 0.0}), ConfigError);
}

TEST(OdometryBadInput, LivesOnNothing) {
  SurfaceOdometry odometry({});
  for (int i = 0; i < 60; ++i) {
    const OdometryResult result = odometry.process({.stamp_ns = from_seconds(0.1 * i)});
    EXPECT_TRUE(result.T_world_end.matrix().allFinite());
    EXPECT_EQ(result.samples, 0U);
  }
}

TEST(OdometryBadInput, LivesOnNaNAndFivePoints) {
  SurfaceOdometry odometry({});
  const float nan = std::numeric_limits<float>::quiet_NaN();
  for (int i = 0; i < 60; ++i) {
    MadeScan scan({}, straight(1.0), 0.1 * i);
    scan.channels = {};
    scan.channels.x = {5.0F, nan, 6.0F, 7.0F, std::numeric_limits<float>::infinity()};
    scan.channels.y = {1.0F, 1.0F, nan, 2.0F, 3.0F};
    scan.channels.z = {-2.0F, -1.0F, 0.0F, 1.0F, 0.0F};
    scan.channels.time = {0.0F, nan, 0.02F, nan, 0.1F};
    scan.labels.assign(5, Label::obstacle);
    EXPECT_TRUE(odometry.process(scan.input()).T_world_end.matrix().allFinite());
  }
}

TEST(OdometryBadInput, GoesOnAfterScansThatAreLost) {
  SurfaceOdometry odometry({});
  const auto motion = straight(1.5);
  Pose last;
  for (int i = 0; i < 80; ++i) {
    if (i >= 40 && i < 50) {
      continue;  // a second without scans
    }
    last = odometry.process(MadeScan(made_yard(), motion, 0.1 * i).input()).T_world_begin;
  }
  EXPECT_LT((last.translation_m() - motion(7.9).translation_m()).norm(), 0.06);
}

TEST(OdometryBadInput, PointsWithoutTimesAreTakenAtTheStamp) {
  SurfaceOdometry odometry({});
  const MadeScan model(made_yard(), straight(0.0), 0.0);
  for (int i = 0; i < 40; ++i) {
    // As if the machine had moved between the scans only.
    const Pose T_world_base(Eigen::Quaterniond::Identity(), {0.15 * i, 0.0, 0.0});
    MadeScan scan(
        made_yard(), [&T_world_base](double) { return T_world_base; }, 0.1 * i);
    scan.channels.time.clear();
    const OdometryResult result = odometry.process(scan.input());
    EXPECT_EQ(result.duration_s, 0.0);
    if (i > 25) {
      EXPECT_LT((result.T_world_begin.translation_m() - T_world_base.translation_m()).norm(), 0.05) << "scan " << i;
    }
  }
}

TEST(OdometryBadInput, AnotherPlaceIsALostMachineAndANewMap) {
  SurfaceOdometry odometry({});
  for (int i = 0; i < 40; ++i) {
    (void)odometry.process(MadeScan(made_yard(), straight(0.0), 0.1 * i).input());
  }
  // Put into a shaft without ground, of which the map knows nothing.
  test::MadePlace shaft{.boxes = {}, .has_ground = false};
  shaft.boxes.push_back({{-3.0, 2.5, -5.0}, {3.0, 3.0, 9.0}});
  shaft.boxes.push_back({{-3.0, -3.0, -5.0}, {3.0, -2.5, 9.0}});
  std::size_t lost = 0;
  OdometryResult last;
  for (int i = 40; i < 100; ++i) {
    last = odometry.process(MadeScan(shaft, straight(0.0), 0.1 * i).input());
    lost += last.health == OdometryHealth::lost ? 1U : 0U;
  }
  EXPECT_GE(lost, 20U);
  EXPECT_EQ(last.session, 1U);
  EXPECT_NE(last.health, OdometryHealth::lost);
}

}  // namespace
}  // namespace berm
