#include "berm/map/road_survey.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include "berm/core/error.hpp"
#include "map/drawn.hpp"
#include "map/road_made.hpp"

namespace berm {
namespace {

using test::drawn;
using test::MadeRoad;
using test::MadeScan;

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
    road.start_m = {drawn(-1.0, 1.0) * 5e5, drawn(-1.0, 1.0) * 5e6, drawn(-400.0, 4000.0)};
    road.heading_rad = drawn(-3.2, 3.2);
    road.curvature = drawn(-1.0, 1.0) / 40.0;
    road.left_m = drawn(4.0, 14.0);
    road.right_m = drawn(4.0, 14.0);
    road.grade = drawn(-0.15, 0.15);
    road.cross_fall = drawn(-0.05, 0.05);
    road.left_berm_m = drawn(0.3, 3.0);
    road.right_berm_m = drawn(0.3, 3.0);
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

TEST(RoadSurvey, TakesPlacesOnTheVeryBorderOfTheView) {
  // 40 m from the machine, less the last digit: added to 40 m it rounds to 80.
  const double last_m = double{std::nextafter(40.0F, 0.0F)};
  Trajectory path;
  path.append(0, Pose());
  RoadSurvey survey({}, path);
  const std::vector<Eigen::Vector3d> places_m = {
      {last_m, last_m, 0.0}, {0.0, last_m, 0.0}, {last_m, 0.0, 0.0}, {-last_m, -last_m, 0.0}};
  survey.add_scan(0, {}, places_m, places_m);
  EXPECT_EQ(survey.stations({}).size(), 1U);
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
