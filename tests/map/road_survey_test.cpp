#include "berm/map/road_survey.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include "berm/core/error.hpp"
#include "map/road_made.hpp"

namespace berm {
namespace {

using test::MadeRoad;
using test::MadeScan;

double between(double least, double most) {
  return least + (most - least) * *rc::gen::inRange(0, 1001) / 1000.0;
}

bool same(const std::optional<Measure>& a, const std::optional<Measure>& b) {
  return a.has_value() == b.has_value() && (!a || (a->value == b->value && a->sigma == b->sigma));
}

bool same(const RoadStation& a, const RoadStation& b) {
  return a.chainage_m == b.chainage_m && a.position_m == b.position_m && same(a.width_m, b.width_m) &&
         same(a.grade, b.grade) && same(a.cross_fall, b.cross_fall) &&
         same(a.left.berm_height_m, b.left.berm_height_m) && same(a.right.edge_m, b.right.edge_m);
}

/// Expects everything about the road to be measured, at every station but those at the ends.
void check_road(const MadeRoad& road, const std::vector<RoadStation>& stations, double length_m, double tolerance) {
  for (const RoadStation& station : stations) {
    if (station.chainage_m < 3.0 || station.chainage_m > length_m - 3.0) {
      continue;
    }
    RC_ASSERT(station.width_m.has_value());
    RC_ASSERT(std::abs(station.width_m->value - road.left_m - road.right_m) < 0.05 + tolerance);
    RC_ASSERT(std::abs(station.left.edge_m->value - road.left_m) < 0.05 + tolerance);
    RC_ASSERT(station.grade.has_value() && station.cross_fall.has_value());
    RC_ASSERT(std::abs(station.grade->value - road.grade) < 0.003 + 0.1 * tolerance);
    RC_ASSERT(std::abs(station.cross_fall->value - road.cross_fall) < 0.004 + 0.1 * tolerance);
    RC_ASSERT(station.left.berm_height_m.has_value() && station.right.berm_height_m.has_value());
    RC_ASSERT(std::abs(station.left.berm_height_m->value - road.left_berm_m) < 0.01 + tolerance);
    RC_ASSERT(std::abs(station.right.berm_height_m->value - road.right_berm_m) < 0.01 + tolerance);
    RC_ASSERT(std::abs(station.left.berm_width_m->value - 2.0 * road.left_berm_m) < 0.02 + 2.0 * tolerance);
  }
}

TEST(RoadSurvey, MeasuresAnyRoadAnywhere) {
  EXPECT_TRUE(rc::check("width, slopes and berms, at UTM's coordinates too", [] {
    MadeRoad road;
    road.start_m = {between(-1.0, 1.0) * 5e5, between(-1.0, 1.0) * 5e6, between(-400.0, 4000.0)};
    road.heading_rad = between(-3.2, 3.2);
    road.curvature = between(-1.0, 1.0) / 40.0;
    road.left_m = between(4.0, 14.0);
    road.right_m = between(4.0, 14.0);
    road.grade = between(-0.15, 0.15);
    road.cross_fall = between(-0.05, 0.05);
    road.left_berm_m = between(0.3, 3.0);
    road.right_berm_m = between(0.3, 3.0);
    const double length_m = 40.0;
    const auto scans = test::made_scans(road, 0.0, length_m, {}, 1);
    const auto stations = test::survey({}, road.path(0.0, length_m), scans, road.lines(-5.0, length_m + 5.0));
    RC_ASSERT(stations.size() == 41U || stations.size() == 40U);
    check_road(road, stations, length_m, 0.0);
  }));
}

/// Share of errors within one and two standard deviations.
struct Honesty {
  int within_one = 0;
  int within_two = 0;
  int all = 0;

  void add(const std::optional<Measure>& measure, double truth) {
    if (measure) {
      const double error = std::abs(measure->value - truth);
      within_one += error <= measure->sigma ? 1 : 0;
      within_two += error <= 2.0 * measure->sigma ? 1 : 0;
      ++all;
    }
  }
  /// Noise that averages out leaves the floors of the sigmas, which are for what made roads do not have.
  void expect(const std::string& what) const {
    ASSERT_GT(all, 500) << what;
    EXPECT_GE(within_one, 0.60 * all) << what;
    EXPECT_GE(within_two, 0.93 * all) << what;
  }
};

TEST(RoadSurvey, SaysHowSureItIs) {
  Honesty grade;
  Honesty cross_fall;
  Honesty height;
  Honesty width;
  for (unsigned seed = 0; seed < 12; ++seed) {
    const MadeRoad road;
    const test::ScanNoise noise{
        .ground_m = 0.03, .edge_m = 0.15, .berm_m = 0.2, .shared_m = 0.15, .shared_slope = 0.004};
    const auto scans = test::made_scans(road, 0.0, 100.0, noise, seed);
    RoadConfig config;
    config.attitude_sigma_deg = 0.066;  // 0.004 of each of twelve looks
    for (const RoadStation& station : test::survey(config, road.path(0.0, 100.0), scans, road.lines(-5.0, 105.0))) {
      grade.add(station.grade, road.grade);
      cross_fall.add(station.cross_fall, road.cross_fall);
      height.add(station.left.berm_height_m, road.left_berm_m);
      width.add(station.width_m, road.left_m + road.right_m);
    }
  }
  grade.expect("grade");
  cross_fall.expect("cross-fall");
  height.expect("height");
  width.expect("width");
}

TEST(RoadSurvey, OneLookIsOneMeasurement) {
  const MadeRoad road;
  const test::ScanNoise noise{.edge_m = 0.15};
  const auto scans = test::made_scans(road, 0.0, 60.0, noise, 3);
  // The machine stands and sees the same edge again and again, or it drives past.
  std::vector<MadeScan> standing(60, scans[30]);
  const auto lines = road.lines(-5.0, 65.0);
  const auto driven = test::survey({}, road.path(0.0, 60.0), scans, lines);
  const auto stood = test::survey({}, road.path(0.0, 60.0), standing, lines);
  double stood_sigma_m = 1.0;
  for (const RoadStation& station : stood) {
    // Without any sighting it is 0.3.
    stood_sigma_m = std::min(stood_sigma_m, station.left.edge_m.value().sigma);
  }
  EXPECT_LT(stood_sigma_m, 0.29);
  EXPECT_GT(stood_sigma_m, 0.14);
  std::vector<double> driven_sigmas_m;
  for (std::size_t i = 20; i < 40; ++i) {
    driven_sigmas_m.push_back(driven[i].left.edge_m.value().sigma);
  }
  std::sort(driven_sigmas_m.begin(), driven_sigmas_m.end());
  EXPECT_LT(driven_sigmas_m[10], stood_sigma_m);
}

TEST(RoadSurvey, StationsLieEverySpacingAlongThePath) {
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

TEST(RoadSurvey, GapsInTheEdgesHaveNoWidth) {
  const MadeRoad road;
  const auto scans = test::made_scans(road, 0.0, 60.0, {}, 1);
  std::vector<EdgeLine> lines = {road.line(EdgeSide::left, -5.0, 20.0), road.line(EdgeSide::left, 30.0, 65.0),
                                 road.line(EdgeSide::right, -5.0, 65.0)};
  // A stretch that the map carried across, without having seen anything.
  for (EdgeLine::Vertex& vertex : lines[2].vertices) {
    const double along_m = (vertex.position_m - road.at(0.0, -road.right_m)).head<2>().norm();
    vertex.confidence = along_m > 40.0 && along_m < 45.0 ? 0.5 : 0.9;
  }
  for (const RoadStation& station : test::survey({}, road.path(0.0, 60.0), scans, lines)) {
    const double s_m = station.chainage_m;
    if (s_m > 20.5 && s_m < 29.5) {
      EXPECT_FALSE(station.left.edge_m) << s_m;
      EXPECT_FALSE(station.left.berm_height_m) << s_m;
      EXPECT_FALSE(station.width_m) << s_m;
      EXPECT_TRUE(station.right.edge_m && station.cross_fall && station.grade) << s_m;
      EXPECT_NEAR(station.cross_fall->value, road.cross_fall, 0.004) << s_m;
    } else if (s_m > 40.5 && s_m < 44.5) {
      EXPECT_FALSE(station.right.edge_m) << s_m;
    } else if (s_m < 19.0) {
      EXPECT_TRUE(station.width_m) << s_m;
    }
  }
}

TEST(RoadSurvey, ThereAndBackIsTwoPasses) {
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

TEST(RoadSurvey, AScanCountsForItsOwnPass) {
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

TEST(RoadSurvey, NoStationsAcrossAJump) {
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

TEST(RoadSurvey, NoStationsWhereThePosesAreMissing) {
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

TEST(RoadSurvey, StandingAddsNothingToThePath) {
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

TEST(RoadSurvey, OnePoseIsOneStation) {
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

TEST(RoadSurvey, NothingInNothingOut) {
  RoadSurvey survey({}, Trajectory());
  const MadeRoad road;
  for (const MadeScan& scan : test::made_scans(road, 0.0, 5.0, {}, 1)) {
    survey.add_scan(scan.stamp_ns, scan.edges, scan.ground_m, scan.raised_m);
  }
  EXPECT_TRUE(survey.stations(road.lines(0.0, 50.0)).empty());
  RoadSurvey moved = std::move(survey);
  EXPECT_TRUE(moved.stations({}).empty());
}

TEST(RoadSurvey, LeavesOutWhatIsNotFinite) {
  const MadeRoad road;
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double inf = std::numeric_limits<double>::infinity();
  auto scans = test::made_scans(road, 0.0, 40.0, {}, 1);
  auto lines = road.lines(-5.0, 45.0);
  const auto expected = test::survey({}, road.path(0.0, 40.0), scans, lines);
  for (MadeScan& scan : scans) {
    for (const Eigen::Vector3d& bad :
         {Eigen::Vector3d(nan, 0.0, 0.0), Eigen::Vector3d(0.0, inf, 0.0),
          Eigen::Vector3d(road.at(20.0, 0.0).x(), road.at(20.0, 0.0).y(), -inf), Eigen::Vector3d(1e300, -1e300, 0.0)}) {
      scan.ground_m.push_back(bad);
      scan.edges.push_back({bad, 1.0F, 1.0F});
      scan.raised_m.push_back(bad);
    }
    scan.edges.push_back({road.at(20.0, road.left_m), std::nanf(""), 1.0F});
  }
  EdgeLine bad_line;
  bad_line.vertices = {{{nan, 0.0, 0.0}, 1.0},
                       {{0.0, inf, 0.0}, 1.0},
                       {{1e300, 0.0, 0.0}, 1.0},
                       {{0.0, 1e9, 0.0}, 1.0},
                       {{0.0, 0.0, 0.0}, nan}};
  lines.push_back(bad_line);
  lines.push_back({});
  const auto stations = test::survey({}, road.path(0.0, 40.0), scans, lines);
  ASSERT_EQ(stations.size(), expected.size());
  for (std::size_t i = 0; i < stations.size(); ++i) {
    EXPECT_TRUE(same(stations[i], expected[i])) << i;
  }
  Trajectory path;
  for (const StampedPose& pose : road.poses(0.0, 40.0)) {
    path.append(pose.stamp_ns, pose.T_world_base);
    path.append(pose.stamp_ns + 1, Pose(Eigen::Quaterniond::Identity(), {nan, 0.0, 0.0}));
  }
  EXPECT_NO_THROW((void)RoadSurvey({}, path).stations(lines));
}

TEST(RoadSurvey, MemoryGrowsWithThePathAndNotWithTime) {
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

TEST(RoadSurvey, RulesHoldOrAreBrokenByTwoSigma) {
  const MadeRoad road;  // 14 m wide, berms of 1.2 and 0.8 m, 6 %
  const auto scans = test::made_scans(road, 0.0, 40.0, {}, 1);
  const auto judged = [&](const RoadConfig& config) {
    return test::survey(config, road.path(0.0, 40.0), scans, road.lines(-5.0, 45.0))[20];
  };
  RoadConfig config;
  EXPECT_EQ(judged(config).width_rule, RuleVerdict::unknown);
  EXPECT_EQ(judged(config).left.berm_rule, RuleVerdict::unknown);
  EXPECT_EQ(judged(config).grade_rule, RuleVerdict::holds);
  config.vehicle_width_m = 3.5;
  config.tyre_height_m = 2.0;
  config.max_grade_percent = 5.0;
  EXPECT_EQ(judged(config).width_rule, RuleVerdict::holds);
  EXPECT_EQ(judged(config).left.berm_rule, RuleVerdict::uncertain);
  EXPECT_EQ(judged(config).grade_rule, RuleVerdict::broken);
  config.vehicle_width_m = 4.0;
  config.tyre_height_m = 5.0;
  config.max_grade_percent = 6.0;
  EXPECT_EQ(judged(config).width_rule, RuleVerdict::uncertain);
  EXPECT_EQ(judged(config).left.berm_rule, RuleVerdict::broken);
  EXPECT_EQ(judged(config).right.berm_rule, RuleVerdict::broken);
  EXPECT_EQ(judged(config).grade_rule, RuleVerdict::uncertain);
  config.vehicle_width_m = 5.0;
  EXPECT_EQ(judged(config).width_rule, RuleVerdict::broken);
}

TEST(RoadSurvey, ADropHasNoBerm) {
  const MadeRoad road;
  auto scans = test::made_scans(road, 0.0, 40.0, {}, 1);
  for (MadeScan& scan : scans) {
    for (std::size_t i = 0; i < scan.edges.size(); i += 2) {  // the left ones
      scan.edges[i].kind = EdgeKind::drop;
      scan.edges[i].height_m = 0.0F;
    }
  }
  RoadConfig config;
  config.tyre_height_m = 2.0;
  const auto station = test::survey(config, road.path(0.0, 40.0), scans, road.lines(-5.0, 45.0))[20];
  EXPECT_EQ(station.left.berm_height_m.value().value, 0.0);
  EXPECT_EQ(station.left.berm_rule, RuleVerdict::broken);
  EXPECT_NEAR(station.right.berm_height_m.value().value, road.right_berm_m, 0.01);
}

TEST(RoadSurvey, TheWallBehindTheBermIsNotTheBerm) {
  const MadeRoad road;
  auto scans = test::made_scans(road, 0.0, 40.0, {}, 1);
  for (std::size_t i = 0; i < scans.size(); ++i) {
    for (int k = 0; k < 6; ++k) {
      scans[i].edges.push_back({road.at(static_cast<double>(i) + k, road.left_m + 4.0), 9.0F, 1.0F});
    }
  }
  const auto station = test::survey({}, road.path(0.0, 40.0), scans, road.lines(-5.0, 45.0))[20];
  EXPECT_NEAR(station.left.berm_height_m.value().value, road.left_berm_m, 0.01);
}

/// What is raised beyond the left edge: a row of heaps, as the machine sees it on its way, or a wall.
void raise(const MadeRoad& road, std::vector<MadeScan>& scans, double crest_m, bool is_wall) {
  for (std::size_t i = 0; i < scans.size(); ++i) {
    for (int k = 0; k < 2000; ++k) {
      const double s_m = static_cast<double>(i) - 25.0 + 0.025 * k;
      const double beyond_m = (is_wall ? 0.12 : 0.04) * (k % 53);
      const double flank_m = is_wall ? 2.0 * beyond_m : crest_m * std::max(1.0 - std::abs(beyond_m - 1.5) / 1.5, 0.0);
      scans[i].raised_m.emplace_back(road.at(s_m, road.left_m + beyond_m) + Eigen::Vector3d(0.0, 0.0, flank_m));
    }
  }
}

TEST(RoadSurvey, MeasuresTheCrestOfTheBerm) {
  EXPECT_TRUE(rc::check("whatever the edge points have climbed", [] {
    MadeRoad road;
    road.start_m = {between(-1.0, 1.0) * 5e5, between(-1.0, 1.0) * 5e6, 300.0};
    road.curvature = between(-1.0, 1.0) / 50.0;
    road.grade = between(-0.1, 0.1);
    road.left_berm_m = 0.4;  // of the edge points, wrong
    const double crest_m = between(0.3, 3.0);
    auto scans = test::made_scans(road, 0.0, 40.0, {}, 1);
    raise(road, scans, crest_m, false);
    // Something stood there for a few metres of driving.
    for (std::size_t i = 10; i < 15; ++i) {
      scans[i].raised_m.emplace_back(road.at(20.0, road.left_m + 1.0) + Eigen::Vector3d(0.0, 0.0, 4.0));
    }
    const auto stations = test::survey({}, road.path(0.0, 40.0), scans, road.lines(-5.0, 45.0));
    for (std::size_t i = 5; i < 35; ++i) {
      const Measure height = stations[i].left.berm_height_m.value();
      RC_ASSERT(std::abs(height.value - crest_m) < 0.05);
      RC_ASSERT(height.sigma < 0.15);
      RC_ASSERT(std::abs(stations[i].right.berm_height_m.value().value - road.right_berm_m) < 0.01);
    }
  }));
}

TEST(RoadSurvey, AWallIsNoBerm) {
  const MadeRoad road;
  auto scans = test::made_scans(road, 0.0, 40.0, {}, 1);
  for (MadeScan& scan : scans) {
    for (SurveyedEdge& edge : scan.edges) {
      edge.height_m = 0.0F;  // nobody saw its top
    }
  }
  raise(road, scans, 0.0, true);
  const auto stations = test::survey({}, road.path(0.0, 40.0), scans, road.lines(-5.0, 45.0));
  EXPECT_TRUE(stations[20].left.edge_m);
  EXPECT_FALSE(stations[20].left.berm_height_m);
}

TEST(BermHeights, VerticesHaveThoseOfTheStationsBesideThem) {
  MadeRoad road;
  road.curvature = 0.02;
  auto lines = road.lines(-20.0, 60.0);
  for (std::size_t i = 60; i < 80; ++i) {
    lines[0].vertices[i].confidence = 0.5;  // carried across a gap, from 10 to 20 m
  }
  EdgeLine above = lines[1];
  for (EdgeLine::Vertex& vertex : above.vertices) {
    vertex.position_m.z() += 10.0;
  }
  lines.push_back(above);
  const auto scans = test::made_scans(road, 0.0, 40.0, {}, 1);
  set_berm_heights(test::survey({}, road.path(0.0, 40.0), scans, road.lines(-20.0, 60.0)), lines);
  const double truth_m[] = {road.left_berm_m, road.right_berm_m};
  for (std::size_t side = 0; side < 2; ++side) {
    for (std::size_t i = 0; i < lines[side].vertices.size(); ++i) {
      const double s_m = -20.0 + 0.5 * static_cast<double>(i);
      const auto& height_m = lines[side].vertices[i].berm_height_m;
      const bool is_seen = lines[side].vertices[i].confidence > 0.5;
      if (s_m > 2.0 && s_m < 38.0 && is_seen) {
        ASSERT_TRUE(height_m) << side << " " << s_m;
        EXPECT_NEAR(*height_m, truth_m[side], 0.01);
      } else if (s_m < -2.0 || s_m > 42.0 || !is_seen) {
        EXPECT_FALSE(height_m) << side << " " << s_m;
      }
    }
  }
  for (const EdgeLine::Vertex& vertex : lines[2].vertices) {
    EXPECT_FALSE(vertex.berm_height_m) << "of the bench above";
  }
}

TEST(BermHeights, TheSurerStationSaysMore) {
  std::vector<RoadStation> stations(2);
  for (RoadStation& station : stations) {
    station.left.edge_m = Measure{5.0, 0.1};
  }
  stations[0].left.berm_height_m = Measure{1.0, 0.1};
  stations[1].left.berm_height_m = Measure{2.0, 0.2};
  std::vector<EdgeLine> lines{{EdgeSide::left, {{{0.0, 5.0, 0.0}, 1.0}, {{1.5, 5.0, 0.0}, 1.0}}}};
  set_berm_heights(stations, lines);
  EXPECT_NEAR(lines[0].vertices[0].berm_height_m.value(), (1.0 * 4 + 2.0) / 5, 1e-12);
  EXPECT_FALSE(lines[0].vertices[1].berm_height_m);
}

TEST(RoadSurvey, RefusesSettingsOutOfRange) {
  RoadConfig config;
  config.spacing_m = 0.0;
  EXPECT_THROW(RoadSurvey(config, {}), ConfigError);
  PoseGuardConfig guard;
  guard.max_gap_s = -1.0;
  EXPECT_THROW(RoadSurvey({}, {}, guard), ConfigError);
}

}  // namespace
}  // namespace berm
