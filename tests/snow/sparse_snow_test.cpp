#include "berm/snow/sparse_snow.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "berm/core/error.hpp"
#include "snow/snow_cases.hpp"
#include "support/random_points.hpp"

namespace berm {
namespace {

using test::let_it_snow;
using test::Lookout;
using test::lookouts;
using test::MadeScan;
using test::SnowyScan;
using test::World;

constexpr float kNanPoint = std::numeric_limits<float>::quiet_NaN();

TEST(SparseSnow, FindsFlakesOfEveryDensityWithEverySensor) {
  SparseSnow snow({});
  for (const Lookout& lookout : lookouts()) {
    const MadeScan scan = lookout.look(test::made_street(1));
    for (const double share : {0.01, 0.05, 0.12, 0.3, 0.6}) {
      const SnowyScan snowy = let_it_snow(scan, {.share = share}, 11);
      const SnowResult result = snow.process(snowy.view(), {});
      EXPECT_TRUE(test::is_sound(result, snowy.view()));
      // One beam in a hundred is 40 flakes of the rosette: chance decides over hundredths.
      EXPECT_GE(test::score(result, snowy).f1, share < 0.02 ? 0.95 : 0.97) << lookout.name << ", " << share;
    }
  }
}

TEST(SparseSnow, FindsFlakesWithoutIntensity) {
  SparseSnow snow({});
  for (const Lookout& lookout : lookouts()) {
    const MadeScan scan = lookout.look(test::made_street(1));
    for (const double share : {0.05, 0.12}) {
      SnowyScan snowy = let_it_snow(scan, {.share = share}, 12);
      for (const float value : {kNanPoint, 0.0F, 77.0F}) {
        std::fill(snowy.channels.intensity.begin(), snowy.channels.intensity.end(), value);
        const SnowResult result = snow.process(snowy.view(), {});
        EXPECT_TRUE(result.limits.no_intensity);
        EXPECT_GE(test::score(result, snowy).f1, 0.9) << lookout.name << ", " << share;
      }
      snowy.channels.intensity.clear();
      const SnowResult result = snow.process(snowy.view(), {});
      EXPECT_TRUE(result.limits.no_intensity);
      EXPECT_GE(test::score(result, snowy).f1, 0.9) << lookout.name << ", " << share;
      EXPECT_GE(test::score(result, snowy).precision, 0.98) << lookout.name << ", " << share;
    }
  }
}

TEST(SparseSnow, LearnsFromTheScanWhatIsDark) {
  SparseSnow snow({});
  const MadeScan scan = test::rosette_70().look(test::made_street(1));
  for (const float flakes : {0.0F, 4.0F, 20.0F, 55.0F}) {
    const SnowyScan snowy = let_it_snow(scan, {.most_intensity = flakes}, 13);
    EXPECT_GE(test::score(snow.process(snowy.view(), {}), snowy).f1, 0.97) << flakes;
  }
  // All alike: then it is as if there were no intensity.
  const SnowyScan alike = let_it_snow(scan, {.most_intensity = 180.0F, .least_intensity = 0.0F}, 13);
  EXPECT_GE(test::score(snow.process(alike.view(), {}), alike).f1, 0.9);
}

TEST(SparseSnow, MarksNothingInClearAir) {
  SparseSnow snow({});
  for (const Lookout& lookout : lookouts()) {
    for (const std::uint32_t seed : {1U, 2U, 3U}) {
      SnowyScan clear = let_it_snow(lookout.look(test::made_street(seed)), {.share = 0.0, .least_intensity = 0.0F}, 14);
      EXPECT_LE(test::score(snow.process(clear.view(), {}), clear).marked, 0.0005) << lookout.name;
      clear.channels.intensity.clear();
      EXPECT_LE(test::score(snow.process(clear.view(), {}), clear).marked, 0.0005) << lookout.name;
    }
  }
}

/// Share of the points near the upright line through (x, y) that are marked, and how many there are.
struct OnPole {
  double marked = 0.0;
  std::size_t points = 0;
};

OnPole on_pole(const SnowResult& result, const SnowyScan& scan, float x_m, float y_m) {
  OnPole pole;
  for (std::size_t i = 0; i < scan.is_flake.size(); ++i) {
    if (scan.is_flake[i] == 0 && std::hypot(scan.channels.x[i] - x_m, scan.channels.y[i] - y_m) < 0.15F) {
      ++pole.points;
      pole.marked += result.falling[i];
    }
  }
  pole.marked /= std::max(1.0, static_cast<double>(pole.points));
  return pole;
}

TEST(SparseSnow, SparesThinDarkPolesInSnowfall) {
  for (const double distance_m : {3.0, 5.0, 8.0}) {
    World world;
    for (const double side_m : {-1.0, 0.0, 1.0}) {
      world.things.push_back({.x_m = distance_m,
                              .y_m = side_m,
                              .half_length_m = 0.03,
                              .half_width_m = 0.03,
                              .height_m = 5.0,
                              .round = true});
    }
    for (Lookout lookout : lookouts()) {
      lookout.pitch_deg = 0.0;
      SnowyScan scan = let_it_snow(lookout.look(world), {.share = 0.08}, 15);
      for (std::size_t i = 0; i < scan.is_flake.size(); ++i) {
        const float height_m = scan.channels.z[i] + static_cast<float>(lookout.height_m);
        if (scan.is_flake[i] == 0 && height_m > 0.1F) {
          scan.channels.intensity[i] = 0.0F;  // what stands on the ground is as dark as a flake
        }
      }
      const auto marked = [&](bool spare_lines) {
        SparseSnowConfig config;
        config.spare_lines = spare_lines;
        SparseSnow snow(config);
        const SnowResult result = snow.process(scan.view(), {});
        EXPECT_GE(test::score(result, scan).recall, 0.93) << lookout.name;
        return on_pole(result, scan, static_cast<float>(distance_m), 0.0F);
      };
      const OnPole pole = marked(true);
      EXPECT_GT(pole.points, 5U) << lookout.name << ", " << distance_m;
      EXPECT_LE(pole.marked, 0.2) << lookout.name << ", " << distance_m << " m, " << pole.points << " points";
      EXPECT_LE(pole.marked, marked(false).marked);
    }
  }
}

TEST(SparseSnow, SparesDarkGroundAndRockInSnowfall) {
  SparseSnow snow({});
  for (const Lookout& lookout : lookouts()) {
    SnowyScan scan = let_it_snow(lookout.look(test::made_street(3)), {.share = 0.08}, 16);
    // Half of what is seen, in stripes two metres wide, is as dark as flakes.
    double dark = 0.0;
    for (std::size_t i = 0; i < scan.is_flake.size(); ++i) {
      if (scan.is_flake[i] == 0 && std::fmod(std::fabs(scan.channels.y[i]), 4.0F) < 2.0F) {
        scan.channels.intensity[i] = static_cast<float>(i % 4);
        dark += 1.0;
      }
    }
    const SnowResult result = snow.process(scan.view(), {});
    const test::SnowScore score = test::score(result, scan);
    EXPECT_GE(score.precision, 0.97) << lookout.name;
    EXPECT_GE(score.recall, 0.7) << lookout.name;
    EXPECT_LE((1.0 - score.precision) * static_cast<double>(result.count) / dark, 0.003) << lookout.name;
  }
}

TEST(SparseSnow, OnlyNoReturnsAndNanAreNoFlakesAndAreReported) {
  SparseSnow snow({});
  const std::vector<float> nothing(500, 0.0F);
  const std::vector<float> nan(500, kNanPoint);
  for (const std::vector<float>& values : {nothing, nan}) {
    const SnowResult result = snow.process({.x = values, .y = values, .z = values, .intensity = nothing}, {});
    EXPECT_EQ(result.count, 0U);
    EXPECT_EQ(result.falling.size(), 500U);
    EXPECT_TRUE(result.limits.no_points);
    EXPECT_TRUE(result.limits.no_intensity);
  }
  EXPECT_FALSE(snow.process({.x = nothing, .y = nothing, .z = nothing}, {}).limits.no_returns_dropped);
  EXPECT_EQ(snow.process({}, {}).falling.size(), 0U);
}

TEST(SparseSnow, FewOddPointsAreNoReasonToFall) {
  SparseSnow snow({});
  for (const std::size_t count : {1U, 2U, 3U, 10U}) {
    const std::vector<float> same(count, 3.0F);
    const std::vector<float> zero(count, 0.0F);
    EXPECT_TRUE(test::is_sound(snow.process({.x = same, .y = same, .z = same, .intensity = zero}, {}),
                               {.x = same, .y = same, .z = same}));
    EXPECT_TRUE(test::is_sound(snow.process({.x = same, .y = zero, .z = zero}, {}), {.x = same, .y = zero, .z = zero}));
  }
  for (std::uint32_t seed = 0; seed < 50; ++seed) {
    const PointCloud cloud(test::random_points(seed * 40, seed, test::ChannelSet::from_bits(seed)));
    EXPECT_TRUE(test::is_sound(snow.process(cloud.view(), {}), cloud.view())) << seed;
  }
}

TEST(SparseSnow, DroppedNoReturnsCostNothingAndAreReported) {
  SparseSnow snow({});
  const SnowyScan scan = let_it_snow(test::rosette_70().look(test::made_street(1)), {.share = 0.12}, 17);
  EXPECT_FALSE(snow.process(scan.view(), {}).limits.no_returns_dropped);
  std::vector<std::size_t> returns;
  for (std::size_t i = 0; i < scan.is_flake.size(); ++i) {
    if (!is_no_return(scan.channels.x[i], scan.channels.y[i], scan.channels.z[i])) {
      returns.push_back(i);
    }
  }
  ASSERT_LT(returns.size(), scan.is_flake.size());
  const SnowyScan dense = test::picked(scan, returns);
  const SnowResult result = snow.process(dense.view(), {});
  EXPECT_TRUE(result.limits.no_returns_dropped);
  EXPECT_GE(test::score(result, dense).f1, 0.97);
}

TEST(SparseSnow, WorksOnTwoSensorsMergedIntoOneScan) {
  SparseSnow snow({});
  SnowyScan both = let_it_snow(test::rosette_70().look(test::made_street(1)), {.share = 0.08}, 18);
  const SnowyScan other = let_it_snow(test::spinning_16().look(test::made_street(1)), {.share = 0.08}, 19);
  for (std::size_t i = 0; i < other.is_flake.size(); ++i) {
    both.channels.x.push_back(other.channels.x[i] + 0.4F);
    both.channels.y.push_back(other.channels.y[i] - 0.6F);
    both.channels.z.push_back(other.channels.z[i] - 0.5F);
    both.channels.intensity.push_back(other.channels.intensity[i]);
    both.is_flake.push_back(other.is_flake[i]);
  }
  EXPECT_GE(test::score(snow.process(both.view(), {}), both).f1, 0.95);
}

TEST(SparseSnow, NanAmongThePointsChangesNothingElse) {
  SparseSnow snow({});
  SnowyScan scan = let_it_snow(test::spinning_16().look(test::made_street(1)), {}, 20);
  std::mt19937 random(1);
  for (std::size_t i = 0; i < scan.is_flake.size(); ++i) {
    if (random() % 10 == 0) {
      scan.channels.x[i] = random() % 2 == 0 ? kNanPoint : std::numeric_limits<float>::infinity();
      scan.is_flake[i] = 0;
    }
  }
  const SnowResult result = snow.process(scan.view(), {});
  EXPECT_TRUE(test::is_sound(result, scan.view()));
  EXPECT_GE(test::score(result, scan).f1, 0.97);
}

TEST(SparseSnow, SettingsOutOfRangeAreRefused) {
  SparseSnowConfig config;
  config.window = 0.0;
  EXPECT_THROW(SparseSnow{config}, ConfigError);
}

}  // namespace
}  // namespace berm
