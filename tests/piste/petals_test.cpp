#include "petals.hpp"

#include <cmath>
#include <limits>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "berm/core/angle.hpp"
#include "made_series.hpp"

namespace berm {
namespace {

using test::MadeSeries;
using testing::ElementsAre;

/// Points at a range of 10 m in the plane of x and y, at these angles to the boresight.
MadeSeries at_angles(const std::vector<double>& angles_deg) {
  MadeSeries series;
  for (const double angle_deg : angles_deg) {
    series.add(10.0 * std::cos(angle_deg * kRadPerDeg), 10.0 * std::sin(angle_deg * kRadPerDeg), 0.0);
  }
  return series;
}

std::vector<std::size_t> petals_of(const SeriesView& series, double min_rise_deg = 3.0) {
  Petals petals(min_rise_deg * kRadPerDeg);
  const auto begins = petals.find(series);
  return {begins.begin(), begins.end()};
}

/// Up from 0 to `top_deg` in steps of 1 and down again, `count` times, and the last 0.
std::vector<double> triangles(int count, int top_deg) {
  std::vector<double> angles;
  for (int petal = 0; petal < count; ++petal) {
    for (int i = 0; i < 2 * top_deg; ++i) {
      angles.push_back(i <= top_deg ? i : 2 * top_deg - i);
    }
  }
  angles.push_back(0.0);
  return angles;
}

TEST(Petals, RunFromOneMinimumToTheNext) {
  EXPECT_THAT(petals_of(at_angles(triangles(3, 30)).view()), ElementsAre(0, 60, 120));
}

TEST(Petals, FirstAndLastNeedNotBeWhole) {
  std::vector<double> angles = triangles(3, 30);
  angles.erase(angles.begin(), angles.begin() + 40);  // 20 degrees, on the way down
  EXPECT_THAT(petals_of(at_angles(angles).view()), ElementsAre(0, 20, 80));
  angles = triangles(3, 30);
  angles.erase(angles.begin(), angles.begin() + 10);  // on the way up
  EXPECT_THAT(petals_of(at_angles(angles).view()), ElementsAre(0, 50, 110));
}

TEST(Petals, FlatMinimumIsOne) {
  std::vector<double> angles = triangles(2, 30);
  angles.insert(angles.begin() + 60, 7, 0.0);
  EXPECT_THAT(petals_of(at_angles(angles).view()), ElementsAre(0, 60));
}

TEST(Petals, FlatTopIsNone) {
  std::vector<double> angles = triangles(2, 30);
  angles.insert(angles.begin() + 30, 50, 30.0);
  EXPECT_THAT(petals_of(at_angles(angles).view()), ElementsAre(0, 110));
}

TEST(Petals, JitterMakesNone) {
  std::vector<double> angles = triangles(3, 30);
  for (std::size_t i = 0; i < angles.size(); ++i) {
    angles[i] += 1.2 * (static_cast<double>(i * 7 % 5) - 2.0) / 2.0;  // up to 1.2 degrees to either side
  }
  const std::vector<std::size_t> begins = petals_of(at_angles(angles).view());
  ASSERT_EQ(begins.size(), 3U);
  EXPECT_NEAR(static_cast<double>(begins[1]), 60.0, 2.0);
  EXPECT_NEAR(static_cast<double>(begins[2]), 120.0, 2.0);
}

TEST(Petals, MinimumMustBeDeepEnough) {
  const auto dip_of = [](double depth_deg) {
    return at_angles({0.0, 5.0, 10.0, 15.0, 20.0, 20.0 - depth_deg, 20.0, 15.0, 10.0, 5.0, 0.0});
  };
  EXPECT_EQ(petals_of(dip_of(2.9).view()).size(), 1U);
  EXPECT_THAT(petals_of(dip_of(3.1).view()), ElementsAre(0, 5));
  EXPECT_EQ(petals_of(dip_of(3.1).view(), 3.2).size(), 1U);
}

TEST(Petals, DepthIsAnAngleWhereverTheBeamPoints) {
  for (const double at_deg : {10.0, 60.0, 120.0, 170.0}) {
    EXPECT_EQ(petals_of(at_angles({at_deg, at_deg - 2.99, at_deg}).view()).size(), 1U) << at_deg;
    EXPECT_EQ(petals_of(at_angles({at_deg, at_deg - 3.01, at_deg}).view()).size(), 2U) << at_deg;
  }
}

TEST(Petals, RangeDoesNotMatter) {
  MadeSeries series = at_angles(triangles(3, 30));
  for (std::size_t i = 0; i < series.size(); ++i) {
    const float scale = 0.05F + 13.0F * static_cast<float>(i * 31 % 17);
    series.x[i] *= scale;
    series.y[i] *= scale;
  }
  EXPECT_THAT(petals_of(series.view()), ElementsAre(0, 60, 120));
}

TEST(Petals, FullTurnIsOne) {
  std::vector<double> angles;
  for (int angle_deg = 0; angle_deg <= 3 * 360; ++angle_deg) {
    angles.push_back(angle_deg);
  }
  EXPECT_THAT(petals_of(at_angles(angles).view()), ElementsAre(0, 360, 720));
}

TEST(Petals, PointRightBehindTheSensorSpoilsNothing) {
  MadeSeries series = at_angles(triangles(3, 30));
  series.x[15] = -10.0F;
  series.y[15] = 0.0F;
  series.x[75] = -10.0F;
  series.y[75] = 1e-5F;
  EXPECT_EQ(petals_of(series.view()).back(), 120U);
}

TEST(Petals, PointsWithoutADirectionArePassedOver) {
  constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
  constexpr float kInf = std::numeric_limits<float>::infinity();
  for (const float bad : {0.0F, kNan, kInf, -kInf, std::numeric_limits<float>::max()}) {
    MadeSeries series = at_angles(triangles(3, 30));
    for (const std::size_t i : {0U, 10U, 30U, 31U, 61U, 100U, 180U}) {
      series.x[i] = bad;
      series.y[i] = bad;
      series.z[i] = bad;
    }
    EXPECT_THAT(petals_of(series.view()), ElementsAre(0, 60, 120)) << bad;
  }
}

TEST(Petals, SteadyBeamIsOnePetal) {
  EXPECT_THAT(petals_of(MadeSeries(100).view()), ElementsAre(0));
  EXPECT_THAT(petals_of(at_angles(std::vector<double>(100, 25.0)).view()), ElementsAre(0));
  EXPECT_THAT(petals_of(MadeSeries(100, 0.0F).view()), ElementsAre(0));
  EXPECT_THAT(petals_of(MadeSeries(1).view()), ElementsAre(0));
}

TEST(Petals, NothingHasNone) {
  EXPECT_TRUE(petals_of({}).empty());
}

}  // namespace
}  // namespace berm
