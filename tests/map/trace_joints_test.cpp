#include <algorithm>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "berm/map/edge_lines.hpp"
#include "made_edges.hpp"

namespace berm {
namespace {

/// The left lines of a straight road of 120 m along x, without the hits and places that are to be gone.
template <typename EdgeGone, typename PlainGone>
std::vector<EdgeLine> left_lines(const EdgeGone& edge_gone, const PlainGone& plain_gone,
                                 const EdgeLinesConfig& config = {}) {
  auto scans = test::drive(test::straight_course({0.0, 0.0, 0.0}, 0.0, 120.0), {.hits_per_m = 30.0});
  for (test::MadeScan& scan : scans) {
    std::erase_if(scan.edges,
                  [&](const MappedEdge& edge) { return edge.side == EdgeSide::left && edge_gone(edge.position_m); });
    std::erase_if(scan.plain_m, plain_gone);
  }
  std::vector<EdgeLine> lines = extract_lines(test::map_of(scans), config);
  std::erase_if(lines, [](const EdgeLine& line) { return line.side == EdgeSide::right; });
  return lines;
}

bool is_between(const Eigen::Vector3d& place_m, double from_m, double to_m) {
  return place_m.x() > from_m && place_m.x() < to_m;
}

TEST(TraceJoints, ALineGoesOnBehindAParkedTruck) {
  // Neither the edge nor the road before it was seen for 20 m.
  const auto hidden = [](const Eigen::Vector3d& place_m) {
    return is_between(place_m, 50.0, 70.0) && place_m.y() > 4.0;
  };
  const auto lines = left_lines(hidden, hidden);
  ASSERT_EQ(lines.size(), 1U);
  for (const EdgeLine::Vertex& vertex : lines[0].vertices) {
    EXPECT_NEAR(vertex.position_m.y(), 7.0, 0.3);
    if (is_between(vertex.position_m, 52.0, 68.0)) {
      EXPECT_EQ(vertex.confidence, 0.5);
    }
  }
}

TEST(TraceJoints, AMouthOfARoadStaysOpen) {
  // 14 m without an edge, where the road goes on to the side.
  auto mouth = [](const Eigen::Vector3d& place_m) { return is_between(place_m, 50.0, 64.0); };
  auto scans = test::drive(test::straight_course({0.0, 0.0, 0.0}, 0.0, 120.0), {.hits_per_m = 30.0});
  for (test::MadeScan& scan : scans) {
    std::erase_if(scan.edges,
                  [&](const MappedEdge& edge) { return edge.side == EdgeSide::left && mouth(edge.position_m); });
    for (double x_m = 50.0; x_m < 64.0; x_m += 0.2) {
      for (double y_m = 6.0; y_m < 9.0; y_m += 0.2) {
        scan.plain_m.emplace_back(x_m, y_m, 0.0);
      }
    }
  }
  const auto lines = extract_lines(test::map_of(scans), {});
  EXPECT_EQ(std::count_if(lines.begin(), lines.end(), [](const EdgeLine& line) { return line.side == EdgeSide::left; }),
            2);
}

TEST(TraceJoints, EndsOfARowThatTurnOffTheRoadAreGivenUp) {
  // A gap of 4 m; the toe turns off the road around the last heap on both sides of it.
  auto scans = test::drive(test::straight_course({0.0, 0.0, 0.0}, 0.0, 120.0), {.hits_per_m = 30.0});
  for (test::MadeScan& scan : scans) {
    for (MappedEdge& edge : scan.edges) {
      const double into_m = 4.0 - std::abs(edge.position_m.x() - 60.0);
      if (edge.side == EdgeSide::left && into_m > 0.0) {
        const double radius_m = 2.0;
        const double turn_rad = into_m / radius_m;
        edge.position_m.y() += radius_m * (1.0 - std::cos(turn_rad));
        edge.position_m.x() = 60.0 + std::copysign(4.0 - radius_m * std::sin(turn_rad), edge.position_m.x() - 60.0);
      }
    }
  }
  const auto lines = extract_lines(test::map_of(scans), {});
  const auto left = std::find_if(lines.begin(), lines.end(), [](const EdgeLine& line) {
    return line.side == EdgeSide::left && line.vertices.size() > 200;
  });
  ASSERT_NE(left, lines.end());
  for (const EdgeLine::Vertex& vertex : left->vertices) {
    EXPECT_NEAR(vertex.position_m.y(), 7.0, 0.5) << vertex.position_m.x();
  }
}

TEST(RowsBehind, WhatStandsBehindABermIsLeftOut) {
  auto scans = test::drive(test::straight_course({0.0, 0.0, 0.0}, 0.0, 120.0), {.hits_per_m = 30.0});
  const auto walls = test::drive(test::straight_course({20.0, 0.0, 0.0}, 0.0, 60.0),
                                 {.half_width_m = 15.0, .hits_per_m = 20.0, .seed = 2});
  for (const test::MadeScan& wall : walls) {
    test::MadeScan scan;
    for (const MappedEdge& edge : wall.edges) {
      if (edge.side == EdgeSide::left) {
        scan.edges.push_back(edge);
        scan.plain_m.emplace_back(edge.position_m - Eigen::Vector3d(0.0, 1.2, 0.0));
      }
    }
    scans.push_back(scan);
  }
  const auto lines = extract_lines(test::map_of(scans), {});
  EXPECT_EQ(lines.size(), 2U);
  for (const EdgeLine& line : lines) {
    EXPECT_LT(std::abs(line.vertices.front().position_m.y()), 8.0);
  }
}

TEST(RowsBehind, TwoRoadsBesideEachOtherKeepTheirEdges) {
  // Roads 22 m apart: behind the edge of one comes the rear of the other's, which looks the other way.
  auto scans = test::drive(test::straight_course({0.0, 0.0, 0.0}, 0.0, 120.0), {.hits_per_m = 30.0});
  const auto others = test::drive(test::straight_course({0.0, 22.0, 0.0}, 0.0, 60.0), {.hits_per_m = 30.0, .seed = 2});
  scans.insert(scans.end(), others.begin(), others.end());
  EXPECT_EQ(extract_lines(test::map_of(scans), {}).size(), 4U);
}

}  // namespace
}  // namespace berm
