#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "odometry/graph_made.hpp"

namespace berm {
namespace {

using Eigen::Vector3d;
using test::count_of;
using test::error_of;
using test::MadeDrive;
using test::MadeFixes;

PoseGraphResult solve(const MadeDrive& drive, const std::vector<Fix>& fixes, const PoseGraphConfig& config = {}) {
  return solve_pose_graph(drive.odometry(), fixes, {}, config);
}

TEST(PoseGraph, TheMadeOdometryDriftsAsOdometriesDo) {
  const MadeDrive drive{.seconds = 600.0};
  const double share = test::drift_share(drive.odometry(), drive);
  EXPECT_GT(share, 0.003);
  EXPECT_LT(share, 0.008);
}

TEST(PoseGraph, FollowsFixesToCentimetres) {
  const MadeDrive drive{.seconds = 600.0};
  const PoseGraphResult result = solve(drive, MadeFixes{}.of(drive));
  EXPECT_TRUE(result.is_in_world);
  EXPECT_TRUE(result.has_heading);
  EXPECT_EQ(result.trajectory.size(), 6000);
  EXPECT_LT(error_of(result.trajectory, drive).rms_m, 0.03);
  EXPECT_LT(error_of(result.trajectory, drive).most_m, 0.1);
  EXPECT_LT(error_of(result.trajectory, drive).most_rad, 0.02);
  EXPECT_EQ(result.time_offset_s, 0.0);
  EXPECT_GT(count_of(result, FixFate::used), 5900);
  EXPECT_THAT(result.notes, testing::IsEmpty());
}

TEST(PoseGraph, FindsTheAttitudeFromPositionsAlone) {
  const MadeDrive drive{.seconds = 300.0};
  const PoseGraphResult result = solve(drive, MadeFixes{.has_attitude = false}.of(drive));
  EXPECT_TRUE(result.has_heading);
  EXPECT_LT(error_of(result.trajectory, drive).rms_m, 0.05);
  EXPECT_LT(error_of(result.trajectory, drive).most_rad, 0.05);
}

TEST(PoseGraph, TakesTheAntennaOff) {
  const MadeDrive drive{.seconds = 200.0};
  MadeFixes fixes;
  fixes.antenna_m = Vector3d(-1.2, 0.4, 2.9);
  PoseGraphConfig config;
  config.antenna_x_m = -1.2;
  config.antenna_y_m = 0.4;
  config.antenna_z_m = 2.9;
  EXPECT_LT(error_of(solve(drive, fixes.of(drive), config).trajectory, drive).rms_m, 0.04);
  EXPECT_GT(error_of(solve(drive, fixes.of(drive)).trajectory, drive).rms_m, 1.0);
}

TEST(PoseGraph, BridgesAMinuteWithoutFixes) {
  for (const double speed_mps : {1.5, 3.0}) {
    const MadeDrive drive{.seconds = 300.0, .speed_mps = speed_mps};
    const auto fixes = test::without(MadeFixes{}.of(drive), 100.0, 160.0);
    const PoseGraphResult result = solve(drive, fixes);
    EXPECT_LT(error_of(result.trajectory, drive).most_m, 0.5) << speed_mps;
    EXPECT_LT(error_of(result.trajectory, drive).rms_m, 0.2) << speed_mps;
  }
}

TEST(PoseGraph, StraightensALongDriveThatTurnedAway) {
  const MadeDrive drive{.seconds = 1200.0, .speed_mps = 8.0};
  for (const bool has_attitude : {true, false}) {
    auto fixes = MadeFixes{.rate_hz = 5.0, .has_attitude = has_attitude}.of(drive);
    fixes = test::moved(fixes, 300.0, 305.0, Vector3d(30.0, 40.0, 3.0));
    EXPECT_LT(error_of(solve(drive, fixes).trajectory, drive).rms_m, 0.1) << has_attitude;
  }
}

TEST(PoseGraph, GoesOnWhereFixesEnd) {
  const MadeDrive drive{.seconds = 200.0};
  const auto fixes = test::without(MadeFixes{}.of(drive), 140.0, 1e6);
  const PoseGraphResult result = solve(drive, fixes);
  EXPECT_LT(error_of(result.trajectory, drive, 0.0, 140.0).rms_m, 0.05);
  EXPECT_LT(error_of(result.trajectory, drive).most_m, 1.5);  // 90 m on its own
  // and knows that it is less sure there.
  EXPECT_GT(result.nodes.back().covariance(0, 0), 25.0 * result.nodes[50].covariance(0, 0));
}

TEST(PoseGraph, LeavesJumpsOut) {
  const MadeDrive drive{.seconds = 300.0};
  const auto all = MadeFixes{}.of(drive);
  const double clean_m = error_of(solve(drive, all).trajectory, drive).most_m;
  for (const double jump_m : {1.0, 5.0, 50.0}) {
    const auto fixes = test::moved(all, 150.0, 155.0, Vector3d(0.6 * jump_m, -0.8 * jump_m, 0.1 * jump_m));
    const PoseGraphResult result = solve(drive, fixes);
    EXPECT_LT(error_of(result.trajectory, drive).most_m, clean_m + 0.15) << jump_m;
    EXPECT_GE(count_of(result, FixFate::jump) + count_of(result, FixFate::outvoted), 40) << jump_m;
    EXPECT_LE(count_of(result, FixFate::jump) + count_of(result, FixFate::outvoted), 80) << jump_m;
  }
}

TEST(PoseGraph, SurvivesManyJumps) {
  const MadeDrive drive{.seconds = 600.0};
  auto fixes = MadeFixes{.has_attitude = false}.of(drive);
  for (int i = 0; i < 12; ++i) {
    const double at_s = 20.0 + 48.0 * i;
    fixes = test::moved(fixes, at_s, at_s + 3.0 + i, Vector3d(std::cos(i) * (2.0 + 4.0 * i), std::sin(i) * 8.0, 3.0));
  }
  const PoseGraphResult result = solve(drive, fixes);
  EXPECT_LT(error_of(result.trajectory, drive).rms_m, 0.1);
  EXPECT_LT(error_of(result.trajectory, drive).most_m, 0.4);
}

TEST(PoseGraph, LeavesAJumpAtTheBeginOut) {
  const MadeDrive drive{.seconds = 200.0};
  const auto fixes = test::moved(MadeFixes{.has_attitude = false}.of(drive), 0.0, 15.0, Vector3d(20.0, 5.0, -3.0));
  EXPECT_LT(error_of(solve(drive, fixes).trajectory, drive).most_m, 0.5);
}

TEST(PoseGraph, LeavesSingleWildFixesOut) {
  const MadeDrive drive{.seconds = 300.0};
  auto fixes = MadeFixes{}.of(drive);
  for (std::size_t i = 5; i < fixes.size(); i += 10) {
    fixes[i].position_m += Vector3d(3.0, 0.0, -7.0);
  }
  const PoseGraphResult result = solve(drive, fixes);
  EXPECT_LT(error_of(result.trajectory, drive).rms_m, 0.05);
  EXPECT_GE(count_of(result, FixFate::jump) + count_of(result, FixFate::outvoted), 295);
}

TEST(PoseGraph, BelievesPoorFixesLess) {
  // Said to be of 2 cm, but of half a metre: the odometry must not be bent to follow their noise.
  const MadeDrive drive{.seconds = 300.0};
  auto fixes = MadeFixes{.sigma_m = 0.5}.of(drive);
  for (Fix& fix : fixes) {
    fix.sigma_m.setConstant(0.02);
  }
  EXPECT_LT(error_of(solve(drive, fixes).trajectory, drive).rms_m, 0.3);
}

TEST(PoseGraph, FindsTheClock) {
  for (const double late_s : {-0.8, -0.25, 0.12, 0.6}) {
    for (const bool has_attitude : {true, false}) {
      const MadeDrive drive{.seconds = 300.0};
      const MadeFixes made{.has_attitude = has_attitude, .clock_late_s = late_s};
      const PoseGraphResult result = solve(drive, made.of(drive));
      EXPECT_NEAR(result.time_offset_s, -late_s, 0.03) << late_s << has_attitude;
      EXPECT_LT(error_of(result.trajectory, drive).rms_m, 0.1) << late_s << has_attitude;
      EXPECT_THAT(result.notes, testing::ElementsAre(testing::HasSubstr("clock")));
    }
  }
}

TEST(PoseGraph, LeavesAClockAloneOfWhichTheDriveSaysNothing) {
  const MadeDrive drive{.seconds = 300.0, .is_even = true};
  const PoseGraphResult result = solve(drive, MadeFixes{.has_attitude = false}.of(drive));
  EXPECT_EQ(result.time_offset_s, 0.0);
  EXPECT_LT(error_of(result.trajectory, drive).rms_m, 0.05);
}

TEST(PoseGraph, RefusesAClockThatIsFarOff) {
  const MadeDrive drive{.seconds = 300.0, .speed_mps = 5.0};
  const auto odometry = drive.odometry();
  const PoseGraphResult result = solve(drive, MadeFixes{.clock_late_s = 18.0}.of(drive));
  EXPECT_FALSE(result.is_in_world);
  EXPECT_THAT(result.notes, testing::Contains(testing::HasSubstr("refused")));
  EXPECT_GT(count_of(result, FixFate::refused), 0);
  ASSERT_EQ(result.trajectory.size(), odometry.size());
  EXPECT_EQ(result.trajectory.poses()[700].T_world_base.matrix(), odometry[700].T_odom_base.matrix());
}

TEST(PoseGraph, TakesMadeUpTiltForNothing) {
  // A log without roll and pitch, on a slope of 17 degrees.
  const MadeDrive drive{.seconds = 300.0};
  auto fixes = MadeFixes{}.of(drive);
  for (Fix& fix : fixes) {
    const Eigen::Vector3d ahead = *fix.R_world_base * Eigen::Vector3d::UnitX();
    fix.R_world_base = Eigen::AngleAxisd(std::atan2(ahead.y(), ahead.x()), Eigen::Vector3d::UnitZ());
    fix.tilt_sigma_rad = Fix::kUnknown;
  }
  const PoseGraphResult result = solve(drive, fixes);
  EXPECT_LT(error_of(result.trajectory, drive).rms_m, 0.05);
  EXPECT_LT(error_of(result.trajectory, drive).most_rad, 0.06);
}

TEST(PoseGraph, JoinsSessionsByFixes) {
  const MadeDrive drive{.seconds = 300.0};
  auto odometry = drive.odometry();
  const Pose elsewhere = Pose::from_yaw_pitch_roll(2.0, 0.1, -0.2, Vector3d(500.0, -3.0, 20.0));
  for (std::size_t i = 1500; i < odometry.size(); ++i) {
    odometry[i].T_odom_base = elsewhere * odometry[i].T_odom_base;
    odometry[i].session = 1;
  }
  const PoseGraphResult result = solve_pose_graph(odometry, MadeFixes{}.of(drive), {}, {});
  EXPECT_LT(error_of(result.trajectory, drive).rms_m, 0.05);
}

TEST(PoseGraph, BridgesLostScansInAnOutage) {
  const MadeDrive drive{.seconds = 300.0};
  auto odometry = drive.odometry();
  const Pose slid = Pose::from_yaw_pitch_roll(0.05, 0.0, 0.0, Vector3d(1.5, -0.7, 0.1));
  for (std::size_t i = 1500; i < odometry.size(); ++i) {
    const Pose& before = odometry[1500].T_odom_base;
    odometry[i].T_odom_base = before * slid * before.inverse() * odometry[i].T_odom_base;
  }
  for (std::size_t i = 1495; i < 1515; ++i) {
    odometry[i].health = OdometryHealth::lost;
  }
  const auto fixes = test::without(MadeFixes{}.of(drive), 140.0, 160.0);
  EXPECT_LT(error_of(solve_pose_graph(odometry, fixes, {}, {}).trajectory, drive, 0.0, 149.0).most_m, 0.4);
  EXPECT_LT(error_of(solve_pose_graph(odometry, fixes, {}, {}).trajectory, drive, 152.0, 300.0).most_m, 0.4);
}

TEST(PoseGraph, SaysHowSureItIs) {
  // Of drives that are alike, errors are as large as the covariances say, within a factor.
  double share = 0.0;
  constexpr int kDrives = 6;
  for (int i = 0; i < kDrives; ++i) {
    const MadeDrive drive{.seconds = 200.0, .seed = static_cast<std::uint32_t>(10 + i)};
    const auto fixes = test::without(MadeFixes{.seed = static_cast<std::uint32_t>(100 + i)}.of(drive), 80.0, 140.0);
    const PoseGraphResult result = solve(drive, fixes);
    for (const GraphNode& node : result.nodes) {
      const Vector3d off_m =
          node.T_world_base.translation_m() - drive.truth(0.1 * static_cast<double>(node.step)).translation_m();
      const Eigen::Matrix3d covariance = node.covariance.topLeftCorner<3, 3>();
      share += off_m.dot(covariance.ldlt().solve(off_m)) / 3.0 / static_cast<double>(result.nodes.size()) / kDrives;
    }
  }
  EXPECT_GT(share, 0.1);
  EXPECT_LT(share, 4.0);
}

}  // namespace
}  // namespace berm
