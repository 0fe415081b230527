// Laws that hold for every scan.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <numbers>
#include <random>
#include <vector>

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include "berm/piste/envelope_piste.hpp"
#include "made_series.hpp"
#include "petals.hpp"
#include "piste/mid70_scan.hpp"
#include "waveform_steps.hpp"

namespace berm {
namespace {

using test::MadeSeries;

/// The made piste as the Mid-70 sees it, beams without return left out.
const MadeSeries& whole_series() {
  static const MadeSeries whole = [] {
    const test::MadeScan scan = test::mid70_scan(0, 15000);
    const PointsView points = scan.cloud.view();
    MadeSeries series;
    for (std::size_t i = 0; i < points.size(); ++i) {
      if (!is_no_return(points.x[i], points.y[i], points.z[i])) {
        series.add(static_cast<double>(points.x[i]), static_cast<double>(points.y[i]),
                   static_cast<double>(points.z[i]));
      }
    }
    return series;
  }();
  return whole;
}

/// Any part of it.
MadeSeries any_series() {
  const MadeSeries& whole = whole_series();
  const auto first = *rc::gen::inRange<std::size_t>(0, whole.size() - 2500);
  const auto count = *rc::gen::inRange<std::size_t>(0, 2500);
  MadeSeries part;
  for (std::size_t i = first; i < first + count; ++i) {
    part.add(static_cast<double>(whole.x[i]), static_cast<double>(whole.y[i]), static_cast<double>(whole.z[i]));
  }
  return part;
}

/// P eqs. 3-8 as they are written, point by point.
std::vector<bool> steps_by_definition(const MadeSeries& series, double slope_rad) {
  const auto n = static_cast<int>(series.size());
  const auto at = [](const std::vector<float>& values, int i) { return values[static_cast<std::size_t>(i)]; };
  const auto z_threshold_m = static_cast<float>(0.05 / std::cos(slope_rad));
  const auto x_threshold_m = static_cast<float>(0.05 * std::cos(slope_rad));
  std::vector<bool> steps;
  for (int i = 0; i < n; ++i) {
    int down = 0;
    int up = 0;
    for (int k = 1; k <= 6; ++k) {
      down += i - k >= 0 && std::abs(at(series.z, i) - at(series.z, i - k)) > z_threshold_m ? 1 : 0;
      up += i + k < n && std::abs(at(series.z, i) - at(series.z, i + k)) > z_threshold_m ? 1 : 0;
    }
    int ahead = 0;
    for (const int offset : {-8, -4, -2, -1, 1, 2, 4, 8}) {
      const int other = i + offset;
      ahead += other >= 0 && other < n && at(series.x, i) - at(series.x, other) > x_threshold_m ? 1 : 0;
    }
    const bool turns =
        i > 0 && i + 1 < n && at(series.x, i) >= at(series.x, i - 1) && at(series.x, i) >= at(series.x, i + 1);
    steps.push_back(down > 4 || up > 4 || (ahead > 6 && turns));
  }
  return steps;
}

TEST(WaveformLaws, StepsAreThoseOfTheDefinition) {
  EXPECT_TRUE(rc::check("steps are those of P eqs. 3-8", [] {
    const MadeSeries series = any_series();
    const double slope_rad = *rc::gen::inRange(-80, 81) * std::numbers::pi / 180.0;
    WaveformSteps steps;
    const auto found = steps.find(series.in_base(), slope_rad, {});
    RC_ASSERT(std::vector<bool>(found.begin(), found.end()) == steps_by_definition(series, slope_rad));
  }));
}

TEST(WaveformLaws, StepsDoNotDependOnTheDirectionOfTime) {
  EXPECT_TRUE(rc::check("a scan read backwards has its steps backwards", [] {
    MadeSeries series = any_series();
    WaveformSteps steps;
    const auto found = steps.find(series.in_base(), 0.1, {});
    const std::vector<std::uint8_t> forward(found.begin(), found.end());
    std::reverse(series.x.begin(), series.x.end());
    std::reverse(series.z.begin(), series.z.end());
    WaveformSteps reversed;
    const auto backward = reversed.find(series.in_base(), 0.1, {});
    RC_ASSERT(std::equal(forward.rbegin(), forward.rend(), backward.begin(), backward.end()));
  }));
}

TEST(PetalLaws, BeginsRiseFromTheFirstPoint) {
  EXPECT_TRUE(rc::check("0 = first begin < second begin < ... < size", [] {
    const MadeSeries series = any_series();
    Petals petals(*rc::gen::inRange(1, 300) * 0.1 * std::numbers::pi / 180.0);
    const auto begins = petals.find(series.view());
    RC_ASSERT(begins.empty() == (series.size() == 0));
    // Worked out before RC_ASSERT sees them: it evaluates both sides of an ||.
    const bool within = begins.empty() || (begins.front() == 0 && begins.back() < series.size());
    RC_ASSERT(within);
    const bool rise = std::adjacent_find(begins.begin(), begins.end(), std::greater_equal<>()) == begins.end();
    RC_ASSERT(rise);
  }));
}

TEST(PetalLaws, DoNotDependOnRanges) {
  EXPECT_TRUE(rc::check("beams alone make petals", [] {
    const MadeSeries series = any_series();
    MadeSeries scaled = series;
    std::mt19937 random(*rc::gen::arbitrary<std::uint32_t>());
    for (std::size_t i = 0; i < scaled.size(); ++i) {
      const auto scale = std::ldexp(1.0F, static_cast<int>(random() % 5));  // exact
      scaled.x[i] *= scale;
      scaled.y[i] *= scale;
      scaled.z[i] *= scale;
    }
    Petals petals(0.05);
    const auto found = petals.find(series.view());
    const std::vector<std::size_t> begins(found.begin(), found.end());
    const auto again = petals.find(scaled.view());
    RC_ASSERT(std::equal(begins.begin(), begins.end(), again.begin(), again.end()));
  }));
}

TEST(EnvelopePisteLaws, ObstaclesAreWhatEnvelopesCover) {
  EXPECT_TRUE(rc::check("a return is an obstacle if and only if it lies in an envelope, and every step does", [] {
    const MadeSeries series = any_series();
    EnvelopePiste piste({});
    const std::vector<Label> labels(series.size(), Label::drivable);
    const PisteResult result = piste.process(series.input(labels, test::groomer_mount()));
    std::vector<bool> covered(series.size(), false);
    for (const Envelope& envelope : result.envelopes) {
      RC_ASSERT(result.steps[envelope.first] == 1);
      RC_ASSERT(result.steps[envelope.last] == 1);
      for (std::size_t i = envelope.first; i <= envelope.last; ++i) {
        RC_ASSERT(!covered[i]);
        covered[i] = true;
      }
    }
    for (std::size_t i = 0; i < series.size(); ++i) {
      RC_ASSERT(covered[i] == (result.labels[i] == Label::obstacle));
      RC_ASSERT(covered[i] || result.steps[i] == 0);
    }
  }));
}

TEST(EnvelopePisteLaws, NothingIsCarriedOver) {
  EXPECT_TRUE(rc::check("a scan gives the same after another scan", [] {
    const MadeSeries one = any_series();
    const MadeSeries other = any_series();
    const std::vector<Label> labels_one(one.size(), Label::drivable);
    const std::vector<Label> labels_other(other.size(), Label::drivable);
    EnvelopePiste fresh({});
    EnvelopePiste used({});
    (void)used.process(other.input(labels_other, test::groomer_mount()));
    const PisteResult a = fresh.process(one.input(labels_one, test::groomer_mount()));
    const PisteResult b = used.process(one.input(labels_one, test::groomer_mount()));
    RC_ASSERT(std::equal(a.labels.begin(), a.labels.end(), b.labels.begin(), b.labels.end()));
    RC_ASSERT(std::equal(a.steps.begin(), a.steps.end(), b.steps.begin(), b.steps.end()));
    RC_ASSERT(a.envelopes.size() == b.envelopes.size());
    RC_ASSERT(a.obstacle_ahead_m == b.obstacle_ahead_m);
    RC_ASSERT(a.slope.has_value() == b.slope.has_value());
    const bool same_slope = !a.slope || a.slope->slope_rad == b.slope->slope_rad;
    RC_ASSERT(same_slope);
  }));
}

}  // namespace
}  // namespace berm
