// Petals of the Livox sensors that P is written for: the Mid-70's pattern, also where most of it meets nothing, and a
// real recording of its sister, the Mid-40.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <gtest/gtest.h>

#include "berm/core/angle.hpp"
#include "berm/io/pcd.hpp"
#include "berm/snow/repair.hpp"
#include "made_series.hpp"
#include "petals.hpp"
#include "piste/mid70_scan.hpp"
#include "support/data.hpp"

namespace berm {
namespace {

using test::MadeSeries;

std::vector<double> lengths_of(const SeriesView& series, double min_rise_deg = 3.0) {
  Petals petals(min_rise_deg * kRadPerDeg);
  const auto begins = petals.find(series);
  std::vector<double> lengths;
  for (std::size_t i = 2; i < begins.size(); ++i) {  // the first petal need not be whole
    lengths.push_back(static_cast<double>(begins[i] - begins[i - 1]));
  }
  return lengths;
}

/// The whole pattern on a sphere of 10 m.
MadeSeries sphere(std::size_t first) {
  MadeSeries series;
  for (const auto& direction : test::mid70_beams(first).directions) {
    const Eigen::Vector3d p = 10.0 * direction;
    series.add(p.x(), p.y(), p.z());
  }
  return series;
}

TEST(PetalsOfTheMid70, ComeAtAConstantRate) {
  for (const std::size_t first : {0U, 137U, 10000U, 123456U}) {
    const std::vector<double> lengths = lengths_of(sphere(first).view());
    EXPECT_GE(lengths.size(), 18U);
    EXPECT_LE(lengths.size(), 20U);
    for (const double length : lengths) {
      EXPECT_NEAR(length, test::kMid70SamplesPerPetal, 2.0);
    }
  }
}

TEST(PetalsOfTheMid70, SurviveTheSky) {
  // A fifth of the beams meets nothing: whole tips of petals, but not their middle.
  const test::MadeScan scan = test::mid70_scan();
  const PointsView points = scan.cloud.view();
  std::size_t none = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    none += is_no_return(points.x[i], points.y[i], points.z[i]) ? 1U : 0U;
  }
  EXPECT_GT(none, points.size() / 10);
  const std::vector<std::uint8_t> no_flakes(points.size(), 0);
  SeriesRepair repair;
  const std::vector<double> lengths = lengths_of(repair.process(points, no_flakes));
  EXPECT_GE(lengths.size(), 18U);
  for (const double length : lengths) {
    EXPECT_NEAR(length, test::kMid70SamplesPerPetal, 6.0);
  }
}

TEST(PetalsOfTheMid70, SurviveLostBeams) {
  // Every third beam is a flake or nothing, at random places of the pattern.
  const test::MadeScan scan = test::mid70_scan(5000);
  const PointsView points = scan.cloud.view();
  std::vector<std::uint8_t> flakes(points.size(), 0);
  for (std::size_t i = 0; i < flakes.size(); ++i) {
    flakes[i] = i * 2654435761U % 1000 < 333 ? 1 : 0;
  }
  SeriesRepair repair;
  const std::vector<double> lengths = lengths_of(repair.process(points, flakes));
  EXPECT_GE(lengths.size(), 18U);
  for (const double length : lengths) {
    EXPECT_NEAR(length, test::kMid70SamplesPerPetal, 15.0);
  }
}

TEST(PetalsOfARecordedMid40, ComeAtAConstantRate) {
  BERM_NEED_DATA(file, "livox_mid40/10.pcd");
  const PointCloud cloud(read_pcd(file).channels);
  MadeSeries series;
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    series.add(cloud.view().x[i], cloud.view().y[i], cloud.view().z[i]);
  }
  const std::vector<double> lengths = lengths_of(series.view());
  // 598 petals are 2.98 s; nothing hangs on how far phi must rise.
  EXPECT_EQ(lengths.size(), 597U);
  for (const double min_rise_deg : {1.0, 2.0, 5.0, 8.0}) {
    EXPECT_EQ(lengths_of(series.view(), min_rise_deg), lengths) << min_rise_deg;
  }
  // Beams without return are missing in this recording: a petal may be short, never long, nor a piece of one.
  EXPECT_LE(*std::max_element(lengths.begin(), lengths.end()), 510.0);
  EXPECT_GE(*std::min_element(lengths.begin(), lengths.end()), 200.0);
  double sum = 0.0;
  int whole = 0;
  for (const double length : lengths) {
    if (length > 485.0) {
      sum += length;
      ++whole;
    }
  }
  EXPECT_GT(whole, 100);
  EXPECT_NEAR(sum / whole, test::kMid70SamplesPerPetal, 3.0);
}

}  // namespace
}  // namespace berm
