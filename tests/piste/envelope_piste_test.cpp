#include "berm/piste/envelope_piste.hpp"

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "berm/core/angle.hpp"
#include "berm/core/error.hpp"
#include "envelopes.hpp"
#include "made_series.hpp"

namespace berm {
namespace {

using test::MadeSeries;

constexpr std::size_t kPetal = 60;

/// Level ground as three petals of 60 beams see it from a sensor in the base. Every petal goes 30 degrees to the left
/// and comes back at a distance of 15 m.
MadeSeries three_petals() {
  MadeSeries series;
  for (std::size_t i = 0; i <= 3 * kPetal; ++i) {
    const double from_tip = std::abs(static_cast<double>(i % kPetal) - 30.0);
    const double angle_rad = (30.0 - from_tip) * kRadPerDeg;
    series.add(15.0 * std::cos(angle_rad), 15.0 * std::sin(angle_rad), 0.0);
  }
  return series;
}

/// Lifts points first..last, so that they are steps.
void lift(MadeSeries& series, std::size_t first, std::size_t last) {
  for (std::size_t i = first; i <= last; ++i) {
    series.z[i] = 1.0F;
  }
}

char letter(Label label) {
  switch (label) {
    case Label::drivable:
      return 'p';
    case Label::obstacle:
      return 'o';
    case Label::terrain:
      return 't';
    case Label::falling_snow:
      return 's';
    case Label::no_return:
      return '0';
    case Label::unlabeled:
      break;
  }
  return '?';
}

std::string text_of(std::span<const Label> labels) {
  std::string text;
  for (const Label label : labels) {
    text += letter(label);
  }
  return text;
}

std::vector<Label> all(Label label, const MadeSeries& series) {
  return std::vector<Label>(series.size(), label);
}

TEST(Envelopes, RunFromTheFirstToTheLastStepOfAPetal) {
  const std::vector<std::size_t> begins = {0, 5, 10, 15};
  const std::vector<std::uint8_t> steps = {0, 1, 0, 0, 1,   // two
                                           0, 0, 0, 0, 0,   // none
                                           0, 0, 1, 0, 0,   // one
                                           1, 0, 0, 1, 0};  // at the begin
  std::vector<Envelope> envelopes;
  find_envelopes(begins, steps, envelopes);
  ASSERT_EQ(envelopes.size(), 3U);
  EXPECT_EQ(envelopes[0].first, 1U);
  EXPECT_EQ(envelopes[0].last, 4U);
  EXPECT_EQ(envelopes[1].first, 12U);
  EXPECT_EQ(envelopes[1].last, 12U);
  EXPECT_EQ(envelopes[2].first, 15U);
  EXPECT_EQ(envelopes[2].last, 18U);
}

TEST(EnvelopePiste, WithoutAStepAllIsPiste) {
  const MadeSeries series = three_petals();
  EnvelopePiste piste({});
  const std::vector<Label> labels = all(Label::obstacle, series);
  const PisteResult result = piste.process(series.input(labels));
  EXPECT_EQ(text_of(result.labels), std::string(series.size(), 'p'));
  EXPECT_TRUE(result.envelopes.empty());
  EXPECT_EQ(result.steps.size(), series.size());
  EXPECT_FALSE(result.obstacle_ahead_m.has_value());
  EXPECT_TRUE(result.left.empty());
  EXPECT_TRUE(result.right.empty());
}

TEST(EnvelopePiste, EnvelopeEndsWithItsPetal) {
  MadeSeries series = three_petals();
  lift(series, 70, 79);
  lift(series, 100, 109);
  EnvelopePiste piste({});
  const std::vector<Label> labels = all(Label::drivable, series);
  const PisteResult result = piste.process(series.input(labels));
  ASSERT_EQ(result.envelopes.size(), 1U);
  // Two points either side of an edge are steps; all between the outermost is an obstacle, the ground included.
  EXPECT_EQ(result.envelopes[0].first, 68U);
  EXPECT_EQ(result.envelopes[0].last, 111U);
  EXPECT_EQ(text_of(result.labels), std::string(68, 'p') + std::string(44, 'o') + std::string(69, 'p'));
}

TEST(EnvelopePiste, TerrainIsUnknownToIt) {
  MadeSeries series = three_petals();
  EnvelopePiste piste({});
  const std::vector<Label> labels = all(Label::terrain, series);
  EXPECT_EQ(text_of(piste.process(series.input(labels)).labels), std::string(series.size(), 'p'));
}

TEST(EnvelopePiste, WhatIsNoReturnKeepsItsLabel) {
  MadeSeries series = three_petals();
  lift(series, 70, 79);
  std::vector<Label> labels = all(Label::drivable, series);
  for (const std::size_t begin : {10U, 72U}) {  // outside and inside the envelope
    labels[begin] = Label::no_return;
    labels[begin + 1] = Label::falling_snow;
    labels[begin + 2] = Label::unlabeled;
    for (std::size_t i = begin; i < begin + 3; ++i) {
      series.interpolated[i] = 1;
    }
  }
  EnvelopePiste piste({});
  const std::string text = text_of(piste.process(series.input(labels)).labels);
  EXPECT_EQ(text.substr(9, 5), "p0s?p");
  EXPECT_EQ(text.substr(71, 5), "o0s?o");
}

TEST(EnvelopePiste, ReplacedReturnIsNeitherPisteNorObstacle) {
  MadeSeries series = three_petals();
  lift(series, 70, 79);
  series.interpolated[10] = 1;
  series.interpolated[75] = 1;
  EnvelopePiste piste({});
  const std::vector<Label> labels = all(Label::drivable, series);
  const std::string text = text_of(piste.process(series.input(labels)).labels);
  EXPECT_EQ(text.substr(9, 3), "p?p");
  EXPECT_EQ(text.substr(74, 3), "o?o");
}

TEST(EnvelopePiste, NearestObstacleAheadIsInTheCorridor) {
  MadeSeries series = three_petals();
  lift(series, 90, 92);  // at the tip: 30 degrees to the left
  EnvelopePiste piste({});
  const std::vector<Label> labels = all(Label::drivable, series);
  EXPECT_FALSE(piste.process(series.input(labels)).obstacle_ahead_m.has_value());
  lift(series, 121, 123);
  const auto ahead_m = piste.process(series.input(labels)).obstacle_ahead_m;
  ASSERT_TRUE(ahead_m.has_value());
  // Three points are too few to vote their neighbours into the envelope; the last is 3 degrees, 0.8 m, to the left.
  EXPECT_NEAR(*ahead_m, 15.0 * std::cos(3.0 * kRadPerDeg), 1e-3);
}

TEST(EnvelopePiste, WhatLiesBehindIsNotAhead) {
  MadeSeries series = three_petals();
  lift(series, 121, 123);
  EnvelopePiste piste({});
  const std::vector<Label> labels = all(Label::drivable, series);
  const Pose turned = Pose::from_yaw_pitch_roll(std::numbers::pi, 0.0, 0.0, {0.0, 0.0, 0.0});
  EXPECT_FALSE(piste.process(series.input(labels, turned)).obstacle_ahead_m.has_value());
}

TEST(EnvelopePiste, SlopeSetsTheThresholds) {
  // A ramp of 60 degrees in the fan doubles the threshold of height. It is farther away than the step, and a petal of
  // its own.
  MadeSeries series = three_petals();
  for (std::size_t i = 70; i <= 79; ++i) {
    series.z[i] = 0.08F;
  }
  EnvelopePiste piste({});
  std::vector<Label> labels = all(Label::drivable, series);
  EXPECT_EQ(piste.process(series.input(labels)).envelopes.size(), 1U);
  const double rise = std::tan(60.0 * kRadPerDeg);
  for (double x_m = 20.001; x_m < 40.0; x_m += 0.02) {
    series.add(x_m, 0.0, (x_m - 20.0) * rise);
  }
  labels = all(Label::drivable, series);
  const PisteResult steep = piste.process(series.input(labels));
  ASSERT_TRUE(steep.slope.has_value());
  EXPECT_NEAR(steep.slope->slope_rad, 60.0 * kRadPerDeg, 0.01);
  EXPECT_EQ(steep.steps[70], 0);
}

TEST(EnvelopePiste, UnknownSlopeCountsAsLevel) {
  MadeSeries series = three_petals();
  for (std::size_t i = 0; i < series.size(); ++i) {  // 3 m away: before the fan
    series.x[i] *= 0.2F;
    series.y[i] *= 0.2F;
  }
  for (std::size_t i = 70; i <= 79; ++i) {
    series.z[i] = 0.051F;
  }
  EnvelopePiste piste({});
  const std::vector<Label> labels = all(Label::drivable, series);
  const PisteResult result = piste.process(series.input(labels));
  EXPECT_FALSE(result.slope.has_value());
  EXPECT_EQ(result.envelopes.size(), 1U);
}

TEST(EnvelopePiste, RefusesArraysOfDifferentLength) {
  const MadeSeries series = three_petals();
  EnvelopePiste piste({});
  const std::vector<Label> labels = all(Label::drivable, series);
  PisteInput few_labels = series.input(labels);
  few_labels.labels = few_labels.labels.first(3);
  EXPECT_THROW((void)piste.process(few_labels), Error);
  PisteInput no_series = series.input(labels);
  no_series.series = {};
  EXPECT_THROW((void)piste.process(no_series), Error);
}

TEST(EnvelopePisteConfig, IsThatOfThePaper) {
  const EnvelopePisteConfig config;
  EXPECT_DOUBLE_EQ(config.fan_min_m, 10.0);
  EXPECT_DOUBLE_EQ(config.fan_max_m, 40.0);
  EXPECT_DOUBLE_EQ(config.fan_half_angle_deg, 7.0);
  EXPECT_DOUBLE_EQ((config.fan_max_m - config.fan_min_m) / config.fan_cell_m, 15.0);
  EXPECT_DOUBLE_EQ(config.z_step_m, 0.05);
  EXPECT_DOUBLE_EQ(config.x_step_m, 0.05);
  EXPECT_NO_THROW(config.check());
}

TEST(EnvelopePisteConfig, RefusesAFanThatEndsBeforeItBegins) {
  EnvelopePisteConfig config;
  config.fan_min_m = 50.0;
  EXPECT_THROW(EnvelopePiste{config}, ConfigError);
  config = {};
  config.z_neighbours = 17;
  EXPECT_THROW(EnvelopePiste{config}, ConfigError);
}

TEST(EnvelopePisteConfig, NeighboursStayWithinReach) {
  EnvelopePisteConfig config;
  config.z_neighbours = 16;
  config.x_neighbours = 5;
  config.check();
  EXPECT_GE(BaseSeries::kReach, 16U);
}

}  // namespace
}  // namespace berm
