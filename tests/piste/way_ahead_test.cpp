#include "way_ahead.hpp"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include "berm/core/angle.hpp"
#include "list_points.hpp"
#include "piste/made_windows.hpp"

namespace berm {
namespace {

PisteSurface fitted_way(const TraceWindows& windows) {
  PisteSurface surface;
  surface.fit(windows, std::vector<std::uint8_t>(windows.size(), 1), {}, {}, {.height_m = 0.01, .slope = 0.01});
  return surface;
}

/// Windows on the plane z = dz_dx x + dz_dy y of base_link, seen in a frame that is turned against it.
TraceWindows windows_on_plane(double dz_dx, double dz_dy, const Pose& T_level_base, double to_m = 45.0) {
  const auto z_of = [&](double x, double y) { return dz_dx * x + dz_dy * y; };
  const TraceWindows base = test::scattered_windows(1000, 3.0, to_m, 0.6, z_of);
  TraceWindows level;
  for (std::size_t i = 0; i < base.size(); ++i) {
    const Eigen::Vector3d here(base.x[i], base.y[i], base.z[i]);
    const Eigen::Vector3d step(base.along_x[i], base.along_y[i], base.slope[i]);
    const Eigen::Vector3d there = T_level_base * here;
    const Eigen::Vector3d along = T_level_base.rotation() * step;
    const double heading_rad = std::atan2(along.y(), along.x());
    const double slope = along.z() / std::hypot(along.x(), along.y());
    test::add_window(level, {there.x(), there.y(), heading_rad}, [&](double x, double y) {
      return there.z() + slope * ((x - there.x()) * std::cos(heading_rad) + (y - there.y()) * std::sin(heading_rad));
    });
  }
  return level;
}

TEST(SlopeAhead, IsThatInBaseLinkHoweverTheLevelFrameLies) {
  EXPECT_TRUE(rc::check([] {
    const double slope_rad = *rc::gen::inRange(-300, 301) * 1e-3;
    const double fall_rad = *rc::gen::inRange(-200, 201) * 1e-3;
    const Pose T_level_base =
        Pose::from_yaw_pitch_roll(*rc::gen::inRange(-180, 181) * kRadPerDeg, *rc::gen::inRange(-15, 16) * kRadPerDeg,
                                  *rc::gen::inRange(-15, 16) * kRadPerDeg, {0.4, -0.3, 0.2});
    const PisteSurface surface = fitted_way(windows_on_plane(std::tan(slope_rad), std::tan(fall_rad), T_level_base));
    const std::optional<SlopeAhead> found = find_slope_ahead(surface, T_level_base.inverse(), 100.0);
    RC_ASSERT(found.has_value());
    RC_ASSERT(std::abs(found->slope_rad - slope_rad) < 2e-3);
    RC_ASSERT(found->cross_fall_rad.has_value());
    RC_ASSERT(std::abs(*found->cross_fall_rad - fall_rad) < 2e-3);
    RC_ASSERT(found->slope_sigma_rad > 0.0);
    RC_ASSERT(found->cross_fall_sigma_rad > 0.0);
  }));
}

TEST(SlopeAhead, IsPositiveUphillAndWhereTheRightIsLower) {
  const PisteSurface surface = fitted_way(windows_on_plane(0.2, 0.1, {}));
  const std::optional<SlopeAhead> found = find_slope_ahead(surface, {}, 100.0);
  ASSERT_TRUE(found.has_value());
  EXPECT_NEAR(found->slope_rad, std::atan(0.2), 1e-3);
  EXPECT_NEAR(found->cross_fall_rad.value_or(0.0), std::atan(0.1), 1e-3);
}

/// P's slope is that between 10 and 40 m, not that under the machine.
TEST(SlopeAhead, IsThatOfTheStretchAhead) {
  const auto bend = [](double x, double) { return 0.004 * x * x; };
  const PisteSurface surface = fitted_way(test::scattered_windows(2000, 3.0, 45.0, 0.6, bend));
  const std::optional<SlopeAhead> far = find_slope_ahead(surface, {}, 100.0);
  const std::optional<SlopeAhead> near = find_slope_ahead(surface, {}, 20.0);
  ASSERT_TRUE(far.has_value() && near.has_value());
  EXPECT_NEAR(far->slope_rad, std::atan(0.2), 3e-3);
  EXPECT_NEAR(near->slope_rad, std::atan(0.12), 3e-3);
}

TEST(SlopeAhead, IsUnknownWhereLittleIsSeen) {
  EXPECT_FALSE(find_slope_ahead({}, {}, 100.0).has_value());
  const auto flat = [](double, double) { return 0.0; };
  const auto found = [&](int count, double to_m, double ends_m) {
    PisteSurface surface;
    const TraceWindows windows = test::scattered_windows(count, 3.0, to_m, 0.6, flat);
    surface.fit(windows, std::vector<std::uint8_t>(windows.size(), 1), {}, {}, {});
    return find_slope_ahead(surface, {}, ends_m).has_value();
  };
  EXPECT_TRUE(found(1000, 40.0, 100.0));
  EXPECT_FALSE(found(3, 40.0, 100.0));
  EXPECT_FALSE(found(100, 6.0, 100.0)) << "nothing seen beyond 6 m";
  EXPECT_FALSE(found(1000, 40.0, 12.0)) << "the piste ends too soon";
  EXPECT_FALSE(found(1000, 40.0, 0.0));
}

TEST(SlopeAhead, IsLessCertainTheLessIsSeen) {
  const auto flat = [](double, double) { return 0.0; };
  const auto sigma = [&](int count) {
    return find_slope_ahead(fitted_way(test::scattered_windows(count, 3.0, 45.0, 0.6, flat)), {}, 100.0)
        .value_or(SlopeAhead{.slope_sigma_rad = 9.0})
        .slope_sigma_rad;
  };
  EXPECT_LT(sigma(2000), sigma(100));
}

/// Points in base_link and what looks for them from a level frame turned by `T_level_base`.
struct Way {
  Pose T_level_base;
  PisteSurface surface;
  BoundaryPisteConfig config;
  std::vector<Label> labels;
  LevelPoints level;

  void add(double x_m, double y_m, double z_m, int count = 5, Label label = Label::obstacle) {
    const Eigen::Vector3d p = T_level_base * Eigen::Vector3d(x_m, y_m, z_m);
    for (int i = 0; i < count; ++i) {
      level.x.push_back(static_cast<float>(p.x()));
      level.y.push_back(static_cast<float>(p.y()));
      level.z.push_back(static_cast<float>(p.z()));
      labels.push_back(label);
    }
  }
  [[nodiscard]] std::optional<double> find() const {
    std::vector<std::uint32_t> obstacles;
    list_points(labels, Label::obstacle, obstacles);
    return ObstacleAhead(config).find(obstacles, level, surface, T_level_base.inverse());
  }
};

TEST(ObstacleAhead, IsFoundWithinHalfAMetre) {
  EXPECT_TRUE(rc::check([] {
    Way way;
    way.T_level_base =
        Pose::from_yaw_pitch_roll(*rc::gen::inRange(-180, 181) * kRadPerDeg, *rc::gen::inRange(-10, 11) * kRadPerDeg,
                                  *rc::gen::inRange(-10, 11) * kRadPerDeg, {0.0, 0.0, 0.3});
    const double x_m = *rc::gen::inRange(101, 9999) * 1e-2;
    way.surface = fitted_way(windows_on_plane(0.0, 0.0, way.T_level_base, 100.0));
    way.add(x_m, *rc::gen::inRange(-24, 25) * 0.1, *rc::gen::inRange(0, 35) * 0.1);
    way.add(x_m + 0.3, 0.0, 1.0, 1);
    way.add(x_m + 20.0, 0.0, 1.0, 50);
    const std::optional<double> found = way.find();
    RC_ASSERT(found.has_value());
    RC_ASSERT(std::abs(*found - x_m) <= 0.51);
  }));
}

TEST(ObstacleAhead, IsTheNearestInTheWay) {
  Way way;
  way.add(12.2, 0.0, 1.0);
  EXPECT_NEAR(way.find().value_or(0.0), 12.2, 0.5);
  way.add(8.0, 2.6, 1.0);  // beside the machine
  way.add(8.0, -2.6, 1.0);
  way.add(-5.0, 0.0, 1.0);    // behind
  way.add(7.0, 0.0, 4.5);     // a rope above it
  way.add(6.0, 0.0, 1.0, 1);  // one stray point
  way.add(9.0, 0.0, 0.5, 50, Label::drivable);
  way.add(9.0, 0.0, 0.5, 50, Label::falling_snow);
  way.add(9.0, 0.0, 0.5, 50, Label::unlabeled);
  EXPECT_NEAR(way.find().value_or(0.0), 12.2, 0.5);
  way.add(8.0, 2.4, 1.0);
  EXPECT_NEAR(way.find().value_or(0.0), 8.0, 0.5);
}

TEST(ObstacleAhead, IsNoneInAFreeWay) {
  Way way;
  EXPECT_FALSE(way.find().has_value());
  way.add(10.0, 0.0, 1.0, 2);
  way.add(20.0, 0.0, 1.0, 2);
  way.add(30.0, 0.0, 1.0, 2);
  EXPECT_FALSE(way.find().has_value()) << "strays";
}

TEST(ObstacleAhead, IsCountedAcrossTheBorderOfTwoHalfMetres) {
  Way way;
  way.add(11.99, 0.0, 1.0, 2);
  way.add(12.01, 0.0, 1.0, 2);
  EXPECT_NEAR(way.find().value_or(0.0), 12.0, 0.51);
}

/// Height counts from the snow there, not from the level of the machine.
TEST(ObstacleAhead, IsMeasuredFromTheSurface) {
  Way way;
  way.surface = fitted_way(windows_on_plane(0.3, 0.0, {}));
  way.add(20.0, 0.0, 6.0 + 1.0);
  EXPECT_NEAR(way.find().value_or(0.0), 20.0, 0.5);
  Way rope;
  rope.surface = way.surface;
  rope.add(20.0, 0.0, 6.0 + 4.5);
  EXPECT_FALSE(rope.find().has_value());
}

TEST(ObstacleAhead, IsLookedForAsFarAsAsked) {
  Way way;
  way.add(60.0, 0.0, 1.0);
  EXPECT_TRUE(way.find().has_value());
  way.config.max_range_m = 50.0;
  EXPECT_FALSE(way.find().has_value());
}

TEST(ObstacleAhead, FollowsTheSizeOfTheMachine) {
  Way way;
  way.add(10.0, 4.0, 1.0);
  way.add(20.0, 0.0, 5.0);
  EXPECT_FALSE(way.find().has_value());
  way.config.machine_height_m = 6.0;
  EXPECT_NEAR(way.find().value_or(0.0), 20.0, 0.5);
  way.config.machine_width_m = 9.0;
  EXPECT_NEAR(way.find().value_or(0.0), 10.0, 0.5);
}

TEST(ObstacleAhead, TakesAnyNumbers) {
  for (const float far : {1e20F, std::numeric_limits<float>::max(), std::numeric_limits<float>::infinity(),
                          std::numeric_limits<float>::quiet_NaN()}) {
    for (const float sign : {1.0F, -1.0F}) {
      Way way;
      way.add(10.0, 0.0, 1.0);
      way.level.x.assign(5, sign * far);
      EXPECT_FALSE(way.find().has_value()) << far;
      way.add(12.0, 0.0, 1.0);
      EXPECT_NEAR(way.find().value_or(0.0), 12.0, 0.5) << far;
    }
  }
}

}  // namespace
}  // namespace berm
