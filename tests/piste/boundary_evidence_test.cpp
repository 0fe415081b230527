#include "boundary_evidence.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "list_points.hpp"
#include "piste/made_windows.hpp"

namespace berm {
namespace {

using bearing_grid::bearing_of;
using bearing_grid::bin_of;
using bearing_grid::kBins;
using bearing_grid::kSectors;
using bearing_grid::range_of;

constexpr double kHeight_m = 2.3;
constexpr double kHalfAngle_rad = 0.6;
constexpr float kSome = 0.1F;  ///< a cell beyond that holds evidence

double flat(double /*x_m*/, double /*y_m*/) {
  return 0.0;
}

/// A bank of half a metre, 1.5 m wide, from 10 m of range on.
double bank_at_10_m(double x_m, double y_m) {
  return std::clamp((std::hypot(x_m, y_m) - 10.0) / 1.5, 0.0, 1.0) * 0.5;
}

/// Evidence of windows and obstacles, weighed against a surface through what is nearer than `fit_to_m`.
struct Weighed {
  BoundaryEvidence evidence;
  bearing_grid::SectorTable sectors;
  LevelPoints level;
  std::vector<Label> labels;

  explicit Weighed(const BoundaryPisteConfig& config) : evidence(config) {
    level.sensor_height_m = static_cast<float>(kHeight_m);
  }

  void add_point(double range_m, double bearing_rad, Label label) {
    const auto x = static_cast<float>(range_m * std::cos(bearing_rad));
    const auto y = static_cast<float>(range_m * std::sin(bearing_rad));
    level.x.push_back(x);
    level.y.push_back(y);
    level.z.push_back(1.0F);
    level.range2.push_back(x * x + y * y);
    level.turn.push_back(bearing_grid::turn_of(x, y));
    labels.push_back(label);
  }
  void weigh(const TraceWindows& windows, float fit_to_m = 9.0F, bool is_radial = false) {
    PisteSurface surface;
    evidence.set_windows(windows, level, is_radial, sectors);
    std::vector<std::uint32_t> obstacles;
    list_points(labels, Label::obstacle, obstacles);
    evidence.set_obstacles(obstacles, level, sectors);
    evidence.fit_near(windows, fit_to_m, surface);
    evidence.weigh(windows, surface);
  }
  [[nodiscard]] float cell(std::size_t sector, int bin) const {
    return evidence.cells()[sector * kBins + static_cast<std::size_t>(bin)];
  }
  /// Shares of the cells of the arc between two ranges that speak for the end of the piste, and against it.
  [[nodiscard]] std::pair<double, double> shares(float from_m, float to_m) const {
    double for_it = 0.0;
    double against_it = 0.0;
    double all = 0.0;
    for (int i = 0; i < evidence.arc().count; ++i) {
      for (int bin = bin_of(from_m * from_m); bin < bin_of(to_m * to_m); ++bin) {
        const float evidence_there = cell(evidence.arc().sector(i), bin);
        for_it += evidence_there > kSome ? 1.0 : 0.0;
        against_it += evidence_there < -kSome ? 1.0 : 0.0;
        all += 1.0;
      }
    }
    return {for_it / all, against_it / all};
  }
};

/// Windows all over the field of view, several a cell.
TraceWindows field(const test::HeightOf& z_of, double to_m = 40.0) {
  return test::scattered_windows(20000, 3.0, to_m, kHalfAngle_rad, z_of);
}

BoundaryPisteConfig only(bool BoundaryPisteConfig::*use) {
  BoundaryPisteConfig config;
  for (const auto member : {&BoundaryPisteConfig::use_height, &BoundaryPisteConfig::use_slope,
                            &BoundaryPisteConfig::use_roughness, &BoundaryPisteConfig::use_obstacles}) {
    config.*member = member == use;
  }
  return config;
}

TEST(BoundaryEvidence, SpeaksAgainstTheEndOfFlatSnow) {
  Weighed weighed({});
  weighed.weigh(field(flat));
  const auto [for_it, against_it] = weighed.shares(3.5F, 38.0F);
  EXPECT_EQ(for_it, 0.0);
  EXPECT_GT(against_it, 0.97);
}

TEST(BoundaryEvidence, IsSilentWhereNothingIsSeen) {
  Weighed weighed({});
  weighed.weigh(field(flat, 20.0));
  const auto [for_it, against_it] = weighed.shares(22.0F, 100.0F);
  EXPECT_EQ(for_it, 0.0);
  EXPECT_EQ(against_it, 0.0);
}

TEST(BoundaryEvidence, SpeaksForABank) {
  for (const auto use : {&BoundaryPisteConfig::use_height, &BoundaryPisteConfig::use_slope}) {
    Weighed weighed(only(use));
    weighed.weigh(field(bank_at_10_m, 11.5));
    EXPECT_EQ(weighed.shares(3.5F, 9.5F).first, 0.0);
    EXPECT_GT(weighed.shares(10.8F, 11.3F).first, 0.5) << (use == &BoundaryPisteConfig::use_height);
  }
  Weighed all({});
  all.weigh(field(bank_at_10_m, 11.5));
  EXPECT_EQ(all.shares(3.5F, 9.5F).first, 0.0);
  EXPECT_GT(all.shares(10.5F, 11.3F).first, 0.9);
}

TEST(BoundaryEvidence, GrowsWithTheHeightOfTheBank) {
  const auto at_the_bank = [](double height_m) {
    Weighed weighed(only(&BoundaryPisteConfig::use_height));
    weighed.weigh(field([&](double x, double y) { return 2.0 * height_m * bank_at_10_m(x, y); }, 20.0));
    return weighed.shares(12.0F, 14.0F);
  };
  EXPECT_EQ(at_the_bank(0.0).first, 0.0);
  EXPECT_EQ(at_the_bank(0.05).first, 0.0);
  EXPECT_GT(at_the_bank(0.5).first, 0.9);
  EXPECT_GT(at_the_bank(-0.5).first, 0.9) << "a drop bounds the piste as well";
}

TEST(BoundaryEvidence, SpeaksForRoughSnow) {
  Weighed weighed(only(&BoundaryPisteConfig::use_roughness));
  TraceWindows windows = field(flat);
  for (std::size_t i = 0; i < windows.size(); ++i) {
    windows.variance_m2[i] = windows.range_m[i] < 20.0F ? 1e-5F : 4e-3F;  // 3 and 60 mm
  }
  weighed.weigh(windows);
  EXPECT_EQ(weighed.shares(3.5F, 19.0F).first, 0.0);
  EXPECT_GT(weighed.shares(21.0F, 38.0F).first, 0.97);
}

TEST(BoundaryEvidence, TakesRoughSnowUnderTheMachineForThatOfThePiste) {
  for (const bool adapt : {false, true}) {
    BoundaryPisteConfig config = only(&BoundaryPisteConfig::use_roughness);
    config.adapt = adapt;
    Weighed weighed(config);
    TraceWindows windows = field(flat);
    std::fill(windows.variance_m2.begin(), windows.variance_m2.end(), 1e-3F);
    weighed.weigh(windows);
    if (adapt) {
      EXPECT_EQ(weighed.shares(3.5F, 12.0F).first, 0.0);
    } else {
      EXPECT_GT(weighed.shares(3.5F, 12.0F).first, 0.9);
    }
  }
}

TEST(BoundaryEvidence, TakesWavesUnderTheMachineForThoseOfThePiste) {
  const auto waves = [](double x, double y) { return 0.15 * std::sin(2.0 * x) * std::cos(1.7 * y); };
  for (const auto use : {&BoundaryPisteConfig::use_height, &BoundaryPisteConfig::use_slope}) {
    double for_it[2] = {};
    for (const bool adapt : {false, true}) {
      BoundaryPisteConfig config = only(use);
      config.adapt = adapt;
      Weighed weighed(config);
      weighed.weigh(field(waves), 14.0F);
      for_it[adapt ? 1 : 0] = weighed.shares(6.0F, 14.0F).first;
    }
    EXPECT_GT(for_it[0], 0.2);
    EXPECT_LT(for_it[1], 0.3 * for_it[0]);
  }
}

TEST(BoundaryEvidence, SpeaksForObstaclesWhereTheyStand) {
  for (const bool use_obstacles : {true, false}) {
    BoundaryPisteConfig config;
    config.use_obstacles = use_obstacles;
    Weighed weighed(config);
    for (int i = 0; i < 20; ++i) {
      weighed.add_point(15.0, 0.2, Label::obstacle);
      for (const Label label : {Label::drivable, Label::falling_snow, Label::no_return, Label::unlabeled}) {
        weighed.add_point(15.0, -0.2, label);
      }
    }
    // Seen before the obstacle, and not behind it: windows there would speak against it.
    weighed.weigh(field(flat, 12.0));
    const int bin = bin_of(15.0F * 15.0F);
    const auto cell_at = [&](double bearing_rad, int at) {
      return weighed.cell(
          weighed.sectors.of(static_cast<float>(std::cos(bearing_rad)), static_cast<float>(std::sin(bearing_rad))), at);
    };
    if (use_obstacles) {
      EXPECT_GT(cell_at(0.2, bin), 1.0F);
    } else {
      EXPECT_LT(cell_at(0.2, bin), kSome);
    }
    EXPECT_LT(cell_at(0.2, bin + 2), kSome);
    EXPECT_LT(cell_at(-0.2, bin), kSome);
  }
}

TEST(BoundaryEvidence, LooksAtNothingThatIsSwitchedOff) {
  TraceWindows windows = field([](double x, double y) { return std::hypot(x, y) < 9.0 ? 0.0 : 3.0 * std::sin(x); });
  std::fill(windows.variance_m2.begin(), windows.variance_m2.end(), 1.0F);
  Weighed weighed(only(nullptr));
  weighed.add_point(15.0, 0.1, Label::obstacle);
  weighed.weigh(windows);
  const auto [for_it, against_it] = weighed.shares(2.0F, 100.0F);
  EXPECT_EQ(for_it, 0.0);
  EXPECT_EQ(against_it, 0.0);
}

TEST(BoundaryEvidence, NeedsMoreThanOneObstaclePointToBeSure) {
  Weighed one({});
  one.add_point(15.0, 0.01, Label::obstacle);
  one.weigh(field(flat, 12.0));
  Weighed many({});
  for (int i = 0; i < 50; ++i) {
    many.add_point(15.0, 0.01, Label::obstacle);
  }
  many.weigh(field(flat, 12.0));
  const std::size_t sector = one.sectors.of(1.0F, 0.01F);
  EXPECT_LT(one.cell(sector, bin_of(225.0F)), 0.5F * many.cell(sector, bin_of(225.0F)));
}

TEST(BoundaryEvidence, IsOfTheLastScanAlone) {
  Weighed used({});
  for (int i = 0; i < 20; ++i) {
    used.add_point(15.0, 0.2, Label::obstacle);
    used.add_point(15.0, 3.0, Label::obstacle);
  }
  used.weigh(test::scattered_windows(3000, 3.0, 50.0, 3.14, bank_at_10_m, 5));
  Weighed fresh({});
  used.labels.clear();
  const TraceWindows windows = field(bank_at_10_m, 20.0);
  used.weigh(windows);
  fresh.weigh(windows);
  ASSERT_EQ(used.evidence.arc().first, fresh.evidence.arc().first);
  ASSERT_EQ(used.evidence.arc().count, fresh.evidence.arc().count);
  for (int i = 0; i < fresh.evidence.arc().count; ++i) {
    for (int bin = 0; bin < kBins; ++bin) {
      const std::size_t sector = fresh.evidence.arc().sector(i);
      ASSERT_EQ(used.cell(sector, bin), fresh.cell(sector, bin));
    }
  }
}

TEST(BoundaryEvidence, LooksAtTheSectorsThatHoldWindows) {
  Weighed weighed({});
  weighed.weigh(field(flat));
  EXPECT_NEAR(bearing_of(static_cast<int>(weighed.evidence.arc().sector(0))), -kHalfAngle_rad, 0.04);
  EXPECT_NEAR(weighed.evidence.arc().count * 6.2832 / kSectors, 2.0 * kHalfAngle_rad, 0.08);
  weighed.weigh({});
  EXPECT_EQ(weighed.evidence.arc().count, 0);
}

TEST(BoundaryEvidence, OfAFullTurnHoldsAllSectors) {
  Weighed weighed({});
  weighed.weigh(test::scattered_windows(20000, 3.0, 40.0, 3.1416, flat));
  EXPECT_EQ(weighed.evidence.arc().count, kSectors);
}

TEST(BoundaryEvidence, ExpectsMoreOfWindowsWithoutFiringOrder) {
  BoundaryPisteConfig config = only(&BoundaryPisteConfig::use_roughness);
  config.adapt = false;
  config.tremble_mrad = 5.0;
  TraceWindows windows = field(flat);
  std::fill(windows.variance_m2.begin(), windows.variance_m2.end(), 2e-3F);
  Weighed ordered(config);
  ordered.weigh(windows, 9.0F, false);
  EXPECT_GT(ordered.shares(15.0F, 38.0F).first, 0.9);
  Weighed radial(config);
  radial.weigh(windows, 9.0F, true);
  EXPECT_EQ(radial.shares(15.0F, 38.0F).first, 0.0);
}

/// Settings may expect a sensor without noise on snow without roughness.
TEST(BoundaryEvidence, IsANumberWhereNoVarianceIsExpected) {
  BoundaryPisteConfig config;
  config.range_noise_m = 0.0;
  config.roughness_m = 0.0;
  config.curvature = 0.0;
  TraceWindows windows = field(flat);
  std::fill(windows.variance_m2.begin(), windows.variance_m2.begin() + 10000, 0.0F);
  Weighed weighed(config);
  weighed.weigh(windows);
  for (int i = 0; i < weighed.evidence.arc().count; ++i) {
    for (int bin = 0; bin < kBins; ++bin) {
      ASSERT_TRUE(std::isfinite(weighed.cell(weighed.evidence.arc().sector(i), bin)));
    }
  }
}

}  // namespace
}  // namespace berm
