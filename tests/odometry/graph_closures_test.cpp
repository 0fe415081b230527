#include <cmath>
#include <numbers>
#include <random>

#include <gtest/gtest.h>

#include "berm/odometry/pose_graph_places.hpp"
#include "odometry/graph_made.hpp"
#include "odometry/made_drive.hpp"

namespace berm {
namespace {

using Eigen::Vector3d;
using test::count_of;

/// Up the yard and down again, on another track 2 m beside; a scan a metre.
struct UpAndDown {
  double length_m = 60.0;

  [[nodiscard]] std::size_t scans() const { return static_cast<std::size_t>(2.0 * length_m + 10.0); }
  [[nodiscard]] Pose truth(double way_m) const {
    // A half turn of 10 m, which passes the end of the yard.
    const double bend = std::clamp((way_m - length_m) / 10.0, 0.0, 1.0) * std::numbers::pi;
    const double x_m = way_m < length_m ? way_m : length_m - std::max(0.0, way_m - length_m - 10.0);
    const double radius_m = 1.0;
    return Pose::from_yaw_pitch_roll(bend, 0.0, 0.0,
                                     Vector3d(x_m + radius_m * std::sin(bend), radius_m * (1.0 - std::cos(bend)), 0.0));
  }
};

/// The drive as an odometry has it that drifts, and what it remembers of the places.
struct Driven {
  std::vector<OdometryStep> odometry;
  PlaceMemory places;
  std::vector<Pose> truth;

  /// `seen`: what is there at a scan.
  template <typename Seen>
  Driven(const UpAndDown& drive, const Vector6d& drift_per_m, const Seen& seen) {
    Pose T_odom_base;
    for (std::size_t i = 0; i < drive.scans(); ++i) {
      truth.push_back(drive.truth(static_cast<double>(i)));
      if (i > 0) {
        T_odom_base = T_odom_base * truth[i - 1].inverse() * truth[i] * Pose::exp(drift_per_m);
      }
      const Pose here = truth.back();
      const test::MadeScan scan(
          seen(i), [&here](double) { return here; }, static_cast<double>(i));
      odometry.push_back({.stamp_ns = from_seconds(static_cast<double>(i)), .T_odom_base = T_odom_base});
      OdometryResult result;
      result.T_world_begin = T_odom_base;
      result.T_world_end = T_odom_base;
      places.add(i, scan.input(), result);
    }
  }

  [[nodiscard]] double end_error_m(const Trajectory& trajectory) const {
    const Pose& end = trajectory.poses().back().T_world_base;
    return (end.translation_m() - (truth.front().inverse() * truth.back()).translation_m()).norm();
  }
};

Vector6d drift(double share, double yaw_rad_per_m) {
  Vector6d twist;
  twist << share, 0.0, 0.3 * share, 0.0, 0.0, yaw_rad_per_m;
  return twist;
}

PoseGraphConfig on_gaps() {
  PoseGraphConfig config;  // steps are a second apart here
  config.closure_detour_m = 20.0;
  return config;
}

TEST(Closures, BringAPisteDrivenUpAndDownTogether) {
  const test::MadePlace yard = test::made_yard();
  const Driven driven(UpAndDown{}, drift(0.006, 0.0004), [&](std::size_t) -> const test::MadePlace& { return yard; });
  const PoseGraphConfig config = on_gaps();
  const PoseGraphResult odometry = solve_pose_graph(driven.odometry, {}, {}, config);
  const double before_m = driven.end_error_m(odometry.trajectory);
  EXPECT_GT(before_m, 1.0);
  const FoundClosures found = driven.places.find(driven.odometry, odometry, config);
  ASSERT_GE(found.closures.size(), 3);
  for (const Closure& closure : found.closures) {
    const Pose truth = driven.truth[closure.first].inverse() * driven.truth[closure.second];
    EXPECT_LT((truth.inverse() * closure.T_first_second).translation_m().norm(), 0.25);
    EXPECT_LT((truth.inverse() * closure.T_first_second).log().tail<3>().norm(), 0.02);
  }
  const PoseGraphResult closed = solve_pose_graph(driven.odometry, {}, found.closures, config);
  EXPECT_EQ(count_of(closed, ClosureFate::used), found.closures.size());
  EXPECT_LT(driven.end_error_m(closed.trajectory), 0.3 * before_m);
  EXPECT_FALSE(closed.is_in_world);
  EXPECT_EQ(closed.trajectory.poses().front().T_world_base.matrix(), Pose().matrix());
}

TEST(Closures, AreNotFoundWhereThePlaceIsAnother) {
  // The way back leads through a yard that is the mirror image: the odometry says the same place, the walls do not.
  const test::MadePlace yard = test::made_yard();
  test::MadePlace other;
  for (test::Box box : yard.boxes) {
    const Vector3d off_m(std::fmod(box.low_m.x(), 3.1), 1.3, 0.0);
    const double low_m = -box.high_m.y();
    box.high_m.y() = -box.low_m.y();
    box.low_m.y() = low_m;
    box.low_m += off_m;
    box.high_m += off_m;
    other.boxes.push_back(box);
  }
  const UpAndDown drive;
  const Driven driven(drive, drift(0.001, 0.0), [&](std::size_t i) -> const test::MadePlace& {
    return static_cast<double>(i) < drive.length_m + 5.0 ? yard : other;
  });
  const PoseGraphConfig config = on_gaps();
  const PoseGraphResult odometry = solve_pose_graph(driven.odometry, {}, {}, config);
  const FoundClosures found = driven.places.find(driven.odometry, odometry, config);
  const PoseGraphResult closed = solve_pose_graph(driven.odometry, {}, found.closures, config);
  EXPECT_LT(driven.end_error_m(closed.trajectory), driven.end_error_m(odometry.trajectory) + 0.3);
}

TEST(Closures, OnBareGroundSayNothingOfTheWayAlongIt) {
  const test::MadePlace ground = test::bare_ground();
  const Driven driven(UpAndDown{}, drift(0.006, 0.0004), [&](std::size_t) -> const test::MadePlace& { return ground; });
  const PoseGraphConfig config = on_gaps();
  const PoseGraphResult odometry = solve_pose_graph(driven.odometry, {}, {}, config);
  const FoundClosures found = driven.places.find(driven.odometry, odometry, config);
  const PoseGraphResult closed = solve_pose_graph(driven.odometry, {}, found.closures, config);
  for (std::size_t i = 0; i < odometry.trajectory.size(); ++i) {
    const Vector3d off_m = closed.trajectory.poses()[i].T_world_base.translation_m() -
                           odometry.trajectory.poses()[i].T_world_base.translation_m();
    EXPECT_LT(off_m.head<2>().norm(), 0.3);
  }
}

TEST(Closures, FalseOnesDoNotBendThePath) {
  const test::MadeDrive drive{.seconds = 300.0};
  const auto odometry = drive.odometry();
  const PoseGraphResult alone = solve_pose_graph(odometry, {}, {}, {});
  std::mt19937 random(3);
  std::uniform_int_distribution<std::size_t> any(0, odometry.size() - 1);
  std::vector<Closure> closures;
  Matrix6d covariance = Matrix6d::Zero();
  covariance.diagonal() << 1e-2, 1e-2, 1e-2, 1e-4, 1e-4, 1e-4;
  for (int i = 0; i < 12; ++i) {
    const std::size_t first = any(random);
    const std::size_t second = any(random);
    closures.push_back(
        {first, second, Pose::from_yaw_pitch_roll(0.3 * i, 0.0, 0.0, Vector3d(1.0, 0.5 * i, 0.0)), covariance});
  }
  const PoseGraphResult result = solve_pose_graph(odometry, {}, closures, {});
  EXPECT_GE(count_of(result, ClosureFate::outvoted), 11);
  for (std::size_t i = 0; i < odometry.size(); i += 50) {
    const Vector3d off_m = result.trajectory.poses()[i].T_world_base.translation_m() -
                           alone.trajectory.poses()[i].T_world_base.translation_m();
    EXPECT_LT(off_m.norm(), 1.0);
  }
}

TEST(Closures, WithoutFixesTheFirstNodeIsHeldAndTheNextIsAsSureAsItsLink) {
  const auto odometry = test::MadeDrive{.seconds = 60.0}.odometry();
  const std::vector<Closure> closures = {{0, odometry.size() - 1, odometry.back().T_odom_base, Matrix6d::Identity()}};
  const PoseGraphConfig config;
  const PoseGraphResult result = solve_pose_graph(odometry, {}, closures, config);
  ASSERT_GT(result.nodes.size(), 2U);
  EXPECT_LT(result.nodes[0].covariance.diagonal().maxCoeff(), 1e-10);
  const double way_m = result.trajectory.poses()[result.nodes[1].step].T_world_base.translation_m().norm();
  const double expected_m2 = config.drift_m_per_sqrt_m * config.drift_m_per_sqrt_m * way_m;
  EXPECT_NEAR(result.nodes[1].covariance(0, 0), expected_m2, 0.2 * expected_m2);
}

TEST(Closures, TrueOnesSurviveFalseOnes) {
  // There and back on a circle: the second lap is the first.
  const test::MadeDrive drive{.seconds = 200.0};
  auto odometry = drive.odometry();
  const std::size_t lap = odometry.size();
  const auto there = odometry;
  std::vector<Closure> closures;
  Matrix6d covariance = Matrix6d::Zero();
  covariance.diagonal() << 4e-4, 4e-4, 4e-4, 1e-5, 1e-5, 1e-5;
  // Drives on backwards over its own way, with an error of 2 m where it turns.
  const Pose slip = Pose::from_yaw_pitch_roll(0.01, 0.0, 0.0, Vector3d(1.5, -1.0, 0.2));
  for (std::size_t i = 0; i + 1 < lap; ++i) {
    const OdometryStep& step = there[lap - 2 - i];
    const Pose& turn = there.back().T_odom_base;
    odometry.push_back({.stamp_ns = there.back().stamp_ns + from_seconds(0.1 * static_cast<double>(i + 1)),
                        .T_odom_base = turn * slip * turn.inverse() * step.T_odom_base,
                        .health = i == 0 ? OdometryHealth::lost : OdometryHealth::good});
    if (i % 200 == 150) {
      closures.push_back({lap - 2 - i, lap + i, Pose(), covariance});
      closures.push_back({i, lap + i, Pose::from_yaw_pitch_roll(1.0, 0.0, 0.0, Vector3d(2.0, 0.0, 0.0)), covariance});
    }
  }
  const PoseGraphResult result = solve_pose_graph(odometry, {}, closures, {});
  EXPECT_GE(count_of(result, ClosureFate::used), closures.size() / 2 - 1);
  const Vector3d off_m = result.trajectory.poses().back().T_world_base.translation_m();
  EXPECT_LT(off_m.norm(), 0.5);
}

}  // namespace
}  // namespace berm
