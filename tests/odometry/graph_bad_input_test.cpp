#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "berm/core/error.hpp"
#include "odometry/graph_made.hpp"

namespace berm {
namespace {

using Eigen::Vector3d;
using test::count_of;
using test::error_of;
using test::MadeDrive;
using test::MadeFixes;

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

TEST(PoseGraphBadInput, NothingAtAll) {
  const PoseGraphResult result = solve_pose_graph({}, {}, {}, {});
  EXPECT_TRUE(result.trajectory.empty());
  EXPECT_TRUE(result.nodes.empty());
}

TEST(PoseGraphBadInput, OneScan) {
  const MadeDrive drive{.seconds = 0.1};
  const auto odometry = drive.odometry();
  ASSERT_EQ(odometry.size(), 1);
  Fix fix;
  fix.position_m = Vector3d(1.0, 2.0, 3.0);
  const PoseGraphResult result = solve_pose_graph(odometry, std::vector<Fix>{fix}, {}, {});
  EXPECT_TRUE(result.is_in_world);
  EXPECT_FALSE(result.has_heading);
  ASSERT_EQ(result.trajectory.size(), 1);
  EXPECT_LT((result.trajectory.poses()[0].T_world_base.translation_m() - fix.position_m).norm(), 1e-6);
}

TEST(PoseGraphBadInput, OneFix) {
  const MadeDrive drive{.seconds = 30.0, .drift = 0.0};
  const auto odometry = drive.odometry();
  std::vector<Fix> fixes = {MadeFixes{.sigma_m = 1e-3, .attitude_sigma_rad = 1e-4}.of(drive)[150]};
  const PoseGraphResult placed = solve_pose_graph(odometry, fixes, {}, {});
  EXPECT_TRUE(placed.has_heading);
  EXPECT_LT(error_of(placed.trajectory, drive).most_m, 0.1);
  fixes[0].R_world_base.reset();
  const PoseGraphResult moved = solve_pose_graph(odometry, fixes, {}, {});
  EXPECT_TRUE(moved.is_in_world);
  EXPECT_FALSE(moved.has_heading);
  EXPECT_LT(error_of(moved.trajectory, drive, 14.9, 15.15).most_m, 0.4);
  // The shape of the path is that of the odometry.
  const auto& poses = moved.trajectory.poses();
  const Pose step = poses[10].T_world_base.inverse() * poses[200].T_world_base;
  EXPECT_LT((step.inverse() * odometry[10].T_odom_base.inverse() * odometry[200].T_odom_base).log().norm(), 1e-6);
}

TEST(PoseGraphBadInput, BrokenFixesAreCountedAndLeftOut) {
  const MadeDrive drive{.seconds = 100.0};
  auto fixes = MadeFixes{}.of(drive);
  for (std::size_t i = 0; i < 300; i += 3) {
    fixes[i].R_world_base->coeffs() << kNaN, 0.0, 0.0, 1.0;
    fixes[i + 1].R_world_base->coeffs().setZero();
  }
  for (std::size_t i = 300; i < 600; i += 4) {
    fixes[i].position_m.x() = kNaN;
    fixes[i + 1].sigma_m.setZero();
    fixes[i + 2].position_m.z() = std::numeric_limits<double>::infinity();
  }
  const PoseGraphResult result = solve_pose_graph(drive.odometry(), fixes, {}, {});
  EXPECT_NEAR(static_cast<double>(result.bad_attitudes), 200.0, 2.0);
  EXPECT_EQ(count_of(result, FixFate::not_finite), 225);
  EXPECT_LT(error_of(result.trajectory, drive).rms_m, 0.05);
}

TEST(PoseGraphBadInput, FixesOfAnotherDay) {
  const MadeDrive drive{.seconds = 20.0};
  const auto odometry = drive.odometry();
  const PoseGraphResult result = solve_pose_graph(odometry, MadeFixes{.clock_late_s = 86400.0}.of(drive), {}, {});
  EXPECT_FALSE(result.is_in_world);
  EXPECT_EQ(count_of(result, FixFate::no_scan), 200);
  EXPECT_EQ(result.trajectory.poses()[100].T_world_base.matrix(), odometry[100].T_odom_base.matrix());
}

TEST(PoseGraphBadInput, FixesThatAreNoise) {
  const MadeDrive drive{.seconds = 100.0};
  const auto odometry = drive.odometry();
  const auto fixes = MadeFixes{.sigma_m = 300.0, .has_attitude = false}.of(drive);
  const PoseGraphResult result = solve_pose_graph(odometry, fixes, {}, {});
  EXPECT_FALSE(result.is_in_world);
  EXPECT_FALSE(result.notes.empty());
}

TEST(PoseGraphBadInput, AMachineThatStands) {
  std::vector<OdometryStep> odometry;
  for (int i = 0; i < 6000; ++i) {
    odometry.push_back({.stamp_ns = from_seconds(0.1 * i)});
  }
  const MadeDrive still{.seconds = 600.0, .speed_mps = 0.0};
  const PoseGraphResult result = solve_pose_graph(odometry, MadeFixes{.has_attitude = false}.of(still), {}, {});
  EXPECT_LE(result.nodes.size(), 3);
  EXPECT_TRUE(result.is_in_world);
  EXPECT_FALSE(result.has_heading);
  EXPECT_LT(error_of(result.trajectory, still).most_m, 0.05);
}

TEST(PoseGraphBadInput, IsRefused) {
  auto odometry = MadeDrive{.seconds = 5.0}.odometry();
  std::swap(odometry[3].stamp_ns, odometry[4].stamp_ns);
  EXPECT_THROW((void)solve_pose_graph(odometry, {}, {}, {}), Error);
  odometry = MadeDrive{.seconds = 5.0}.odometry();
  odometry[7].T_odom_base = Pose(Eigen::Quaterniond::Identity(), Vector3d(0.0, kNaN, 0.0));
  EXPECT_THROW((void)solve_pose_graph(odometry, {}, {}, {}), Error);
  odometry = MadeDrive{.seconds = 5.0}.odometry();
  const std::vector<Closure> closures = {{.first = 2, .second = 50}};
  EXPECT_THROW((void)solve_pose_graph(odometry, {}, closures, {}), Error);
  PoseGraphConfig config;
  config.keyframe_m = 0.0;
  EXPECT_THROW((void)solve_pose_graph(odometry, {}, {}, config), ConfigError);
}

}  // namespace
}  // namespace berm
