#include "berm/edge/trace_edges.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include <gtest/gtest.h>

#include "berm/core/error.hpp"
#include "edge/road_scene.hpp"

namespace berm {
namespace {

std::vector<EdgePoint> find_edges(const test::RoadScan& scan, const TraceEdgesConfig& config = {}) {
  TraceEdges edges(config);
  const EdgeResult result = edges.process(scan.input());
  return {result.edges.begin(), result.edges.end()};
}

constexpr float kHalf_m = 7.0F;

void expect_on_straight_edges(const std::vector<EdgePoint>& found, float tolerance_m = 0.15F) {
  for (const EdgePoint& edge : found) {
    EXPECT_NEAR(std::abs(edge.y_m), kHalf_m, tolerance_m) << edge.x_m << ' ' << edge.y_m;
    EXPECT_EQ(edge.side == EdgeSide::left, edge.y_m > 0.0F);
    EXPECT_NEAR(edge.z_m, -4.0F, 0.1F);
    EXPECT_GT(edge.confidence, 0.0F);
    EXPECT_LE(edge.confidence, 1.0F);
  }
}

std::size_t count(const std::vector<EdgePoint>& found, EdgeSide side) {
  return static_cast<std::size_t>(
      std::count_if(found.begin(), found.end(), [side](const EdgePoint& edge) { return edge.side == side; }));
}

TEST(TraceEdges, PutTheToeOfAHighBermToADecimetre) {
  const std::vector<EdgePoint> found = find_edges(test::scan_road(test::road_between_berms(double{kHalf_m}, 2.0)));
  EXPECT_GE(count(found, EdgeSide::left), 6U);
  EXPECT_GE(count(found, EdgeSide::right), 6U);
  expect_on_straight_edges(found);
}

TEST(TraceEdges, PutTheToeOfALowBermToADecimetreAndMeasureIt) {
  const std::vector<EdgePoint> found = find_edges(test::scan_road(test::road_between_berms(double{kHalf_m}, 0.5)));
  EXPECT_GE(count(found, EdgeSide::left), 4U);
  EXPECT_GE(count(found, EdgeSide::right), 4U);
  expect_on_straight_edges(found);
  for (const EdgePoint& edge : found) {
    EXPECT_NEAR(edge.height_m, 0.5F, 0.1F);
  }
}

TEST(TraceEdges, PutTheToeOfABermThatBendsTo4Centimetres) {
  // Dumped heaps are cones: a trace that cuts one aside of its middle climbs ever less steeply.
  const auto heights = [](double /*x*/, double y) {
    const double over_m = std::clamp(std::abs(y) - double{kHalf_m}, 0.0, 2.4);
    return 0.75 * over_m * (1.0 - over_m / 2.4);
  };
  std::vector<float> off_m;
  for (const EdgePoint& edge : find_edges(test::scan_road(heights))) {
    off_m.push_back(std::abs(edge.y_m) - kHalf_m);
  }
  ASSERT_GE(off_m.size(), 8U);
  std::sort(off_m.begin(), off_m.end());
  EXPECT_NEAR(off_m[off_m.size() / 2], 0.0F, 0.045F);
}

TEST(TraceEdges, FindGentleBermsInSpiteOfNoisyRanges) {
  // A bell, 9 % of its height at the edge, beside a machine that drives near to it; points jump by as much as they
  // lie apart.
  const auto heights = [](double /*x*/, double y) {
    const double off = (-y - double{kHalf_m}) / 1.1 - 2.2;
    return 1.3 * std::exp(-0.5 * off * off);
  };
  const std::vector<EdgePoint> found = find_edges(test::scan_road(heights, 0.025));
  EXPECT_GE(found.size(), 8U);
  for (const EdgePoint& edge : found) {
    EXPECT_NEAR(edge.y_m, -kHalf_m, 0.7F) << edge.x_m;
    EXPECT_EQ(edge.side, EdgeSide::right);
  }
}

TEST(TraceEdges, FindTheLipOfASlopeThatEveryBeamFliesOver) {
  constexpr double kBeyondReach_m = -200.0;
  const test::RoadHeights berms = test::road_between_berms(double{kHalf_m}, 1.5);
  const auto heights = [&](double x, double y) { return y < -double{kHalf_m} ? kBeyondReach_m : berms(x, y); };
  const std::vector<EdgePoint> found = find_edges(test::scan_road(heights));
  EXPECT_GE(count(found, EdgeSide::left), 6U);
  EXPECT_GE(count(found, EdgeSide::right), 4U);
  expect_on_straight_edges(found);
  for (const EdgePoint& edge : found) {
    EXPECT_EQ(edge.kind == EdgeKind::drop, edge.side == EdgeSide::right);
  }
}

TEST(TraceEdges, TakeNoPuddleForADrop) {
  // As wide as half of the road: no beam comes back from it.
  const test::RoadHeights dry = test::road_between_berms(double{kHalf_m}, 1.5);
  const auto heights = [&](double x, double y) {
    return x > 8.0 && x < 22.0 && y < -0.5 && y > -6.5 ? std::nan("") : dry(x, y);
  };
  for (const EdgePoint& edge : find_edges(test::scan_road(heights))) {
    EXPECT_EQ(edge.kind, EdgeKind::rise) << edge.x_m << ' ' << edge.y_m;
  }
}

TEST(TraceEdges, SeeTheEdgeAcrossTracesWhereTheyRunAlongIt) {
  // Beside the machine, rings of 15 m and 17 m run along a berm at 18 m: the next ones lie on its flank.
  const test::RoadScan scan = test::scan_road(test::road_between_berms(18.0, 2.0));
  const auto beside = [](const std::vector<EdgePoint>& found) {
    return std::count_if(found.begin(), found.end(), [](const EdgePoint& edge) { return std::abs(edge.x_m) < 4.0F; });
  };
  TraceEdgesConfig without;
  without.across = false;
  const std::vector<EdgePoint> found = find_edges(scan);
  EXPECT_GE(beside(found), 4);
  EXPECT_EQ(beside(find_edges(scan, without)), 0);
  for (const EdgePoint& edge : found) {
    EXPECT_NEAR(std::abs(edge.y_m), 18.0F, 0.3F) << edge.x_m;
    EXPECT_NEAR(edge.z_m, -4.0F, 0.2F);
  }
}

TEST(TraceEdges, SayWhenEachWasSeen) {
  const test::RoadScan scan = test::scan_road(test::road_between_berms(double{kHalf_m}, 1.0));
  for (const EdgePoint& edge : find_edges(scan)) {
    const float turn = (3.14159265F - std::atan2(edge.y_m, edge.x_m)) / (2.0F * 3.14159265F);
    EXPECT_NEAR(edge.time_s, 0.1F * turn, 0.001F);
  }
}

TEST(TraceEdges, SeeNoneOnALevelPlainWithABlindSpot) {
  EXPECT_TRUE(find_edges(test::scan_road([](double, double) { return 0.0; }, 0.02)).empty());
}

TEST(TraceEdges, SeeNoneInRutsPotholesAndPuddles) {
  const auto road = [](double x, double y) {
    if (std::hypot(x - 18.0, y - 3.0) < 1.5 || std::hypot(x + 20.0, y + 2.0) < 2.0) {
      return std::numeric_limits<double>::quiet_NaN();
    }
    const double rut = -0.15 * std::exp(-std::pow((std::abs(y) - 1.5) / 0.4, 2.0));
    const double hole = -0.2 * std::exp(-(std::pow(x - 16.0, 2.0) + std::pow(y + 3.0, 2.0)) / 0.3);
    return rut + hole;
  };
  EXPECT_TRUE(find_edges(test::scan_road(road)).empty());
}

TEST(TraceEdges, SeeNoneAtAParkedTruck) {
  const auto road = [](double x, double y) { return x > 18.0 && x < 27.0 && y > -2.0 && y < 3.0 ? 3.0 : 0.0; };
  EXPECT_TRUE(find_edges(test::scan_road(road)).empty());
}

TEST(TraceEdges, SeeTheBermsBesideAParkedTruckAndNotTheTruck) {
  const test::RoadHeights berms = test::road_between_berms(double{kHalf_m}, 1.0);
  const auto road = [&berms](double x, double y) {
    return x > 14.0 && x < 23.0 && y > -3.0 && y < 2.0 ? 3.0 : berms(x, y);
  };
  const std::vector<EdgePoint> found = find_edges(test::scan_road(road));
  EXPECT_GE(count(found, EdgeSide::left), 4U);
  EXPECT_GE(count(found, EdgeSide::right), 2U);
  expect_on_straight_edges(found, 0.5F);
}

TEST(TraceEdges, SeeNoneAtAStoneOnTheRoad) {
  const test::RoadHeights berms = test::road_between_berms(double{kHalf_m}, 1.0);
  const auto road = [&berms](double x, double y) {
    return std::max(berms(x, y), 0.45 - 0.8 * std::hypot(x - 18.0, y - 1.0));
  };
  expect_on_straight_edges(find_edges(test::scan_road(road)));
}

TEST(TraceEdges, CallAnEdgeWithoutABermADrop) {
  const auto dam = [](double, double y) { return std::max(-6.0, std::min(0.0, -0.9 * (std::abs(y) - kHalf_m))); };
  const std::vector<EdgePoint> found = find_edges(test::scan_road(dam));
  EXPECT_GE(count(found, EdgeSide::left), 2U);
  EXPECT_GE(count(found, EdgeSide::right), 2U);
  for (const EdgePoint& edge : found) {
    EXPECT_EQ(edge.kind, EdgeKind::drop);
    EXPECT_NEAR(std::abs(edge.y_m), kHalf_m, 0.5F);
    EXPECT_EQ(edge.height_m, 0.0F);
  }
}

TEST(TraceEdges, KeepTheSidesOfABend) {
  constexpr float kRadius_m = 60.0F;
  const std::vector<EdgePoint> found =
      find_edges(test::scan_road(test::bend_between_berms(double{kRadius_m}, double{kHalf_m}, 1.0)));
  EXPECT_GE(count(found, EdgeSide::left), 4U);
  EXPECT_GE(count(found, EdgeSide::right), 4U);
  for (const EdgePoint& edge : found) {
    const float from_middle_m = std::hypot(edge.x_m, edge.y_m - kRadius_m);
    EXPECT_NEAR(std::abs(from_middle_m - kRadius_m), kHalf_m, 0.25F) << edge.x_m << ' ' << edge.y_m;
    EXPECT_EQ(edge.side == EdgeSide::left, from_middle_m < kRadius_m) << edge.x_m << ' ' << edge.y_m;
  }
}

TEST(TraceEdges, CallPlainWhatLiesBetweenTheBerms) {
  const test::RoadScan scan = test::scan_road(test::road_between_berms(double{kHalf_m}, 1.0));
  TraceEdges edges({});
  const EdgeResult result = edges.process(scan.input());
  ASSERT_GT(result.plain.size(), 200U);
  for (const std::uint32_t i : result.plain) {
    ASSERT_LT(i, scan.points().size());
    EXPECT_LT(std::abs(scan.channels.y[i]), kHalf_m + 0.2F);
  }
}

TEST(TraceEdges, SeeTheSameInAMirror) {
  test::RoadScan scan = test::scan_road(test::road_between_berms(double{kHalf_m}, 1.0));
  const std::vector<EdgePoint> found = find_edges(scan);
  for (float& y : scan.channels.y) {
    y = -y;
  }
  const std::vector<EdgePoint> mirrored = find_edges(scan);
  EXPECT_EQ(count(found, EdgeSide::left), count(mirrored, EdgeSide::right));
  EXPECT_EQ(count(found, EdgeSide::right), count(mirrored, EdgeSide::left));
}

TEST(TraceEdges, SayWhatIsWrongWithTheirSettings) {
  TraceEdgesConfig config;
  config.max_range_m = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(TraceEdges{config}, ConfigError);
  config = {};
  config.min_height_m = -1.0;
  EXPECT_THROW(TraceEdges{config}, ConfigError);
}

}  // namespace
}  // namespace berm
