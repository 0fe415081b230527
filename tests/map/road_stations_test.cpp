#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "berm/map/road_survey.hpp"
#include "map/road_made.hpp"

namespace berm {
namespace {

using test::MadeRoad;
using test::MadeScan;

TEST(RoadStations, StationsLieEverySpacingAlongThePath) {
  const MadeRoad road;
  for (const double spacing_m : {0.2, 0.5, 1.0, 2.5, 10.0}) {
    RoadConfig config;
    config.spacing_m = spacing_m;
    const auto stations = RoadSurvey(config, road.path(0.0, 50.0)).stations({});
    ASSERT_EQ(stations.size(), static_cast<std::size_t>(std::lround(50.0 / spacing_m)) + 1) << spacing_m;
    for (std::size_t i = 0; i < stations.size(); ++i) {
      EXPECT_NEAR(stations[i].chainage_m, static_cast<double>(i) * spacing_m, 1e-9);
      EXPECT_LT((stations[i].position_m - road.at(stations[i].chainage_m, 0.0)).norm(), 1e-6);
      EXPECT_NEAR(stations[i].heading_rad, road.heading_rad, 1e-6);
      EXPECT_FALSE(stations[i].width_m || stations[i].grade || stations[i].left.edge_m);
      EXPECT_EQ(stations[i].width_rule, RuleVerdict::unknown);
    }
  }
}

TEST(RoadStations, ThereAndBackIsTwoPasses) {
  const MadeRoad road;
  Trajectory path = road.path(0.0, 60.0);
  for (const StampedPose& pose : road.poses(60.0, 0.0, 13.0)) {
    path.append(pose.stamp_ns, pose.T_world_base);
  }
  auto scans = test::made_scans(road, 0.0, 60.0, {}, 1);
  for (MadeScan scan : test::made_scans(road, 60.0, 0.0, {}, 2)) {
    scan.stamp_ns += 13'000'000'000;
    scans.push_back(std::move(scan));
  }
  // Both lines claim to be left ones: sides follow from where they lie.
  std::vector<EdgeLine> lines = road.lines(-5.0, 65.0);
  lines[1].side = EdgeSide::left;
  int back = 0;
  double last_m = 0.0;
  for (const RoadStation& station : test::survey({}, path, scans, lines)) {
    const bool is_back = station.piece == 1;
    EXPECT_GE(station.chainage_m, last_m);
    last_m = station.chainage_m;
    const double s_m = is_back ? 120.0 - station.chainage_m : station.chainage_m;
    if (s_m < 3.0 || s_m > 57.0) {
      continue;
    }
    back += is_back ? 1 : 0;
    EXPECT_LT((station.position_m - road.at(s_m, 0.0)).norm(), 1.0);
    EXPECT_NEAR(station.left.edge_m.value().value, is_back ? road.right_m : road.left_m, 0.05) << s_m;
    EXPECT_NEAR(station.left.berm_height_m.value().value, is_back ? road.right_berm_m : road.left_berm_m, 0.01);
    EXPECT_NEAR(station.grade.value().value, is_back ? -road.grade : road.grade, 0.003);
    EXPECT_NEAR(station.cross_fall.value().value, is_back ? -road.cross_fall : road.cross_fall, 0.004);
  }
  EXPECT_GT(back, 50);
}

TEST(RoadStations, AScanCountsForItsOwnPass) {
  // Two rounds of a circle; the second sees other berms.
  MadeRoad road;
  road.curvature = 1.0 / 30.0;
  road.grade = 0.0;
  road.left_m = 6.0;
  const double round_m = 2.0 * std::numbers::pi * 30.0;
  auto scans = test::made_scans(road, 0.0, 2.0 * round_m, {}, 1);
  MadeRoad later = road;
  later.left_berm_m = 2.0;
  const auto second = test::made_scans(later, 0.0, 2.0 * round_m, {}, 1);
  std::copy(second.begin() + std::lround(round_m), second.end(), scans.begin() + std::lround(round_m));
  int checked = 0;
  for (const RoadStation& station : test::survey({}, road.path(0.0, 2.0 * round_m), scans, road.lines(0.0, round_m))) {
    const double s_m = station.chainage_m;
    EXPECT_EQ(station.piece, 0U);
    if (station.left.berm_height_m && std::abs(s_m - round_m) > 42.0) {
      EXPECT_NEAR(station.left.berm_height_m->value, s_m < round_m ? road.left_berm_m : later.left_berm_m, 0.01);
      ++checked;
    }
  }
  EXPECT_GT(checked, 250);
}

TEST(RoadStations, NoStationsAcrossAJump) {
  const MadeRoad road;
  Trajectory path;
  for (const StampedPose& pose : road.poses(0.0, 100.0)) {
    const double seconds = 1e-9 * static_cast<double>(pose.stamp_ns);
    const bool is_out = seconds > 8.0 && seconds < 9.0;
    const Eigen::Vector3d shift_m(is_out ? 50.0 : 0.0, 0.0, 0.0);
    path.append(pose.stamp_ns, Pose(pose.T_world_base.rotation(), pose.T_world_base.translation_m() + shift_m));
  }
  const auto stations = RoadSurvey({}, path).stations({});
  ASSERT_FALSE(stations.empty());
  for (const RoadStation& station : stations) {
    const double s_m = (station.position_m - road.at(0.0, 0.0)).head<2>().norm();
    EXPECT_LT((station.position_m - road.at(s_m, 0.0)).norm(), 1e-6);
    EXPECT_TRUE(s_m < 41.0 || s_m > 44.0) << s_m;
    EXPECT_EQ(station.piece, s_m < 42.0 ? 0U : 1U);
  }
  EXPECT_GT(stations.size(), 90U);
}

TEST(RoadStations, NoStationsWhereThePosesAreMissing) {
  const MadeRoad road;
  Trajectory path;
  for (const StampedPose& pose : road.poses(0.0, 100.0)) {
    if (pose.stamp_ns < 8'000'000'000 || pose.stamp_ns > 12'000'000'000) {
      path.append(pose.stamp_ns, pose.T_world_base);
    }
  }
  for (const RoadStation& station : RoadSurvey({}, path).stations({})) {
    const double s_m = (station.position_m - road.at(0.0, 0.0)).head<2>().norm();
    EXPECT_TRUE(s_m < 40.5 || s_m > 59.5) << s_m;
  }
}

TEST(RoadStations, StandingAddsNothingToThePath) {
  const MadeRoad road;
  Trajectory path = road.path(0.0, 30.0);
  const Stamp arrived_ns = path.poses().back().stamp_ns;
  for (int i = 1; i <= 600; ++i) {
    // It shakes by 3 cm.
    path.append(arrived_ns + i * 100'000'000LL, road.pose_at(30.0 + (i % 2 == 0 ? 0.03 : -0.03)));
  }
  for (const StampedPose& pose : road.poses(30.0, 60.0, 70.0)) {
    path.append(pose.stamp_ns, pose.T_world_base);
  }
  const auto stations = RoadSurvey({}, path).stations({});
  EXPECT_EQ(stations.size(), 61U);
  EXPECT_EQ(stations.back().piece, 0U);
  EXPECT_NEAR(stations.back().position_m.x(), road.at(60.0, 0.0).x(), 0.2);
}

TEST(RoadStations, OnePoseIsOneStation) {
  const MadeRoad road;
  Trajectory path;
  path.append(5, road.pose_at(0.0));
  RoadSurvey survey({}, path);
  const auto scans = test::made_scans(road, 0.0, 0.0, {}, 1);
  survey.add_scan(scans[0].stamp_ns, scans[0].edges, scans[0].ground_m);
  const auto stations = survey.stations(road.lines(-20.0, 20.0));
  ASSERT_EQ(stations.size(), 1U);
  EXPECT_NEAR(stations[0].heading_rad, road.heading_rad, 1e-9);
  EXPECT_NEAR(stations[0].width_m.value().value, 14.0, 0.01);
  EXPECT_FALSE(stations[0].grade);
  EXPECT_NEAR(stations[0].cross_fall.value().value, road.cross_fall, 0.02);
}

TEST(RoadStations, MemoryGrowsWithThePathAndNotWithTime) {
  const MadeRoad road;
  RoadSurvey survey({}, road.path(0.0, 100.0));
  const auto scans = test::made_scans(road, 0.0, 100.0, {}, 1);
  for (const MadeScan& scan : scans) {
    survey.add_scan(scan.stamp_ns, scan.edges, scan.ground_m, scan.raised_m);
  }
  const std::size_t once = survey.memory_bytes();
  for (int i = 0; i < 20; ++i) {
    for (const MadeScan& scan : scans) {
      survey.add_scan(scan.stamp_ns, scan.edges, scan.ground_m, scan.raised_m);
    }
  }
  EXPECT_EQ(survey.memory_bytes(), once);
  EXPECT_LT(once, 101U * 14'000U);
  const auto stations = survey.stations(road.lines(-5.0, 105.0));
  EXPECT_NEAR(stations[50].left.berm_height_m.value().value, road.left_berm_m, 0.01);
}

}  // namespace
}  // namespace berm
