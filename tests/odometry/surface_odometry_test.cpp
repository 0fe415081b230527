#include "berm/odometry/surface_odometry.hpp"

#include <algorithm>
#include <vector>

#include <gtest/gtest.h>

#include "odometry/made_drive.hpp"

namespace berm {
namespace {

using test::follow;
using test::made_yard;
using test::straight;

/// Largest distance between poses and the motion at the stamps of the scans, as seen from the pose of scan `from`.
double worst_m(const std::vector<Pose>& poses, const test::MadeMotion& motion, std::size_t from = 0,
               double scan_s = 0.1) {
  const auto truth_at = [&](std::size_t i) { return motion(scan_s * static_cast<double>(i)); };
  double worst = 0.0;
  for (std::size_t i = from; i < poses.size(); ++i) {
    const Pose truth = truth_at(from).inverse() * truth_at(i);
    const Pose estimate = poses[from].inverse() * poses[i];
    worst = std::max(worst, (estimate.translation_m() - truth.translation_m()).norm());
  }
  return worst;
}

TEST(SurfaceOdometry, FollowsSpeedsFromTheFirstScanOn) {
  for (const double speed_mps : {-1.0, 0.0, 0.4, 1.7, 3.3, 8.0}) {
    SurfaceOdometry odometry({});
    const auto motion = straight(speed_mps);
    EXPECT_LT(worst_m(follow(odometry, made_yard(), motion, 50), motion), 0.08) << speed_mps << " m/s";
  }
}

TEST(SurfaceOdometry, FollowsASlowMachineFromOneStart) {
  SurfaceOdometry odometry({.find_start = false});
  const auto motion = straight(0.4);
  EXPECT_LT(worst_m(follow(odometry, made_yard(), motion, 30), motion), 0.08);
}

TEST(SurfaceOdometry, FollowsABodyThatHeaves) {
  SurfaceOdometry odometry({});
  const auto motion = straight(1.5, 0.02);
  const std::vector<Pose> poses = follow(odometry, made_yard(), motion, 80);
  EXPECT_LT(worst_m(poses, motion, 20), 0.06) << "over 9 m";
  for (std::size_t i = 30; i < poses.size(); ++i) {
    const Pose truth = motion(2.0).inverse() * motion(0.1 * static_cast<double>(i));
    const Pose estimate = poses[20].inverse() * poses[i];
    EXPECT_LT(estimate.rotation().angularDistance(truth.rotation()), 0.005) << "scan " << i;
  }
}

// Two scans a second: the body heaves half way up and down within each, which no single screw does.
TEST(SurfaceOdometry, FollowsLongScansInParts) {
  constexpr std::size_t kTurns = 5;
  SurfaceOdometry odometry({});
  const auto motion = straight(1.5, 0.02);
  double duration_s = 0.0;
  const std::vector<Pose> poses = follow(
      odometry, made_yard(), motion, 16, [&](const OdometryResult& result) { duration_s = result.duration_s; }, kTurns);
  EXPECT_LT(worst_m(poses, motion, 0, 0.5), 0.1) << "over 11 m";
  EXPECT_NEAR(duration_s, 0.5, 1e-3);
}

TEST(SurfaceOdometry, DeskewIsWorthSomethingInATurn) {
  const test::MadeMotion turning = [](double time_s) {
    const double yaw_rad = 0.5 * time_s;
    return Pose::from_yaw_pitch_roll(yaw_rad, 0.0, 0.0,
                                     {4.0 * std::sin(yaw_rad), 4.0 * (1.0 - std::cos(yaw_rad)), 0.0});
  };
  SurfaceOdometry with({});
  SurfaceOdometry without({.deskew = false});
  const double error_with_m = worst_m(follow(with, made_yard(), turning, 60), turning, 20);
  const double error_without_m = worst_m(follow(without, made_yard(), turning, 60), turning, 20);
  EXPECT_LT(error_with_m, 0.06);
  EXPECT_GT(error_without_m, 2.0 * error_with_m);
}

TEST(SurfaceOdometry, SameScansSamePoses) {
  SurfaceOdometry one({});
  SurfaceOdometry other({});
  const auto a = follow(one, made_yard(), straight(1.2), 30);
  const auto b = follow(other, made_yard(), straight(1.2), 30);
  for (std::size_t i = 0; i < a.size(); ++i) {
    EXPECT_EQ(a[i].matrix(), b[i].matrix()) << "scan " << i;
  }
}

TEST(SurfaceOdometry, StandsStillForALongTime) {
  SurfaceOdometry odometry({});
  const auto poses = follow(odometry, made_yard(), straight(0.0), 400);
  EXPECT_LT(poses.back().translation_m().norm(), 0.02);
  const Pose since = poses[100].inverse() * poses.back();
  EXPECT_LT(since.translation_m().norm(), 0.003);
  EXPECT_LT(since.log().tail<3>().norm(), 0.001);
}

TEST(SurfaceOdometry, SaysWhereTheGroundIsBare) {
  SurfaceOdometry odometry({});
  std::size_t weak = 0;
  (void)follow(odometry, test::bare_ground(), straight(1.0), 60,
               [&weak](const OdometryResult& result) { weak += result.health == OdometryHealth::weak ? 1U : 0U; });
  EXPECT_GT(weak, 35U);

  SurfaceOdometry in_yard({});
  (void)follow(in_yard, made_yard(), straight(1.0), 60, [](const OdometryResult& result) {
    EXPECT_NE(result.health, OdometryHealth::weak);
    EXPECT_NE(result.health, OdometryHealth::lost);
  });
}

TEST(SurfaceOdometry, StartIsSaidAndEnds) {
  SurfaceOdometry odometry({});
  std::size_t scan = 0;
  (void)follow(odometry, made_yard(), straight(1.0), 30, [&scan](const OdometryResult& result) {
    ++scan;
    EXPECT_EQ(result.health, scan < 20 ? OdometryHealth::starting : OdometryHealth::good) << "scan " << scan;
    EXPECT_EQ(result.revised.size(), scan <= 20 ? scan - 1 : 0U) << "scan " << scan;
  });
}

TEST(SurfaceOdometry, CovarianceIsOneAndGrowsWithLessToSee) {
  const auto last_of = [](const test::MadePlace& place) {
    SurfaceOdometry odometry({});
    OdometryResult last;
    (void)follow(odometry, place, straight(1.0), 40, [&last](const OdometryResult& result) { last = result; });
    return last;
  };
  const OdometryResult yard = last_of(made_yard());
  const OdometryResult bare = last_of(test::bare_ground());
  EXPECT_TRUE(yard.covariance.isApprox(yard.covariance.transpose(), 1e-6));
  EXPECT_GT(yard.covariance.diagonal().minCoeff(), 0.0);
  EXPECT_GT(bare.covariance(0, 0), 2.0 * yard.covariance(0, 0));
}

TEST(SurfaceOdometry, FallingSnowIsNotSeen) {
  const auto motion = straight(1.0);
  SurfaceOdometry clear({});
  SurfaceOdometry snowy({});
  for (int i = 0; i < 25; ++i) {
    test::MadeScan scan(made_yard(), motion, 0.1 * i);
    const OdometryResult expected = clear.process(scan.input());
    for (int flake = 0; flake < 300; ++flake) {
      scan.channels.x.push_back(3.0F);
      scan.channels.y.push_back(0.01F * static_cast<float>(flake));
      scan.channels.z.push_back(0.1F);
      scan.channels.time.push_back(0.05F);
      scan.labels.push_back(Label::falling_snow);
    }
    EXPECT_EQ(snowy.process(scan.input()).T_world_end.matrix(), expected.T_world_end.matrix()) << "scan " << i;
  }
}

}  // namespace
}  // namespace berm
