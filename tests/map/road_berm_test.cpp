#include <algorithm>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include "berm/map/road_survey.hpp"
#include "map/drawn.hpp"
#include "map/road_made.hpp"

namespace berm {
namespace {

using test::drawn;
using test::MadeRoad;
using test::MadeScan;

TEST(RoadBerm, ADropHasNoBerm) {
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

TEST(RoadBerm, TheWallBehindTheBermIsNotTheBerm) {
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

TEST(RoadBerm, MeasuresTheCrestOfTheBerm) {
  EXPECT_TRUE(rc::check("whatever the edge points have climbed", [] {
    MadeRoad road;
    road.start_m = {drawn(-1.0, 1.0) * 5e5, drawn(-1.0, 1.0) * 5e6, 300.0};
    road.curvature = drawn(-1.0, 1.0) / 50.0;
    road.grade = drawn(-0.1, 0.1);
    road.left_berm_m = 0.4;  // of the edge points, wrong
    const double crest_m = drawn(0.3, 3.0);
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

TEST(RoadBerm, AWallIsNoBerm) {
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

}  // namespace
}  // namespace berm
