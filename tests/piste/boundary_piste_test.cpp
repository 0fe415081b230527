// The whole method on a straight piste between banks.

#include "berm/piste/boundary_piste.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <numbers>
#include <optional>
#include <ostream>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "berm/core/angle.hpp"
#include "berm/core/error.hpp"
#include "piste/boundary_scene.hpp"
#include "piste/mid70_scan.hpp"

namespace berm {
namespace {

using test::PisteScan;
using test::StraightPiste;

/// What the groomer sees, a tenth of a second after the other from seed to seed.
PisteScan rosette_scan(const StraightPiste& piste, std::uint32_t seed = 1) {
  return test::look_at(piste, test::mid70_beams(std::size_t{seed} * 10000), test::groomer_mount(), {.seed = seed});
}

/// A sensor of rings that looks all around.
PisteScan full_turn(const StraightPiste& piste) {
  return test::look_at(piste, test::spinning_beams(48, -35.0, -1.0, 900),
                       Pose(Eigen::Quaterniond::Identity(), {0.0, 0.0, 2.3}));
}

/// A result that outlives the next call.
struct Kept {
  std::vector<Label> labels;
  std::vector<BoundaryPoint> left;
  std::vector<BoundaryPoint> right;
  std::optional<SlopeAhead> slope;
  std::optional<double> obstacle_ahead_m;
};

Kept process(BoundaryPiste& piste, const PisteInput& input) {
  const PisteResult result = piste.process(input);
  return {{result.labels.begin(), result.labels.end()},
          {result.left.begin(), result.left.end()},
          {result.right.begin(), result.right.end()},
          result.slope,
          result.obstacle_ahead_m};
}

Kept process(const PisteScan& scan, const BoundaryPisteConfig& config = {}) {
  BoundaryPiste piste(config);
  return process(piste, scan.input());
}

double median(std::vector<double> values) {
  if (values.empty()) {
    return 1e9;
  }
  std::nth_element(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2), values.end());
  return values[values.size() / 2];
}

/// How far the places of one side of several scans lie outside of the line y = `y_m`: the median, and that of the
/// absolute values.
struct Offset {
  double signed_m = 0.0;
  double absolute_m = 0.0;
};

Offset offset(const std::vector<BoundaryPoint>& boundary, double y_m) {
  std::vector<double> outside;
  std::vector<double> absolute;
  for (const BoundaryPoint& point : boundary) {
    outside.push_back(double{point.y_m} - y_m);
    absolute.push_back(std::abs(outside.back()));
  }
  return {median(outside), median(absolute)};
}

/// Share of the returns that are labelled as the truth is.
double accuracy(const PisteScan& scan, const Kept& result) {
  double right = 0.0;
  double all = 0.0;
  for (std::size_t i = 0; i < scan.labels.size(); ++i) {
    if (scan.labels[i] == Label::drivable) {
      right += (result.labels[i] == Label::drivable) == scan.on_piste[i] ? 1.0 : 0.0;
      all += 1.0;
    }
  }
  return right / all;
}

std::size_t count_different(const Kept& a, const Kept& b) {
  std::size_t different = 0;
  for (std::size_t i = 0; i < a.labels.size(); ++i) {
    different += a.labels[i] != b.labels[i] ? 1U : 0U;
  }
  return different;
}

void expect_same_bytes(const Kept& a, const Kept& b) {
  const auto same = [](const std::vector<BoundaryPoint>& l, const std::vector<BoundaryPoint>& r) {
    return l.size() == r.size() && (l.empty() || std::memcmp(l.data(), r.data(), l.size() * sizeof(l[0])) == 0);
  };
  EXPECT_TRUE(a.labels == b.labels);
  EXPECT_TRUE(same(a.left, b.left));
  EXPECT_TRUE(same(a.right, b.right));
  ASSERT_EQ(a.slope.has_value(), b.slope.has_value());
  if (a.slope) {
    EXPECT_EQ(a.slope->slope_rad, b.slope->slope_rad);
    EXPECT_EQ(a.slope->slope_sigma_rad, b.slope->slope_sigma_rad);
    EXPECT_EQ(a.slope->cross_fall_rad, b.slope->cross_fall_rad);
  }
  EXPECT_EQ(a.obstacle_ahead_m, b.obstacle_ahead_m);
}

void expect_close(const std::vector<BoundaryPoint>& a, const std::vector<BoundaryPoint>& b, double tolerance_m) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    EXPECT_NEAR(a[i].x_m, b[i].x_m, tolerance_m);
    EXPECT_NEAR(a[i].y_m, b[i].y_m, tolerance_m);
    EXPECT_NEAR(a[i].z_m, b[i].z_m, tolerance_m);
  }
}

struct Case {
  const char* name;
  StraightPiste piste;
};

void PrintTo(const Case& a_case, std::ostream* out) {
  *out << a_case.name;
}

class BoundaryPisteOnStraightPistes : public testing::TestWithParam<Case> {};

/// A bin is 4 % of the range long: 0.6 m at 15 m. The boundary has to be where it is on the whole, and each place of
/// it within about a bin.
TEST_P(BoundaryPisteOnStraightPistes, FindsBothSides) {
  const StraightPiste& piste = GetParam().piste;
  std::vector<BoundaryPoint> left;
  std::vector<BoundaryPoint> right;
  BoundaryPiste segmenter({});
  for (const std::uint32_t seed : {1U, 2U, 3U, 4U, 5U}) {
    const PisteScan scan = rosette_scan(piste, seed);
    const Kept result = process(segmenter, scan.input());
    EXPECT_GE(result.left.size(), 4U);
    EXPECT_GE(result.right.size(), 4U);
    left.insert(left.end(), result.left.begin(), result.left.end());
    right.insert(right.end(), result.right.begin(), result.right.end());
    EXPECT_GT(accuracy(scan, result), 0.97);
    ASSERT_TRUE(result.slope.has_value());
    EXPECT_NEAR(result.slope->slope_rad, std::atan(piste.climb), 0.01);
    EXPECT_NEAR(result.slope->cross_fall_rad.value_or(9.0), 0.0, 0.02);
    EXPECT_FALSE(result.obstacle_ahead_m.has_value());
  }
  const Offset left_offset = offset(left, piste.middle_y_m + piste.half_width_m);
  const Offset right_offset = offset(right, piste.middle_y_m - piste.half_width_m);
  EXPECT_LT(std::abs(left_offset.signed_m), 0.3);
  EXPECT_LT(std::abs(right_offset.signed_m), 0.3);
  EXPECT_LT(left_offset.absolute_m, 0.65);
  EXPECT_LT(right_offset.absolute_m, 0.65);
}

INSTANTIATE_TEST_SUITE_P(All, BoundaryPisteOnStraightPistes,
                         testing::Values(Case{"level", {}}, Case{"left", {.middle_y_m = 2.0}},
                                         Case{"right", {.middle_y_m = -2.0}}, Case{"uphill", {.climb = 0.15}},
                                         Case{"downhill", {.climb = -0.15}}, Case{"narrow", {.half_width_m = 6.0}},
                                         Case{"high_banks", {.bank_m = 1.5}}),
                         [](const auto& one) { return one.param.name; });

/// What lies behind an edge is hidden: the boundary is seen where the ground is seen again.
TEST(BoundaryPiste, FindsTheEdgesOfADam) {
  std::vector<BoundaryPoint> left;
  std::vector<BoundaryPoint> right;
  for (const std::uint32_t seed : {1U, 2U, 3U, 4U, 5U}) {
    const PisteScan scan = rosette_scan({.bank_m = -0.8}, seed);
    const Kept result = process(scan);
    EXPECT_GT(accuracy(scan, result), 0.97);
    left.insert(left.end(), result.left.begin(), result.left.end());
    right.insert(right.end(), result.right.begin(), result.right.end());
  }
  constexpr double kShadow_m = 8.0 * 0.8 / 2.3;
  for (const auto& [signed_m, absolute_m] : {offset(left, 8.0 + kShadow_m), offset(right, -8.0 - kShadow_m)}) {
    EXPECT_LT(absolute_m, kShadow_m + 0.6);
  }
}

TEST(BoundaryPiste, PutsTheBoundaryOnTheGround) {
  const StraightPiste piste{.climb = 0.1};
  const Kept result = process(rosette_scan(piste));
  for (const auto* side : {&result.left, &result.right}) {
    for (const BoundaryPoint& point : *side) {
      EXPECT_NEAR(point.z_m, piste.climb * point.x_m, 0.5);
      EXPECT_GT(point.confidence, 0.0F);
      EXPECT_LE(point.confidence, 1.0F);
    }
  }
}

TEST(BoundaryPiste, GoesFromNearToFar) {
  const Kept result = process(rosette_scan({}));
  for (const auto* side : {&result.left, &result.right}) {
    ASSERT_GE(side->size(), 5U);
    EXPECT_LT(side->front().x_m, 20.0F);
    EXPECT_GT(side->back().x_m, side->front().x_m + 10.0F);
  }
}

TEST(BoundaryPiste, FindsNoBoundaryWhereThereIsNone) {
  const PisteScan scan = rosette_scan({.half_width_m = 1000.0});
  const Kept result = process(scan);
  EXPECT_TRUE(result.left.empty());
  EXPECT_TRUE(result.right.empty());
  EXPECT_TRUE(result.labels == scan.labels);
}

TEST(BoundaryPiste, FindsTheMirrorImageOfAMirrorImage) {
  for (const StraightPiste& piste : {StraightPiste{}, StraightPiste{.middle_y_m = 2.5}}) {
    for (const std::uint32_t seed : {1U, 2U, 3U}) {
      const PisteScan scan = rosette_scan(piste, seed);
      const Kept result = process(scan);
      const Kept mirrored = process(test::mirrored(scan));
      EXPECT_LE(count_different(result, mirrored), scan.labels.size() / 200);
      for (const auto& [a, b] : {std::pair{&result.left, &mirrored.right}, std::pair{&result.right, &mirrored.left}}) {
        ASSERT_EQ(a->size(), b->size());
        for (std::size_t i = 0; i < a->size(); ++i) {
          EXPECT_NEAR((*a)[i].x_m, (*b)[i].x_m, 1e-2);
          EXPECT_NEAR((*a)[i].y_m, -(*b)[i].y_m, 1e-2);
          EXPECT_NEAR((*a)[i].z_m, (*b)[i].z_m, 1e-2);
        }
      }
      ASSERT_TRUE(result.slope && mirrored.slope);
      EXPECT_NEAR(result.slope->slope_rad, mirrored.slope->slope_rad, 1e-4);
      EXPECT_NEAR(result.slope->cross_fall_rad.value_or(9.0), -mirrored.slope->cross_fall_rad.value_or(9.0), 1e-4);
    }
  }
}

TEST(BoundaryPiste, DoesNotCareHowTheSensorHangs) {
  const PisteScan scan = rosette_scan({});
  const Kept result = process(scan);
  for (const double angle_deg : {-170.0, -30.0, 20.0, 90.0}) {
    for (const Eigen::Vector3d& axis :
         {Eigen::Vector3d(1, 0, 0), Eigen::Vector3d(0, 1, 0), Eigen::Vector3d(0, 0, 1), Eigen::Vector3d(1, 2, 3)}) {
      const Kept other = process(
          test::remounted(scan, Eigen::Quaterniond(Eigen::AngleAxisd(angle_deg * kRadPerDeg, axis.normalized()))));
      EXPECT_LE(count_different(result, other), scan.labels.size() / 500);
      expect_close(other.left, result.left, 0.3);
      expect_close(other.right, result.right, 0.3);
      ASSERT_TRUE(other.slope.has_value());
      EXPECT_NEAR(other.slope->slope_rad, result.slope.value_or(SlopeAhead{}).slope_rad, 1e-3);
    }
  }
}

/// The origin of base_link may lie elsewhere than below the sensor.
TEST(BoundaryPiste, MovesItsBoundaryWithTheSensor) {
  const PisteScan scan = rosette_scan({});
  const Kept result = process(scan);
  PisteScan moved = scan;
  moved.T_base_sensor = Pose(Eigen::Quaterniond::Identity(), {20.0, -10.0, 0.0}) * scan.T_base_sensor;
  Kept other = process(moved);
  EXPECT_TRUE(other.labels == result.labels);
  for (auto* side : {&other.left, &other.right}) {
    for (BoundaryPoint& point : *side) {
      point.x_m -= 20.0F;
      point.y_m += 10.0F;
    }
  }
  expect_close(other.left, result.left, 1e-3);
  expect_close(other.right, result.right, 1e-3);
}

/// The level frame of the ground stage may be tilted and turned against base_link.
TEST(BoundaryPiste, SpeaksOfBaseLinkWhateverTheSurfaceIsLevelledTo) {
  const PisteScan scan = rosette_scan({.climb = 0.1});
  for (const double yaw_deg : {0.0, 30.0, 180.0}) {
    const Pose T_base_level = Pose::from_yaw_pitch_roll(yaw_deg * kRadPerDeg, 0.0, 0.0, {0.0, 0.0, 0.0}) *
                              Pose::from_yaw_pitch_roll(0.0, -4.0 * kRadPerDeg, 3.0 * kRadPerDeg, {0.0, 0.0, 0.05});
    HeightGrid surface(PolarGrid(60, 10, 1.0, 50.0));
    surface.set_T_level_sensor(T_base_level.inverse() * scan.T_base_sensor);
    PisteInput input = scan.input();
    input.surface = &surface;
    BoundaryPiste piste({});
    const Kept result = process(piste, input);
    EXPECT_LT(offset(result.left, 8.0).absolute_m, 0.8) << yaw_deg;
    EXPECT_LT(offset(result.right, -8.0).absolute_m, 0.8) << yaw_deg;
    EXPECT_GT(accuracy(scan, result), 0.97) << yaw_deg;
    ASSERT_TRUE(result.slope.has_value());
    EXPECT_NEAR(result.slope->slope_rad, std::atan(0.1), 0.01) << yaw_deg;
  }
}

TEST(BoundaryPiste, ChangesNothingButGroundToTerrain) {
  const PisteScan scan = rosette_scan({});
  PisteInput input = scan.input();
  std::vector<Label> labels = scan.labels;
  for (std::size_t i = 0; i < labels.size(); ++i) {
    if (labels[i] == Label::drivable && i % 4 != 0) {
      labels[i] = i % 16 == 1   ? Label::obstacle
                  : i % 16 == 2 ? Label::falling_snow
                  : i % 16 == 3 ? Label::unlabeled
                                : Label::drivable;
    }
  }
  input.labels = labels;
  BoundaryPiste piste({});
  const Kept result = process(piste, input);
  std::size_t terrain = 0;
  for (std::size_t i = 0; i < labels.size(); ++i) {
    if (result.labels[i] != labels[i]) {
      ASSERT_EQ(labels[i], Label::drivable);
      ASSERT_EQ(result.labels[i], Label::terrain);
      ++terrain;
    }
  }
  EXPECT_GT(terrain, 100U);
}

TEST(BoundaryPiste, GivesTheSameBytesAgain) {
  const PisteScan scan = rosette_scan({});
  BoundaryPiste piste({});
  const Kept result = process(piste, scan.input());
  (void)process(piste, full_turn({.middle_y_m = 3.0, .bank_m = 2.0}).input());
  (void)process(piste, {});
  expect_same_bytes(process(piste, scan.input()), result);
  expect_same_bytes(process(scan), result);
}

TEST(BoundaryPiste, FindsBothSidesWithoutFiringOrder) {
  // Without the shape along traces only banks that are high enough show.
  const PisteScan scan = test::shuffled(rosette_scan({.bank_m = 2.0, .bank_run_m = 2.0, .rough_m = 0.1}), 1);
  const Kept result = process(scan);
  EXPECT_LT(offset(result.left, 8.0).absolute_m, 1.5);
  EXPECT_LT(offset(result.right, -8.0).absolute_m, 1.5);
  EXPECT_GT(accuracy(scan, result), 0.95);
}

TEST(BoundaryPiste, FindsBothSidesAllAround) {
  const PisteScan scan = full_turn({});
  const Kept result = process(scan);
  EXPECT_GT(accuracy(scan, result), 0.95);
  EXPECT_LT(offset(result.left, 8.0).absolute_m, 0.3);
  EXPECT_LT(offset(result.right, -8.0).absolute_m, 0.3);
  EXPECT_GE(result.left.size(), 30U);
  EXPECT_GE(result.right.size(), 30U);
  for (const BoundaryPoint& point : result.left) {
    EXPECT_GT(point.y_m, 0.0F);
  }
  for (const BoundaryPoint& point : result.right) {
    EXPECT_LT(point.y_m, 0.0F);
  }
}

TEST(BoundaryPiste, TakesASensorThatLooksBackwards) {
  const Pose mount = Pose::from_yaw_pitch_roll(std::numbers::pi, 11.0 * kRadPerDeg, 0.0, {0.0, 0.0, 2.3});
  const PisteScan scan = test::look_at({}, test::mid70_beams(), mount);
  const Kept result = process(scan);
  EXPECT_GT(accuracy(scan, result), 0.97);
  EXPECT_FALSE(result.slope.has_value()) << "nothing is seen ahead";
  for (const auto* side : {&result.left, &result.right}) {
    for (const BoundaryPoint& point : *side) {
      EXPECT_LT(point.x_m, 0.0F);
      EXPECT_NEAR(std::abs(point.y_m), 8.0, 2.0);
    }
  }
}

TEST(BoundaryPiste, SeesAFenceOnFlatSnow) {
  // Level ground on both sides of a fence 5 m to the left.
  PisteScan scan = rosette_scan({.half_width_m = 1000.0});
  const PointsView points = scan.cloud.view();
  PointChannels channels;
  for (std::size_t i = 0; i < points.size(); ++i) {
    Eigen::Vector3d p(points.x[i], points.y[i], points.z[i]);
    const Eigen::Vector3d in_base = scan.T_base_sensor * p;
    if (in_base.y() > 5.0) {
      p *= 5.0 / in_base.y();
      scan.labels[i] = (scan.T_base_sensor * p).z() < 1.5 ? Label::obstacle : Label::no_return;
    }
    channels.x.push_back(static_cast<float>(p.x()));
    channels.y.push_back(static_cast<float>(p.y()));
    channels.z.push_back(static_cast<float>(p.z()));
  }
  scan.cloud = PointCloud(std::move(channels));
  const Kept result = process(scan);
  EXPECT_GE(result.left.size(), 5U);
  EXPECT_LT(offset(result.left, 5.0).absolute_m, 0.5);
  EXPECT_TRUE(result.right.empty());
  BoundaryPisteConfig blind;
  blind.use_obstacles = false;
  EXPECT_TRUE(process(scan, blind).left.empty());
}

TEST(BoundaryPiste, SaysNothingOfNothing) {
  const Kept result = process(PisteScan{});
  EXPECT_TRUE(result.labels.empty());
  EXPECT_TRUE(result.left.empty());
  EXPECT_TRUE(result.right.empty());
  EXPECT_FALSE(result.slope.has_value());
  EXPECT_FALSE(result.obstacle_ahead_m.has_value());
}

TEST(BoundaryPiste, RefusesSettingsBeyondTheirRange) {
  BoundaryPisteConfig config;
  config.passes = 0;
  EXPECT_THROW(BoundaryPiste{config}, ConfigError);
  config = {};
  config.slope_noise = std::nan("");
  EXPECT_THROW(BoundaryPiste{config}, ConfigError);
}

}  // namespace
}  // namespace berm
