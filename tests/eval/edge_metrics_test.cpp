#include "berm/eval/edge_metrics.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include "berm/core/error.hpp"

namespace berm {
namespace {

using Eigen::Vector3d;

EdgeLine line(EdgeSide side, const std::vector<Vector3d>& places_m) {
  EdgeLine line{side, {}};
  for (const Vector3d& place_m : places_m) {
    line.vertices.push_back({place_m, 1.0});
  }
  return line;
}

EdgeLine along_x(EdgeSide side, double from_m, double to_m, double y_m, double z_m = 0.0) {
  return line(side, {{from_m, y_m, z_m}, {to_m, y_m, z_m}});
}

const std::vector<Vector3d> kPath = {{0.0, 0.0, 0.0}, {100.0, 0.0, 0.0}};

TEST(EdgeMetrics, NothingFoundNothingTrue) {
  const EdgeScore nothing = judge_edges({}, {}, {});
  EXPECT_FALSE(nothing.precision || nothing.recall || nothing.f1 || nothing.lateral_median_m ||
               nothing.wrong_side_share);
  const EdgeScore missed = judge_edges({}, std::vector{along_x(EdgeSide::left, 0.0, 100.0, 7.0)}, kPath);
  EXPECT_FALSE(missed.precision.has_value());
  EXPECT_EQ(missed.recall, 0.0);
  EXPECT_EQ(missed.truth, 400U);  // every 0.25 m from the first vertex on
  const EdgeScore invented = judge_edges(std::vector{along_x(EdgeSide::left, 0.0, 100.0, 7.0)}, {}, kPath);
  EXPECT_EQ(invented.precision, 0.0);
  EXPECT_FALSE(invented.recall.has_value());
}

TEST(EdgeMetrics, CountsByHand) {
  // Half of a true edge found, 0.2 m off; as much again invented; heights do not matter.
  const std::vector truth = {along_x(EdgeSide::left, 0.0, 100.0, 7.0)};
  const std::vector found = {along_x(EdgeSide::left, 0.0, 50.0, 7.2, 30.0), along_x(EdgeSide::left, 0.0, 50.0, 9.0)};
  const EdgeScore score = judge_edges(found, truth, kPath);
  EXPECT_EQ(score.found, 400U);
  EXPECT_EQ(score.found_right, 200U);
  EXPECT_DOUBLE_EQ(*score.precision, 0.5);
  EXPECT_NEAR(*score.recall, 0.5, 0.006);  // the end of the found line reaches 0.46 m further
  EXPECT_NEAR(*score.f1, 0.5, 0.003);
  EXPECT_NEAR(*score.lateral_median_m, 0.2, 1e-9);
  EXPECT_NEAR(*score.lateral_p95_m, 0.2, 1e-9);
  EXPECT_EQ(score.wrong_side_share, 0.0);
}

TEST(EdgeMetrics, LateralErrorIsThatOfWhatIsRight) {
  // From 0 to 1 m off: half of it is right, spread evenly from 0 to 0.5 m.
  const std::vector truth = {along_x(EdgeSide::left, -10.0, 110.0, 7.0)};
  const std::vector found = {line(EdgeSide::left, {{0.0, 7.0, 0.0}, {100.0, 8.0, 0.0}})};
  const EdgeScore score = judge_edges(found, truth, kPath);
  EXPECT_NEAR(*score.precision, 0.5, 0.005);
  EXPECT_NEAR(*score.lateral_median_m, 0.25, 0.005);
  EXPECT_NEAR(*score.lateral_p95_m, 0.475, 0.005);
}

TEST(EdgeMetrics, SidesAreJudgedApart) {
  const std::vector truth = {along_x(EdgeSide::left, 0.0, 100.0, 7.0), along_x(EdgeSide::right, 0.0, 100.0, -7.0)};
  const std::vector found = {along_x(EdgeSide::left, 0.0, 100.0, 7.0), along_x(EdgeSide::left, 0.0, 25.0, -7.0)};
  const EdgeScore score = judge_edges(found, truth, kPath);
  EXPECT_EQ(score.precision, 1.0);
  EXPECT_NEAR(*score.wrong_side_share, 0.2, 1e-12);
}

TEST(EdgeMetrics, TruthIsAskedForNearThePathAlone) {
  const std::vector truth = {along_x(EdgeSide::left, 0.0, 300.0, 7.0), along_x(EdgeSide::left, 0.0, 100.0, 40.0)};
  const EdgeScore score = judge_edges(truth, truth, kPath);
  const double beyond_m = std::sqrt(25.0 * 25.0 - 7.0 * 7.0);
  EXPECT_NEAR(static_cast<double>(score.truth), (100.0 + beyond_m) / 0.25, 1.0);
  EXPECT_EQ(score.recall, 1.0);
  EXPECT_EQ(score.precision, 1.0);
}

TEST(EdgeMetrics, AStandingMachineChangesNothing) {
  std::vector<Vector3d> path_m(5000, kPath[0]);
  path_m.insert(path_m.end(), 5000, kPath[1]);
  const std::vector truth = {along_x(EdgeSide::right, -50.0, 150.0, -7.0)};
  EXPECT_EQ(judge_edges(truth, truth, path_m).truth, judge_edges(truth, truth, kPath).truth);
}

TEST(EdgeMetrics, FarFromTheOriginTheSame) {
  EXPECT_TRUE(rc::check("also at UTM coordinates", [] {
    const Vector3d far_m(512'345.25, 7'412'345.5, 480.0);
    std::vector<EdgeLine> truth;
    std::vector<EdgeLine> found;
    for (int i = 0; i < 3; ++i) {
      const auto place = []() -> Vector3d {
        return Vector3d(*rc::gen::inRange(-100, 100), *rc::gen::inRange(-30, 30), 0.0) * 0.5;
      };
      truth.push_back(line(i == 0 ? EdgeSide::left : EdgeSide::right, {place(), place(), place()}));
      found.push_back(line(EdgeSide::left, {place(), place()}));
    }
    const EdgeScore near = judge_edges(found, truth, kPath);
    const auto moved = [&](std::vector<EdgeLine> lines) {
      for (EdgeLine& each : lines) {
        for (EdgeLine::Vertex& vertex : each.vertices) {
          vertex.position_m += far_m;
        }
      }
      return lines;
    };
    const std::vector<Vector3d> path_m = {kPath[0] + far_m, kPath[1] + far_m};
    const EdgeScore far = judge_edges(moved(found), moved(truth), path_m);
    // Samples at a cell's border, or at the tolerance, may fall to either side by rounding.
    const auto close = [](std::uint64_t a, std::uint64_t b) { return std::max(a, b) - std::min(a, b) <= 6; };
    RC_ASSERT(close(near.found, far.found));
    RC_ASSERT(close(near.found_right, far.found_right));
    RC_ASSERT(close(near.truth, far.truth));
    RC_ASSERT(close(near.truth_found, far.truth_found));
  }));
}

TEST(EdgeMetrics, AgreesWithTryingEveryPiece) {
  EXPECT_TRUE(rc::check("short lines, long lines, lines of one vertex", [] {
    const auto lines = [](int count) {
      std::vector<EdgeLine> made;
      for (int i = 0; i < count; ++i) {
        EdgeLine each{EdgeSide::left, {}};
        for (int k = *rc::gen::inRange(1, 4); k > 0; --k) {
          each.vertices.push_back({Vector3d(*rc::gen::inRange(-80, 80), *rc::gen::inRange(-8, 8), 0.0) * 0.1, 1.0});
        }
        made.push_back(each);
      }
      return made;
    };
    const auto truth = lines(4);
    const auto found = lines(2);
    std::uint64_t right = 0;
    for (const EdgeLine& each : found) {
      if (each.vertices.size() != 1) {
        continue;
      }
      const Eigen::Vector2d at_m = each.vertices[0].position_m.head<2>();
      double least_m = std::numeric_limits<double>::infinity();
      for (const EdgeLine& other : truth) {
        for (std::size_t i = 0; i < other.vertices.size(); ++i) {
          const Eigen::Vector2d from_m = other.vertices[i == 0 ? 0 : i - 1].position_m.head<2>();
          const Eigen::Vector2d along_m = other.vertices[i].position_m.head<2>() - from_m;
          const double length2 = along_m.squaredNorm();
          const double share = length2 > 0.0 ? std::clamp((at_m - from_m).dot(along_m) / length2, 0.0, 1.0) : 0.0;
          least_m = std::min(least_m, (at_m - from_m - share * along_m).norm());
        }
      }
      RC_PRE(std::abs(least_m - 0.5) > 1e-9);
      right += least_m < 0.5 ? 1U : 0U;
    }
    std::vector<EdgeLine> points;
    for (const EdgeLine& each : found) {
      if (each.vertices.size() == 1) {
        points.push_back(each);
      }
    }
    RC_ASSERT(judge_edges(points, truth, kPath).found_right == right);
  }));
}

TEST(EdgeMetrics, RefusesWhatCannotBeJudged) {
  const std::vector good = {along_x(EdgeSide::left, 0.0, 10.0, 7.0)};
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW((void)judge_edges(std::vector{along_x(EdgeSide::left, nan, 10.0, 7.0)}, good, kPath), Error);
  EXPECT_THROW((void)judge_edges(good, std::vector{along_x(EdgeSide::left, 0.0, 1e300, 7.0)}, kPath), Error);
  EXPECT_THROW((void)judge_edges(good, std::vector{along_x(EdgeSide::left, 0.0, 9e6, 7.0)}, kPath), Error);
  EXPECT_THROW((void)judge_edges(good, good, std::vector<Vector3d>{{nan, 0.0, 0.0}}), Error);
  EXPECT_THROW((void)judge_edges(good, good, kPath, {.sample_m = 0.0}), Error);
  EXPECT_THROW((void)judge_edges(good, good, kPath, {.tolerance_m = nan}), Error);
}

}  // namespace
}  // namespace berm
