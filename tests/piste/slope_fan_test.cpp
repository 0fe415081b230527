#include "slope_fan.hpp"

#include <cmath>
#include <limits>
#include <numbers>

#include <gtest/gtest.h>

#include "made_series.hpp"

// P eq. 2 by hand. Cells are [10, 12), [12, 14) ... [38, 40) m.

namespace berm {
namespace {

using test::MadeSeries;

constexpr double kPi = std::numbers::pi;

std::optional<SlopeAhead> slope_of(const MadeSeries& series, const Pose& T_base_sensor = {}) {
  return SlopeFan({}).measure(series.in_base(T_base_sensor), series.interpolated);
}

/// A point in the middle of every cell, straight ahead.
MadeSeries ramp(double rise) {
  MadeSeries series;
  for (int k = 0; k < 15; ++k) {
    series.add(11.0 + 2.0 * k, 0.0, rise * (11.0 + 2.0 * k));
  }
  return series;
}

/// A point at a distance and bearing.
void add_at(MadeSeries& series, double distance_m, double bearing_deg, double z_m) {
  const double bearing_rad = bearing_deg * kPi / 180.0;
  series.add(distance_m * std::cos(bearing_rad), distance_m * std::sin(bearing_rad), z_m);
}

TEST(SlopeFan, RampHasItsAngleAndNoSpread) {
  for (const double rise : {-0.6, -0.1, 0.0, 0.1, 0.6}) {
    const auto slope = slope_of(ramp(rise));
    ASSERT_TRUE(slope.has_value());
    EXPECT_NEAR(slope->slope_rad, std::atan(rise), 1e-6);
    EXPECT_NEAR(slope->slope_sigma_rad, 0.0, 1e-4);
    EXPECT_FALSE(slope->cross_fall_rad.has_value());
  }
}

TEST(SlopeFan, IsTheMeanOfAnglesNotTheAngleOfTheMean) {
  MadeSeries series;
  series.add(11.0, 0.0, 0.0);
  series.add(13.0, 0.0, 2.0);  // 45 degrees
  series.add(15.0, 0.0, 2.0);  // level
  const auto slope = slope_of(series);
  ASSERT_TRUE(slope.has_value());
  EXPECT_NEAR(slope->slope_rad, kPi / 8.0, 1e-6);
  // Two values pi / 8 to either side of their mean: variance 2 (pi / 8)^2, of the mean half of that.
  EXPECT_NEAR(slope->slope_sigma_rad, kPi / 8.0, 1e-6);
}

TEST(SlopeFan, CellIsTheMeanOfItsPoints) {
  MadeSeries series;
  series.add(10.5, 0.5, -1.0);
  series.add(11.5, -0.5, 1.0);  // mean (11, 0, 0)
  series.add(13.0, 0.0, 0.5);
  const auto slope = slope_of(series);
  ASSERT_TRUE(slope.has_value());
  EXPECT_NEAR(slope->slope_rad, std::atan2(0.5, 2.0), 1e-6);
}

TEST(SlopeFan, DistanceBetweenRepresentativesIsHorizontal) {
  MadeSeries series;
  series.add(11.0, 1.0, 0.0);
  series.add(13.0, -1.0, 1.0);
  const auto slope = slope_of(series);
  ASSERT_TRUE(slope.has_value());
  EXPECT_NEAR(slope->slope_rad, std::atan2(1.0, std::sqrt(8.0)), 1e-6);
}

TEST(SlopeFan, PairWithAnEmptyCellIsLeftOut) {
  MadeSeries series;
  series.add(11.0, 0.0, 0.0);
  series.add(13.0, 0.0, 0.2);
  series.add(17.0, 0.0, 50.0);  // 15 is empty
  series.add(19.0, 0.0, 50.2);
  const auto slope = slope_of(series);
  ASSERT_TRUE(slope.has_value());
  EXPECT_NEAR(slope->slope_rad, std::atan(0.1), 1e-5);
}

TEST(SlopeFan, WithoutAPairTheSlopeIsUnknown) {
  EXPECT_FALSE(slope_of(MadeSeries()).has_value());
  MadeSeries one;
  one.add(11.0, 0.0, 0.0);
  EXPECT_FALSE(slope_of(one).has_value());
  one.add(15.0, 0.0, 0.0);
  one.add(19.0, 0.0, 0.0);
  EXPECT_FALSE(slope_of(one).has_value());
}

TEST(SlopeFan, OnePairKnowsNothingOfItsSpread) {
  MadeSeries series;
  series.add(11.0, 0.0, 0.0);
  series.add(13.0, 0.0, 0.2);
  const auto slope = slope_of(series);
  ASSERT_TRUE(slope.has_value());
  EXPECT_DOUBLE_EQ(slope->slope_sigma_rad, kPi / 2.0);
}

TEST(SlopeFan, EndsWhereItShould) {
  MadeSeries outside = ramp(0.1);
  add_at(outside, 9.99, 0.0, 100.0);
  add_at(outside, 40.0, 0.0, 100.0);
  add_at(outside, 20.0, 7.05, 100.0);
  add_at(outside, 20.0, -7.05, 100.0);
  add_at(outside, 20.0, 180.0, 100.0);
  EXPECT_NEAR(slope_of(outside)->slope_rad, std::atan(0.1), 1e-6);

  MadeSeries inside;
  inside.add(10.0, 0.0, 0.0);
  add_at(inside, 12.5, 6.95, 0.0);
  add_at(inside, 14.5, -6.95, 0.0);
  EXPECT_NEAR(slope_of(inside)->slope_rad, 0.0, 1e-6);
  MadeSeries far_end;
  far_end.add(37.0, 0.0, 0.0);
  far_end.add(39.99, 0.0, 0.0);
  EXPECT_TRUE(slope_of(far_end).has_value());
}

TEST(SlopeFan, InterpolatedPointsDoNotCount) {
  MadeSeries series = ramp(0.1);
  series.add(21.0, 0.0, 100.0, true);
  EXPECT_NEAR(slope_of(series)->slope_rad, std::atan(0.1), 1e-6);
}

TEST(SlopeFan, BadPointsDoNotCount) {
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  constexpr double kInf = std::numeric_limits<double>::infinity();
  MadeSeries series = ramp(0.1);
  for (const double bad : {kNan, kInf, -kInf}) {
    series.add(bad, 0.0, 0.0);
    series.add(20.0, bad, 0.0);
    series.add(20.0, 0.0, bad);
    series.add(bad, bad, bad);
  }
  EXPECT_NEAR(slope_of(series)->slope_rad, std::atan(0.1), 1e-6);
}

TEST(SlopeFan, IsMeasuredInTheBase) {
  // Level ground 2.3 m below a sensor that looks down by 11 degrees.
  const Pose T_base_sensor = Pose::from_yaw_pitch_roll(0.0, 11.0 * kPi / 180.0, 0.0, {0.0, 0.0, 2.3});
  MadeSeries series;
  for (const double x_m : {11.0, 13.0, 15.0, 17.0}) {
    const Eigen::Vector3d p = T_base_sensor.inverse() * Eigen::Vector3d(x_m, 0.0, 0.0);
    series.add(p.x(), p.y(), p.z());
  }
  EXPECT_NEAR(slope_of(series, T_base_sensor)->slope_rad, 0.0, 1e-6);
  EXPECT_NEAR(slope_of(series)->slope_rad, 11.0 * kPi / 180.0, 1e-6);
}

TEST(SlopeFan, HasTheCellsOfItsConfiguration) {
  EnvelopePisteConfig config;
  config.fan_min_m = 5.0;
  config.fan_max_m = 8.0;
  config.fan_cell_m = 2.0;  // [5, 7) and [7, 8)
  MadeSeries series;
  series.add(6.0, 0.0, 0.0);
  series.add(7.9, 0.0, 1.9);
  series.add(8.1, 0.0, 50.0);
  const auto slope = SlopeFan(config).measure(series.in_base(), series.interpolated);
  ASSERT_TRUE(slope.has_value());
  EXPECT_NEAR(slope->slope_rad, kPi / 4.0, 1e-6);
}

}  // namespace
}  // namespace berm
