#include "berm/map/edge_lines.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include "made_edges.hpp"

namespace berm {
namespace {

using test::Course;
using test::MadeDrive;

double length_m(const EdgeLine& line) {
  double sum_m = 0.0;
  for (std::size_t i = 1; i < line.vertices.size(); ++i) {
    sum_m += (line.vertices[i].position_m - line.vertices[i - 1].position_m).norm();
  }
  return sum_m;
}

Course course_of(const EdgeLine& line) {
  Course course;
  for (const EdgeLine::Vertex& vertex : line.vertices) {
    course.push_back(vertex.position_m);
  }
  return course;
}

/// Distances of all vertices of one side from a course, in ascending order.
std::vector<double> distances_m(const std::vector<EdgeLine>& lines, EdgeSide side, const Course& course) {
  std::vector<double> all;
  for (const EdgeLine& line : lines) {
    if (line.side == side) {
      for (const EdgeLine::Vertex& vertex : line.vertices) {
        all.push_back(test::distance_m(course, vertex.position_m));
      }
    }
  }
  std::sort(all.begin(), all.end());
  return all;
}

/// Share of a course that some line of a side comes within 0.5 m of.
double covered(const std::vector<EdgeLine>& lines, EdgeSide side, const Course& course) {
  std::vector<Course> found;
  for (const EdgeLine& line : lines) {
    if (line.side == side) {
      found.push_back(course_of(line));
    }
  }
  constexpr std::size_t kStep = 5;  // half a metre
  double count = 0.0;
  double whole = 0.0;
  for (std::size_t i = 0; i < course.size(); i += kStep) {
    const bool near = std::any_of(found.begin(), found.end(),
                                  [&](const Course& line) { return test::distance_m(line, course[i]) < 0.5; });
    count += near ? 1.0 : 0.0;
    whole += 1.0;
  }
  return count / whole;
}

std::vector<EdgeLine> lines_of(const Course& course, const MadeDrive& how) {
  return extract_lines(test::map_of(test::drive(course, how)), {});
}

TEST(EdgeLines, EmptyMapHasNone) {
  EXPECT_TRUE(extract_lines(EdgeMap({}), {}).empty());
  EdgeLinesConfig wrong;
  wrong.spacing_m = 0.0;
  EXPECT_ANY_THROW((void)extract_lines(EdgeMap({}), wrong));
}

TEST(EdgeLines, OneLinePerSideOfAStraightRoad) {
  const Course course = test::straight_course({3.0, -40.0, 7.0}, 0.4, 80.0);
  const auto lines = lines_of(course, {});
  ASSERT_EQ(lines.size(), 2U);
  EXPECT_NE(lines[0].side, lines[1].side);
  for (const EdgeLine& line : lines) {
    const double aside_m = line.side == EdgeSide::left ? 7.0 : -7.0;
    const Course edge = test::beside(course, aside_m);
    const auto errors_m = distances_m({line}, line.side, edge);
    EXPECT_LT(errors_m[errors_m.size() / 2], 0.03);
    // At its ends a line may reach beyond by the scatter of the last hits and a voxel.
    EXPECT_LT(errors_m[errors_m.size() - 3], 0.15);
    EXPECT_LT(errors_m.back(), 0.45);
    EXPECT_GT(covered({line}, line.side, edge), 0.99);
    EXPECT_NEAR(length_m(line), 80.0, 1.5);
    for (const EdgeLine::Vertex& vertex : line.vertices) {
      EXPECT_NEAR(vertex.position_m.z(), 7.0, 0.15);
    }
    // As who drives with the road on the right of a left edge: here both as the course runs.
    const Eigen::Vector3d run = line.vertices.back().position_m - line.vertices.front().position_m;
    EXPECT_EQ(run.dot(course.back() - course.front()) > 0.0, true);
  }
}

TEST(EdgeLines, VerticesAreEquallySpacedAndInOrder) {
  EdgeLinesConfig config;
  config.spacing_m = 0.8;
  const Course course = test::straight_course({0.0, 0.0, 0.0}, -2.0, 50.0);
  for (const EdgeLine& line : extract_lines(test::map_of(test::drive(course, {})), config)) {
    for (std::size_t i = 1; i < line.vertices.size(); ++i) {
      const Eigen::Vector3d step = line.vertices[i].position_m - line.vertices[i - 1].position_m;
      EXPECT_NEAR(step.norm(), 0.8, 0.1);
      EXPECT_GT(step.dot(course.back() - course.front()), 0.0);
    }
  }
}

TEST(EdgeLines, ABendOfTwentyMetresIsNotCut) {
  // Radii of 20 m and 34 m, plenty of hits: what is left is what the fit takes away from the bend.
  const Course course = test::s_bend_course(27.0);
  const auto lines = lines_of(course, {.half_width_m = 7.0, .hits_per_m = 300.0});
  ASSERT_EQ(lines.size(), 2U);
  for (const EdgeSide side : {EdgeSide::left, EdgeSide::right}) {
    const Course edge = test::beside(course, side == EdgeSide::left ? 7.0 : -7.0);
    const auto errors_m = distances_m(lines, side, edge);
    EXPECT_LT(errors_m[errors_m.size() * 95 / 100], 0.05);
    EXPECT_GT(covered(lines, side, edge), 0.99);
  }
}

TEST(EdgeLines, ATightBendIsFollowed) {
  const auto lines = lines_of(test::arc_course({0.0, 0.0, 0.0}, 12.0, 0.0, 2.0), {.half_width_m = 6.0});
  const Course inner = test::arc_course({0.0, 0.0, 0.0}, 6.0, 0.0, 2.0);
  const auto errors_m = distances_m(lines, EdgeSide::left, inner);
  ASSERT_FALSE(errors_m.empty());
  EXPECT_LT(errors_m[errors_m.size() / 2], 0.05);
  EXPECT_LT(errors_m.back(), 0.3);
  EXPECT_GT(covered(lines, EdgeSide::left, inner), 0.97);
}

TEST(EdgeLines, AClosedLoopIsOneClosedLine) {
  const Course course = test::arc_course({100.0, 50.0, 0.0}, 30.0, 0.0, 2.0 * std::numbers::pi);
  const auto lines = lines_of(course, {.half_width_m = 6.0, .hits_per_m = 30.0});
  ASSERT_EQ(lines.size(), 2U);
  for (const EdgeLine& line : lines) {
    EXPECT_LT((line.vertices.back().position_m - line.vertices.front().position_m).norm(), 0.6);
    const double radius_m = line.side == EdgeSide::left ? 24.0 : 36.0;
    EXPECT_NEAR(length_m(line), 2.0 * std::numbers::pi * radius_m, 2.0);
  }
}

TEST(EdgeLines, TrucksSeenOnceAreLeftOut) {
  const Course course = test::straight_course({0.0, 0.0, 0.0}, 0.3, 200.0);
  const auto lines = lines_of(course, {.hits_per_m = 12.0, .outlier_share = 0.03});
  const Course left = test::beside(course, 7.0);
  const auto errors_m = distances_m(lines, EdgeSide::left, left);
  ASSERT_FALSE(errors_m.empty());
  EXPECT_LT(errors_m[errors_m.size() / 2], 0.06);
  EXPECT_LT(errors_m[errors_m.size() * 99 / 100], 0.5);
  EXPECT_GT(covered(lines, EdgeSide::left, left), 0.97);
}

TEST(EdgeLines, GapsStayGapsAndNarrowOnesAreCarried) {
  for (const double gap_m : {2.0, 12.0}) {
    const Course course = test::straight_course({0.0, 0.0, 0.0}, 0.0, 80.0);
    auto scans = test::drive(course, {.hits_per_m = 30.0});
    for (test::MadeScan& scan : scans) {
      std::erase_if(scan.edges, [&](const MappedEdge& edge) {
        return edge.side == EdgeSide::left && std::abs(edge.position_m.x() - 40.0) < 0.5 * gap_m;
      });
    }
    const auto lines = extract_lines(test::map_of(scans), {});
    const auto lefts =
        std::count_if(lines.begin(), lines.end(), [](const EdgeLine& line) { return line.side == EdgeSide::left; });
    EXPECT_EQ(lefts, gap_m < 5.0 ? 1 : 2);
    for (const EdgeLine& line : lines) {
      for (const EdgeLine::Vertex& vertex : line.vertices) {
        const double into_m = 0.5 * gap_m - std::abs(vertex.position_m.x() - 40.0);
        if (line.side == EdgeSide::left && into_m > 0.7) {
          EXPECT_LT(gap_m, 5.0);
          EXPECT_LE(vertex.confidence, 0.5);
        }
      }
    }
  }
}

/// Two pieces of an edge, 4 m and 6 m long, 8 m apart and in line.
std::vector<EdgeLine> lines_of_two_pieces(double hits_per_m) {
  EdgeMap map({});
  for (double x = 0.0; x < 18.0; x += 1.0 / hits_per_m) {
    if (x < 4.0 || x > 12.0) {
      map.add_scan(std::vector<MappedEdge>{{{x, 5.0, 0.0}, EdgeSide::left}}, {});
    }
  }
  return extract_lines(map, {});
}

TEST(EdgeLines, AGuessBetweenFaintPiecesIsNone) {
  EXPECT_TRUE(lines_of_two_pieces(2.5).empty());
  EXPECT_EQ(lines_of_two_pieces(20.0).size(), 1U);
}

TEST(EdgeLines, ARoadDrivenBothWaysKeepsItsLinesWhole) {
  const Course course = test::straight_course({0.0, 0.0, 0.0}, 0.3, 150.0);
  auto scans = test::drive(course, {.hits_per_m = 10.0, .seed = 1});
  auto back = test::drive(course, {.hits_per_m = 10.0, .seed = 2});
  for (test::MadeScan& scan : back) {
    for (MappedEdge& edge : scan.edges) {
      edge.side = edge.side == EdgeSide::left ? EdgeSide::right : EdgeSide::left;
    }
    scans.push_back(scan);
  }
  EXPECT_EQ(extract_lines(test::map_of(scans), {}).size(), 2U);
}

TEST(EdgeLines, AFewWrongSidesAreOutvoted) {
  const Course course = test::straight_course({0.0, 0.0, 0.0}, 0.3, 150.0);
  auto scans = test::drive(course, {});
  std::mt19937_64 random(5);
  for (test::MadeScan& scan : scans) {
    for (MappedEdge& edge : scan.edges) {
      if (test::made_uniform(random) < 0.2) {
        edge.side = edge.side == EdgeSide::left ? EdgeSide::right : EdgeSide::left;
      }
    }
  }
  const auto lines = extract_lines(test::map_of(scans), {});
  EXPECT_EQ(lines.size(), 2U);
  EXPECT_GT(covered(lines, EdgeSide::left, test::beside(course, 7.0)), 0.99);
  EXPECT_GT(covered(lines, EdgeSide::right, test::beside(course, -7.0)), 0.99);
}

TEST(EdgeLines, SparseHitsMakeALine) {
  // One hit a metre, which no voxel remembers twice.
  const Course course = test::straight_course({0.0, 0.0, 0.0}, 1.1, 200.0);
  const auto lines = lines_of(course, {.hits_per_m = 1.5});
  for (const EdgeSide side : {EdgeSide::left, EdgeSide::right}) {
    const Course edge = test::beside(course, side == EdgeSide::left ? 7.0 : -7.0);
    EXPECT_GT(covered(lines, side, edge), 0.9);
    const auto errors_m = distances_m(lines, side, edge);
    EXPECT_LT(errors_m[errors_m.size() / 2], 0.08);
  }
}

TEST(EdgeLines, BenchesAboveEachOtherStayApart) {
  // The toe of one bench runs 4 m above that of another, at the same place on the plan.
  const Course low = test::straight_course({0.0, 0.0, 100.0}, 0.0, 60.0);
  const Course high = test::straight_course({0.0, 0.0, 104.0}, 0.0, 60.0);
  auto scans = test::drive(low, {});
  const auto more = test::drive(high, {.seed = 2});
  scans.insert(scans.end(), more.begin(), more.end());
  const auto lines = extract_lines(test::map_of(scans), {});
  EXPECT_EQ(lines.size(), 4U);
  for (const EdgeLine& line : lines) {
    for (const EdgeLine::Vertex& vertex : line.vertices) {
      EXPECT_NEAR(std::min(std::abs(vertex.position_m.z() - 100.0), std::abs(vertex.position_m.z() - 104.0)), 0.0, 0.2);
    }
  }
}

TEST(EdgeLines, AnIslandIsClosed) {
  // A windrow of 12 m across in the middle of a yard, driven around with it on the left.
  const Course around = test::arc_course({0.0, 0.0, 0.0}, 10.0, 0.0, 2.0 * std::numbers::pi);
  auto scans = test::drive(around, {.half_width_m = 4.0});
  for (test::MadeScan& scan : scans) {
    std::erase_if(scan.edges, [](const MappedEdge& edge) { return edge.side == EdgeSide::right; });
  }
  const auto lines = extract_lines(test::map_of(scans), {});
  ASSERT_EQ(lines.size(), 1U);
  EXPECT_EQ(lines[0].side, EdgeSide::left);
  EXPECT_LT((lines[0].vertices.back().position_m - lines[0].vertices.front().position_m).norm(), 0.6);
  EXPECT_NEAR(length_m(lines[0]), 2.0 * std::numbers::pi * 6.0, 1.5);
}

TEST(EdgeLines, AnEdgeThatRunsIntoAnotherEndsOnIt) {
  EdgeMap map({});
  std::mt19937_64 random(4);
  for (int scan = 0; scan < 60; ++scan) {
    std::vector<MappedEdge> edges;
    for (int hit = 0; hit < 30; ++hit) {
      const double along_m = 30.0 * test::made_uniform(random);
      const double aside_m = 0.1 * test::made_noise(random);
      edges.push_back({{2.0 * along_m - 30.0, 7.0 + aside_m, 0.0}, EdgeSide::left});
      edges.push_back({{aside_m, 7.0 + along_m, 0.0}, EdgeSide::left});
    }
    map.add_scan(edges, {});
  }
  const auto lines = extract_lines(map, {});
  ASSERT_EQ(lines.size(), 2U);
  const bool first_is_branch = length_m(lines[0]) < length_m(lines[1]);
  const EdgeLine& branch = lines[first_is_branch ? 0 : 1];
  EXPECT_NEAR(length_m(branch), 30.0, 0.6);
  EXPECT_NEAR(length_m(lines[first_is_branch ? 1 : 0]), 60.0, 1.0);
  const bool front_meets = branch.vertices.front().position_m.y() < branch.vertices.back().position_m.y();
  const Eigen::Vector3d meeting_m = (front_meets ? branch.vertices.front() : branch.vertices.back()).position_m;
  EXPECT_NEAR(meeting_m.x(), 0.0, 0.2);
  EXPECT_NEAR(meeting_m.y(), 7.0, 0.1);
}

TEST(EdgeLines, PartsMeetAtASharpCorner) {
  EdgeMap map({});
  std::mt19937_64 random(6);
  for (int scan = 0; scan < 60; ++scan) {
    std::vector<MappedEdge> edges;
    for (int hit = 0; hit < 30; ++hit) {
      const Eigen::Vector3d noise(0.1 * test::made_noise(random), 0.1 * test::made_noise(random), 0.0);
      edges.push_back({Eigen::Vector3d(30.0 * test::made_uniform(random), 0.0, 0.0) + noise, EdgeSide::left});
      edges.push_back({Eigen::Vector3d(0.0, 30.0 * test::made_uniform(random), 0.0) + noise, EdgeSide::left});
    }
    map.add_scan(edges, {});
  }
  const auto lines = extract_lines(map, {});
  double total_m = 0.0;
  double from_corner_m = 1e9;
  for (const EdgeLine& line : lines) {
    total_m += length_m(line);
    for (const EdgeLine::Vertex& vertex : line.vertices) {
      from_corner_m = std::min(from_corner_m, vertex.position_m.norm());
      EXPECT_LT(std::min(std::abs(vertex.position_m.x()), std::abs(vertex.position_m.y())), 0.4);
    }
  }
  EXPECT_NEAR(total_m, 60.0, 1.5);
  EXPECT_LT(from_corner_m, 0.5);  // the distance of vertices, at most
  if (lines.size() == 2) {
    const Course other = course_of(lines[1]);
    const double gap_m = std::min(test::distance_m(other, lines[0].vertices.front().position_m),
                                  test::distance_m(other, lines[0].vertices.back().position_m));
    const Course first = course_of(lines[0]);
    const double other_gap_m = std::min(test::distance_m(first, other.front()), test::distance_m(first, other.back()));
    EXPECT_LT(std::min(gap_m, other_gap_m), 0.05);
  } else {
    EXPECT_EQ(lines.size(), 1U);
  }
}

TEST(EdgeLines, HitsAtTheEndOfTheLatticeAreHarmless) {
  EdgeMapConfig config;
  config.voxel_m = 5.0;
  EdgeMap map(config);
  for (const double sign : {-1.0, 1.0}) {
    for (int hit = 0; hit < 20; ++hit) {
      const Eigen::Vector3d place_m(sign * 5.36e9 + 5.0 * hit, sign * 5.36e9, 0.0);
      EXPECT_EQ(map.add_scan(std::vector<MappedEdge>{{place_m, EdgeSide::left}}, {}), 0U);
    }
  }
  for (const EdgeLine& line : extract_lines(map, {})) {
    for (const EdgeLine::Vertex& vertex : line.vertices) {
      EXPECT_TRUE(vertex.position_m.allFinite());
    }
  }
}

TEST(EdgeLines, StrayHitsMakeNone) {
  EdgeMap map({});
  std::mt19937_64 random(3);
  for (int scan = 0; scan < 300; ++scan) {
    const Eigen::Vector3d place_m(100.0 * test::made_uniform(random), 100.0 * test::made_uniform(random), 0.0);
    map.add_scan(std::vector<MappedEdge>{{place_m, EdgeSide::left}}, {});
  }
  EXPECT_TRUE(extract_lines(map, {}).empty());
}

TEST(EdgeLines, EdgesOfTwoRoadsMeetAtTheirCorners) {
  // A crossing of two roads, each driven; edges end where the other road begins.
  const Course east = test::straight_course({-60.0, 0.0, 0.0}, 0.0, 120.0);
  const Course north = test::straight_course({0.0, -60.0, 0.0}, 0.5 * std::numbers::pi, 120.0);
  auto scans = test::drive(east, {.hits_per_m = 30.0, .seed = 1});
  const auto more = test::drive(north, {.hits_per_m = 30.0, .seed = 2});
  scans.insert(scans.end(), more.begin(), more.end());
  for (test::MadeScan& scan : scans) {
    std::erase_if(scan.edges, [](const MappedEdge& edge) {
      return std::abs(edge.position_m.x()) < 6.9 && std::abs(edge.position_m.y()) < 7.5;
    });
    std::erase_if(scan.edges, [](const MappedEdge& edge) {
      return std::abs(edge.position_m.x()) < 7.5 && std::abs(edge.position_m.y()) < 6.9;
    });
  }
  const auto lines = extract_lines(test::map_of(scans), {});
  double total_m = 0.0;
  for (const EdgeLine& line : lines) {
    total_m += length_m(line);
    for (const EdgeLine::Vertex& vertex : line.vertices) {
      const double x = std::abs(vertex.position_m.x());
      const double y = std::abs(vertex.position_m.y());
      EXPECT_LT(std::min(std::hypot(std::max(7.0 - x, 0.0), y - 7.0), std::hypot(x - 7.0, std::max(7.0 - y, 0.0))),
                0.4);
    }
  }
  EXPECT_NEAR(total_m, 8.0 * 53.0, 8.0);
}

/// Where things lie along a road, and how far aside of its edge.
struct AlongAndAside {
  std::vector<double> along_m;
  std::vector<double> aside_m;
};

TEST(EdgeLines, LineWithinTheNoiseForAnyPlaceAndHeading) {
  // Law: median error below 0.05 m at a scatter of 0.1 m, wherever the lattice lies, near the origin or in UTM, and no
  // line beyond the voxel of its last hit. How far that hit itself lies beyond the road is chance: errors are measured
  // across.
  EXPECT_TRUE(rc::check([] {
    const double heading_rad = *rc::gen::inRange(0, 6283) * 1e-3;
    const Eigen::Vector3d from_m(*rc::gen::inRange(0, 1000) * 1e-2 + *rc::gen::element(0.0, 5e5),
                                 *rc::gen::inRange(0, 1000) * 1e-2 + *rc::gen::element(0.0, 5e6), 300.0);
    const auto scans = test::drive(test::straight_course(from_m, heading_rad, 40.0),
                                   {.hits_per_m = 20.0, .seed = *rc::gen::inRange<std::uint64_t>(0, 1000)});
    const auto lines = extract_lines(test::map_of(scans), {});
    RC_ASSERT(lines.size() == 2U);
    for (const EdgeSide side : {EdgeSide::left, EdgeSide::right}) {
      const auto add = [&](AlongAndAside& sum, EdgeSide of, const Eigen::Vector3d& place_m) {
        const Eigen::Vector2d to = (place_m - from_m).head<2>();
        if (of == side) {
          const Eigen::Vector2d along(std::cos(heading_rad), std::sin(heading_rad));
          sum.along_m.push_back(to.dot(along));
          const double left_m = to.y() * along.x() - to.x() * along.y();
          sum.aside_m.push_back(std::abs(left_m - (side == EdgeSide::left ? 7.0 : -7.0)));
        }
      };
      AlongAndAside hits;
      for (const test::MadeScan& scan : scans) {
        for (const MappedEdge& edge : scan.edges) {
          add(hits, edge.side, edge.position_m);
        }
      }
      AlongAndAside found;
      for (const EdgeLine& line : lines) {
        for (const EdgeLine::Vertex& vertex : line.vertices) {
          add(found, line.side, vertex.position_m);
        }
      }
      RC_ASSERT(!found.aside_m.empty());
      const auto [low, high] = std::minmax_element(found.along_m.begin(), found.along_m.end());
      const auto [first_hit, last_hit] = std::minmax_element(hits.along_m.begin(), hits.along_m.end());
      constexpr double kHalfVoxel_m = 0.15;  // to its corner, and what a slanting end adds
      RC_ASSERT(*low > *first_hit - kHalfVoxel_m);
      RC_ASSERT(*high < *last_hit + kHalfVoxel_m);
      std::sort(found.aside_m.begin(), found.aside_m.end());
      RC_ASSERT(found.aside_m[found.aside_m.size() / 2] < 0.05);
      RC_ASSERT(found.aside_m[found.aside_m.size() - 3] < 0.2);
      RC_ASSERT(found.aside_m.back() < 0.5);
    }
  }));
}

TEST(EdgeLines, AnyHitsGiveFiniteLinesNearHits) {
  // Hits that make no sense: clumps, crossing rows, single ones, any side, any height.
  EXPECT_TRUE(rc::check([] {
    std::mt19937_64 random(*rc::gen::arbitrary<std::uint64_t>());
    const double size_m = *rc::gen::element(2.0, 15.0, 60.0);
    EdgeMap map({});
    Course hits;
    for (int row = *rc::gen::inRange(0, 12); row > 0; --row) {
      const Eigen::Vector3d from_m(size_m * test::made_uniform(random), size_m * test::made_uniform(random),
                                   3.0 * test::made_uniform(random));
      const double heading_rad = 6.3 * test::made_uniform(random);
      const double length_m = size_m * test::made_uniform(random);
      for (double along_m = 0.0; along_m <= length_m; along_m += 0.3 * test::made_uniform(random)) {
        hits.emplace_back(from_m + along_m * Eigen::Vector3d(std::cos(heading_rad), std::sin(heading_rad), 0.0));
        map.add_scan(std::vector<MappedEdge>{{hits.back(), random() % 2 == 0 ? EdgeSide::left : EdgeSide::right}}, {});
      }
    }
    EdgeLinesConfig config;
    config.min_length_m = *rc::gen::element(0.0, 3.0);
    for (const EdgeLine& line : extract_lines(map, config)) {
      RC_ASSERT(line.vertices.size() >= 2U);
      for (const EdgeLine::Vertex& vertex : line.vertices) {
        RC_ASSERT(vertex.position_m.allFinite());
        RC_ASSERT(vertex.confidence >= 0.0 && vertex.confidence <= 0.97 + 1e-9);
        const bool near = std::any_of(hits.begin(), hits.end(), [&](const Eigen::Vector3d& hit_m) {
          return (hit_m - vertex.position_m).norm() < 0.5 * config.max_hidden_m + 0.5;
        });
        RC_ASSERT(near);
      }
    }
  }));
}

TEST(EdgeLines, TheSameForAnyOrderOfScans) {
  EXPECT_TRUE(rc::check([] {
    auto scans =
        test::drive(test::s_bend_course(10.0), {.half_width_m = 4.0, .hits_per_m = 10.0, .outlier_share = 0.1});
    const auto lines = extract_lines(test::map_of(scans), {});
    std::mt19937_64 random(*rc::gen::arbitrary<std::uint64_t>());
    std::shuffle(scans.begin(), scans.end(), random);
    const auto again = extract_lines(test::map_of(scans), {});
    RC_ASSERT(lines.size() == again.size());
    for (std::size_t i = 0; i < lines.size(); ++i) {
      RC_ASSERT(lines[i].side == again[i].side);
      RC_ASSERT(lines[i].vertices.size() == again[i].vertices.size());
      for (std::size_t k = 0; k < lines[i].vertices.size(); ++k) {
        RC_ASSERT(lines[i].vertices[k].position_m == again[i].vertices[k].position_m);
        RC_ASSERT(lines[i].vertices[k].confidence == again[i].vertices[k].confidence);
      }
    }
  }));
}

}  // namespace
}  // namespace berm
