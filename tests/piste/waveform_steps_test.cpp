#include "waveform_steps.hpp"

#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "made_series.hpp"

// P eqs. 3-8 by hand: which points of a short series are steps.

namespace berm {
namespace {

using test::MadeSeries;

constexpr double kLevel = 0.0;
constexpr double kSixtyDegrees = std::numbers::pi / 3.0;  // its cosine is 0.5
constexpr std::size_t kMiddle = 20;

std::vector<bool> steps_of(const MadeSeries& series, double slope_rad = kLevel) {
  WaveformSteps steps;
  const auto found = steps.find(series.in_base(), slope_rad, {});
  return {found.begin(), found.end()};
}

/// Points at height 0, of which those at `offsets` from the middle stand at `height_m`.
MadeSeries heights(const std::vector<int>& offsets, float height_m) {
  MadeSeries series(2 * kMiddle + 1);
  for (const int offset : offsets) {
    series.z[kMiddle + static_cast<std::size_t>(offset)] = height_m;
  }
  return series;
}

/// Points that lie `back_m` behind the middle one, but for those at `offsets`, which lie `other_m` behind it.
MadeSeries peak(float back_m, const std::vector<int>& offsets = {}, float other_m = 0.0F) {
  MadeSeries series(2 * kMiddle + 1, 20.0F - back_m);
  series.x[kMiddle] = 20.0F;
  for (const int offset : offsets) {
    series.x[kMiddle + static_cast<std::size_t>(offset)] = 20.0F - other_m;
  }
  return series;
}

bool middle_is_step(const MadeSeries& series, double slope_rad = kLevel) {
  return steps_of(series, slope_rad)[kMiddle];
}

TEST(ZStep, NeedsMoreThanFourVotesOfOneSide) {
  EXPECT_FALSE(middle_is_step(heights({-1, -2, -3, -4}, 0.1F)));
  EXPECT_TRUE(middle_is_step(heights({-1, -2, -3, -4, -5}, 0.1F)));
  EXPECT_TRUE(middle_is_step(heights({-2, -3, -4, -5, -6}, 0.1F)));
  EXPECT_TRUE(middle_is_step(heights({-1, -2, -3, -4, -5, -6}, -0.1F)));
  EXPECT_FALSE(middle_is_step(heights({1, 2, 4, 6}, 0.1F)));
  EXPECT_TRUE(middle_is_step(heights({1, 2, 4, 5, 6}, 0.1F)));
}

TEST(ZStep, VotesOfTheTwoSidesAreNotAdded) {
  EXPECT_FALSE(middle_is_step(heights({-4, -3, -2, -1, 1, 2, 3, 4}, 0.1F)));
}

TEST(ZStep, NeighbourSevenAwayHasNoVote) {
  EXPECT_FALSE(middle_is_step(heights({-1, -2, -3, -4, -7}, 0.1F)));
  EXPECT_FALSE(middle_is_step(heights({1, 2, 3, 4, 7}, 0.1F)));
}

TEST(ZStep, ThresholdItselfIsNoVote) {
  const std::vector<int> five = {-1, -2, -3, -4, -5};
  EXPECT_FALSE(middle_is_step(heights(five, 0.05F)));
  EXPECT_TRUE(middle_is_step(heights(five, std::nextafter(0.05F, 1.0F))));
}

TEST(ZStep, ThresholdGrowsWithTheSlope) {
  const std::vector<int> five = {-1, -2, -3, -4, -5};
  EXPECT_TRUE(middle_is_step(heights(five, 0.09F), kLevel));
  EXPECT_FALSE(middle_is_step(heights(five, 0.09F), kSixtyDegrees));  // 0.05 / 0.5
  EXPECT_FALSE(middle_is_step(heights(five, 0.09F), -kSixtyDegrees));
  EXPECT_TRUE(middle_is_step(heights(five, 0.11F), kSixtyDegrees));
}

TEST(ZStep, EdgeOfAnObjectIsMarkedOnBothSides) {
  MadeSeries series(40);
  for (std::size_t i = 20; i < 40; ++i) {
    series.z[i] = 1.0F;
  }
  const std::vector<bool> steps = steps_of(series);
  for (std::size_t i = 0; i < 40; ++i) {
    // Point 18 differs from 20..24, which is five of the six after it; 17 from four.
    EXPECT_EQ(steps[i], i >= 18 && i <= 21) << i;
  }
}

TEST(ZStep, BeyondTheEndsNobodyVotes) {
  for (std::size_t at = 0; at < 8; ++at) {
    MadeSeries before(2 * kMiddle + 1);
    MadeSeries after(2 * kMiddle + 1);
    for (std::size_t i = 0; i < at; ++i) {
      before.z[i] = 1.0F;
      after.z[2 * kMiddle - i] = 1.0F;
    }
    // `at` points before it differ, and none after it.
    EXPECT_EQ(steps_of(before)[at], at >= 5) << at;
    EXPECT_EQ(steps_of(after)[2 * kMiddle - at], at >= 5) << at;
  }
}

TEST(ZStep, FirstAndLastPointCanBeOne) {
  MadeSeries series(2 * kMiddle + 1);
  series.z.front() = 1.0F;
  series.z.back() = 1.0F;
  const std::vector<bool> steps = steps_of(series);
  EXPECT_TRUE(steps.front());
  EXPECT_TRUE(steps.back());
  EXPECT_FALSE(steps[1]);
}

TEST(XStep, NeedsMoreThanSixVotes) {
  EXPECT_TRUE(middle_is_step(peak(0.1F)));
  for (const int offset : {-8, -4, -2, -1, 1, 2, 4, 8}) {
    EXPECT_TRUE(middle_is_step(peak(0.1F, {offset}))) << offset;
  }
  EXPECT_FALSE(middle_is_step(peak(0.1F, {-8, 8})));
  EXPECT_FALSE(middle_is_step(peak(0.1F, {1, 2})));
  EXPECT_TRUE(middle_is_step(peak(0.1F, {-7, -6, -5, -3, 3, 5, 6, 7, 9})));
}

TEST(XStep, MustTurn) {
  // Seven votes, but the neighbour lies farther ahead: P's text would call it a step, its equation does not.
  EXPECT_FALSE(middle_is_step(peak(0.1F, {1}, -0.01F)));
  EXPECT_FALSE(middle_is_step(peak(0.1F, {-1}, -0.01F)));
  EXPECT_TRUE(middle_is_step(peak(0.1F, {-8}, -1.0F)));
}

TEST(XStep, TurningAloneIsNone) {
  MadeSeries petal(2 * kMiddle + 1);
  for (std::size_t i = 0; i < petal.size(); ++i) {
    const double from_tip = static_cast<double>(i) - static_cast<double>(kMiddle);
    petal.x[i] = static_cast<float>(20.0 - 1e-4 * from_tip * from_tip);
  }
  EXPECT_FALSE(middle_is_step(petal));
}

TEST(XStep, ThresholdShrinksWithTheSlope) {
  EXPECT_FALSE(middle_is_step(peak(0.04F), kLevel));
  EXPECT_TRUE(middle_is_step(peak(0.04F), kSixtyDegrees));  // 0.05 * 0.5
  EXPECT_FALSE(middle_is_step(peak(0.02F), kSixtyDegrees));
}

TEST(XStep, NearerThanItsNeighboursIsNone) {
  EXPECT_FALSE(middle_is_step(peak(-1.0F)));
}

TEST(XStep, BeyondTheEndsNobodyVotes) {
  // How many of -8, -4, -2, -1 there are before points 0..9; the four after them always vote.
  constexpr std::array<int, 10> kBefore = {0, 1, 2, 2, 3, 3, 3, 3, 4, 4};
  for (std::size_t at = 0; at < kBefore.size(); ++at) {
    MadeSeries series(2 * kMiddle + 1, 19.0F);
    series.x[at] = 20.0F;
    series.x[2 * kMiddle - at] = 20.0F;
    const std::vector<bool> steps = steps_of(series);
    EXPECT_EQ(steps[at], kBefore[at] + 4 > 6) << at;
    EXPECT_EQ(steps[2 * kMiddle - at], kBefore[at] + 4 > 6) << at;
  }
}

TEST(WaveformSteps, ShortSeriesHasNone) {
  WaveformSteps steps;
  for (std::size_t size = 0; size <= 5; ++size) {
    MadeSeries series(size);
    for (std::size_t i = 0; i < size; ++i) {
      series.z[i] = static_cast<float>(i);
      series.x[i] = static_cast<float>(i);
    }
    const auto found = steps.find(series.in_base(), kLevel, {});
    EXPECT_EQ(found.size(), size);
    for (const std::uint8_t step : found) {
      EXPECT_EQ(step, 0);
    }
  }
}

TEST(WaveformSteps, NanNeitherVotesNorIsAStep) {
  MadeSeries series(2 * kMiddle + 1);
  series.z[kMiddle] = std::numeric_limits<float>::quiet_NaN();
  series.x[kMiddle] = std::numeric_limits<float>::quiet_NaN();
  for (const bool step : steps_of(series)) {
    EXPECT_FALSE(step);
  }
}

TEST(WaveformSteps, AreThoseOfTheBase) {
  // A series of equal heights in a sensor that is rolled by 90 degrees: its z is the base's -y.
  MadeSeries series = heights({-1, -2, -3, -4, -5}, 1.0F);
  const Pose rolled = Pose::from_yaw_pitch_roll(0.0, 0.0, std::numbers::pi / 2.0, {0.0, 0.0, 0.0});
  WaveformSteps steps;
  EXPECT_EQ(steps.find(series.in_base(), kLevel, {})[kMiddle], 1);
  EXPECT_EQ(steps.find(series.in_base(rolled), kLevel, {})[kMiddle], 0);
}

}  // namespace
}  // namespace berm
