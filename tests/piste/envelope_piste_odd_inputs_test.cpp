// Scans that no sensor should send. Nothing may crash, and every label must be one that the contract allows.

#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include "berm/piste/envelope_piste.hpp"
#include "made_series.hpp"
#include "piste/mid70_scan.hpp"
#include "support/random_points.hpp"

namespace berm {
namespace {

using test::MadeSeries;

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
constexpr float kInf = std::numeric_limits<float>::infinity();
constexpr float kMax = std::numeric_limits<float>::max();

/// Runs the method and holds its result to the contract.
void expect_sound(const MadeSeries& series, const std::vector<Label>& labels, const std::string& name) {
  EnvelopePiste piste({});
  const PisteResult result = piste.process(series.input(labels, test::groomer_mount()));
  ASSERT_EQ(result.labels.size(), labels.size()) << name;
  EXPECT_EQ(result.steps.size(), labels.size()) << name;
  for (std::size_t i = 0; i < labels.size(); ++i) {
    const bool was_return = labels[i] == Label::drivable || labels[i] == Label::terrain || labels[i] == Label::obstacle;
    if (!was_return) {
      ASSERT_EQ(result.labels[i], labels[i]) << name << ", point " << i;
    } else if (series.interpolated[i] != 0) {
      ASSERT_EQ(result.labels[i], Label::unlabeled) << name << ", point " << i;
    } else {
      ASSERT_TRUE(result.labels[i] == Label::drivable || result.labels[i] == Label::obstacle)
          << name << ", point " << i;
    }
  }
  for (const Envelope& envelope : result.envelopes) {
    EXPECT_LE(envelope.first, envelope.last) << name;
    EXPECT_LT(envelope.last, labels.size()) << name;
  }
  if (result.slope) {
    EXPECT_LE(std::abs(result.slope->slope_rad), std::numbers::pi / 2.0) << name;
    EXPECT_GE(result.slope->slope_sigma_rad, 0.0) << name;
    EXPECT_LE(result.slope->slope_sigma_rad, std::numbers::pi / 2.0) << name;
  }
  if (result.obstacle_ahead_m) {
    EXPECT_GT(*result.obstacle_ahead_m, 0.0) << name;
  }
}

std::vector<Label> all(Label label, std::size_t size) {
  return std::vector<Label>(size, label);
}

TEST(EnvelopePisteOddInputs, EmptyScan) {
  expect_sound(MadeSeries(), {}, "empty");
}

TEST(EnvelopePisteOddInputs, NothingButNoReturns) {
  MadeSeries series(1000, 0.0F);
  series.interpolated.assign(series.size(), 1);
  expect_sound(series, all(Label::no_return, series.size()), "no returns");
  EnvelopePiste piste({});
  const std::vector<Label> labels = all(Label::no_return, series.size());
  const PisteResult result = piste.process(series.input(labels));
  EXPECT_FALSE(result.slope.has_value());
  EXPECT_TRUE(result.envelopes.empty());
  EXPECT_FALSE(result.obstacle_ahead_m.has_value());
}

TEST(EnvelopePisteOddInputs, FewPoints) {
  for (std::size_t size = 1; size < 20; ++size) {
    expect_sound(MadeSeries(size), all(Label::drivable, size), "few points");
  }
}

TEST(EnvelopePisteOddInputs, SamePointAllOver) {
  for (const float ahead_m : {0.0F, 1e-30F, 1.0F, 1e30F, kMax, kNan, kInf}) {
    expect_sound(MadeSeries(1000, ahead_m), all(Label::obstacle, 1000), "same point");
  }
}

TEST(EnvelopePisteOddInputs, BadCoordinatesAmongGoodOnes) {
  const test::MadeScan scan = test::mid70_scan();
  MadeSeries series;
  for (std::size_t i = 0; i < scan.cloud.size(); ++i) {
    series.add(scan.cloud.view().x[i], scan.cloud.view().y[i], scan.cloud.view().z[i]);
  }
  constexpr float kBad[] = {kNan, kInf, -kInf, kMax, -kMax};
  for (std::size_t i = 0; i < series.size(); i += 7) {
    std::vector<float>& channel = i % 3 == 0 ? series.x : i % 3 == 1 ? series.y : series.z;
    channel[i] = kBad[i / 7 % 5];
  }
  expect_sound(series, all(Label::drivable, series.size()), "bad coordinates");
}

TEST(EnvelopePisteOddInputs, AnyPointsAndLabels) {
  EXPECT_TRUE(rc::check("the contract holds", [] {
    constexpr Label kLabels[] = {Label::unlabeled, Label::no_return, Label::falling_snow,
                                 Label::drivable,  Label::terrain,   Label::obstacle};
    const auto size = *rc::gen::inRange<std::size_t>(0, 500);
    const PointChannels points = test::random_points(size, *rc::gen::arbitrary<std::uint32_t>(), {});
    MadeSeries series;
    std::vector<Label> labels;
    for (std::size_t i = 0; i < size; ++i) {
      series.add(static_cast<double>(points.x[i]), static_cast<double>(points.y[i]), static_cast<double>(points.z[i]),
                 i * 7 % 11 == 3);
      labels.push_back(kLabels[i * 5 % 6]);
    }
    expect_sound(series, labels, "any points");
    RC_ASSERT(!testing::Test::HasFailure());
  }));
}

}  // namespace
}  // namespace berm
