#include "trace_windows.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <random>
#include <utility>

#include <gtest/gtest.h>
#include <rapidcheck.h>

namespace berm {
namespace {

constexpr double kWindow_m = 0.6;
constexpr double kSensorHeight_m = 2.3;

/// Points of one trace after the other.
struct MadeTraces {
  Traces traces;

  void add(double x_m, double y_m, double z_m, bool breaks = false) {
    const auto at = static_cast<std::uint32_t>(traces.index.size());
    traces.index.push_back(at);
    traces.x.push_back(static_cast<float>(x_m));
    traces.y.push_back(static_cast<float>(y_m));
    traces.z.push_back(static_cast<float>(z_m));
    traces.range.push_back(static_cast<float>(std::hypot(x_m, y_m, z_m - kSensorHeight_m)));
    const float before_x = at == 0 ? traces.x[0] : traces.x[at - 1];
    const float before_y = at == 0 ? traces.y[0] : traces.y[at - 1];
    traces.step.push_back(std::hypot(traces.x[at] - before_x, traces.y[at] - before_y));
    traces.is_broken.push_back(at == 0 || breaks ? 1 : 0);
  }

  /// `count` points from (x_m, y_m) towards `heading_rad`, on the ground that `z_of` says.
  template <typename HeightOf>
  void add_line(double x_m, double y_m, double heading_rad, double spacing_m, int count, HeightOf z_of) {
    for (int i = 0; i < count; ++i) {
      const double x = x_m + spacing_m * i * std::cos(heading_rad);
      const double y = y_m + spacing_m * i * std::sin(heading_rad);
      add(x, y, z_of(x, y), i == 0);
    }
  }

  [[nodiscard]] TraceWindows cut(double window_m = kWindow_m) const {
    TraceWindows windows;
    cut_windows(traces, window_m, windows);
    return windows;
  }
};

double flat_trace(double /*x_m*/, double /*y_m*/) {
  return 0.0;
}

TEST(TraceWindows, HaveTheSlopeOfAPlaneInTheirDirectionAndNoVariance) {
  EXPECT_TRUE(rc::check([] {
    const double dz_dx = *rc::gen::inRange(-700, 701) * 1e-3;
    const double dz_dy = *rc::gen::inRange(-700, 701) * 1e-3;
    const double heading_rad = *rc::gen::inRange(-3141, 3142) * 1e-3;
    const double spacing_m = *rc::gen::inRange(2, 40) * 1e-2;
    const double x_m = *rc::gen::inRange(-40, 41);
    const double y_m = *rc::gen::inRange(-40, 41);
    const auto z_of = [&](double x, double y) { return dz_dx * x + dz_dy * y; };
    MadeTraces made;
    made.add_line(x_m, y_m, heading_rad, spacing_m, 200, z_of);
    const TraceWindows windows = made.cut();
    RC_ASSERT(windows.size() > 0U);
    const double slope = dz_dx * std::cos(heading_rad) + dz_dy * std::sin(heading_rad);
    for (std::size_t i = 0; i < windows.size(); ++i) {
      if (windows.length_m[i] > 0.2F) {  // shorter ones claim no slope
        RC_ASSERT(std::abs(windows.slope[i] - slope) < 1e-3);
        const double rise_m = slope * double{windows.length_m[i]};
        RC_ASSERT(double{windows.variance_m2[i]} < 1e-6 * rise_m * rise_m + 1e-8);  // floats
      }
      RC_ASSERT(windows.variance_m2[i] >= 0.0F);
      RC_ASSERT(std::abs(windows.along_x[i] * windows.along_x[i] + windows.along_y[i] * windows.along_y[i] - 1.0F) <
                1e-4F);
      RC_ASSERT(std::abs(windows.z[i] - z_of(windows.x[i], windows.y[i])) < 1e-3);
      RC_ASSERT(std::abs(windows.range_m[i] - std::hypot(windows.x[i], windows.y[i])) <= 0.01F);
    }
  }));
}

TEST(TraceWindows, LookTheWayTheTraceGoes) {
  MadeTraces made;
  made.add_line(10.0, 3.0, 2.0, 0.05, 100, flat_trace);
  const TraceWindows windows = made.cut();
  ASSERT_GT(windows.size(), 5U);
  for (std::size_t i = 0; i < windows.size(); ++i) {
    EXPECT_NEAR(windows.along_x[i], std::cos(2.0), 1e-4);
    EXPECT_NEAR(windows.along_y[i], std::sin(2.0), 1e-4);
  }
}

/// The variance has no bias: two numbers of the line are taken from the same points.
TEST(TraceWindows, HaveTheVarianceOfTheNoise) {
  constexpr double kNoise_m = 0.01;
  std::mt19937 random(1);
  std::normal_distribution<double> noise(0.0, kNoise_m);
  for (const double spacing_m : {0.01, 0.05, 0.14}) {  // 60 points a window down to 5
    MadeTraces made;
    for (int line = 0; line < 200; ++line) {
      made.add_line(5.0 + 0.02 * line, -5.0, 1.3, spacing_m, 200,
                    [&](double x, double y) { return 0.2 * x - 0.1 * y + noise(random); });
    }
    const TraceWindows windows = made.cut();
    double sum_m2 = 0.0;
    for (const float variance_m2 : windows.variance_m2) {
      sum_m2 += double{variance_m2};
    }
    EXPECT_NEAR(sum_m2 / static_cast<double>(windows.size()), kNoise_m * kNoise_m, 0.05 * kNoise_m * kNoise_m)
        << spacing_m;
  }
}

TEST(TraceWindows, AreAsLongAsAsked) {
  for (const double window_m : {0.4, 0.6, 2.0}) {
    constexpr double kSpacing_m = 0.02;
    MadeTraces made;
    made.add_line(2.0, 0.0, 0.5, kSpacing_m, 300, flat_trace);
    const TraceWindows windows = made.cut(window_m);
    ASSERT_GE(windows.size(), 3U);
    for (std::size_t i = 0; i + 1 < windows.size(); ++i) {
      EXPECT_LE(windows.length_m[i], window_m + 1e-3);
      EXPECT_GT(windows.length_m[i], window_m - 1.5 * kSpacing_m);
      EXPECT_NEAR(windows.nominal_m[i], window_m, 1e-6);
    }
  }
}

TEST(TraceWindows, AreLongerInProportionToTheRangeFarAway) {
  const auto mean_length = [](double range_m) {
    MadeTraces made;
    made.add_line(range_m, 0.0, 0.5 * std::numbers::pi, 0.02, 1000, flat_trace);
    const TraceWindows windows = made.cut();
    EXPECT_NEAR(windows.length_m[0], windows.nominal_m[0], 0.05) << range_m;
    return double{windows.length_m[0]};
  };
  EXPECT_NEAR(mean_length(5.0), kWindow_m, 0.03);
  EXPECT_NEAR(mean_length(10.0), kWindow_m, 0.03);
  EXPECT_GT(mean_length(40.0), 2.0 * kWindow_m);
  EXPECT_NEAR(mean_length(80.0), 2.0 * mean_length(40.0), 0.1);
}

TEST(TraceWindows, HaveFourPointsAtLeast) {
  MadeTraces sparse;
  sparse.add_line(10.0, 0.0, 0.3, 1.0, 12, flat_trace);
  const TraceWindows windows = sparse.cut();
  ASSERT_EQ(windows.size(), 3U);
  for (const float length_m : windows.length_m) {
    EXPECT_NEAR(length_m, 3.0, 1e-3);
  }
  MadeTraces short_pieces;
  for (int piece = 0; piece < 10; ++piece) {
    short_pieces.add_line(10.0 + piece, 0.0, 0.3, 0.05, 3, flat_trace);
  }
  EXPECT_EQ(short_pieces.cut().size(), 0U);
  short_pieces.add_line(10.0, 5.0, 0.3, 0.05, 4, flat_trace);
  EXPECT_EQ(short_pieces.cut().size(), 1U);
}

TEST(TraceWindows, DoNotCrossBreaks) {
  MadeTraces made;
  for (int step = 0; step < 20; ++step) {  // stairs: any window over two of them would have a variance
    made.add_line(10.0 + 0.2 * step, 0.0, 0.0, 0.04, 5, [&](double, double) { return 0.5 * step; });
  }
  const TraceWindows windows = made.cut();
  ASSERT_EQ(windows.size(), 20U);
  for (std::size_t i = 0; i < windows.size(); ++i) {
    EXPECT_LT(windows.variance_m2[i], 1e-9F);
    EXPECT_NEAR(windows.z[i], 0.5 * static_cast<double>(i), 1e-5);
    EXPECT_NEAR(windows.slope[i], 0.0, 1e-4);
  }
}

TEST(TraceWindows, OfHardlyAnyLengthClaimNoSlope) {
  MadeTraces made;
  made.add_line(10.0, 4.0, 1.0, 0.004, 20, [](double x, double) { return 0.3 * x; });
  const TraceWindows windows = made.cut();
  ASSERT_EQ(windows.size(), 1U);
  EXPECT_EQ(windows.slope[0], 0.0F);
  EXPECT_NEAR(std::hypot(windows.along_x[0], windows.along_y[0]), 1.0, 1e-5);
}

TEST(TraceWindows, OfOnePointManyTimesAreFinite) {
  for (const double x_m : {0.0, 10.0}) {
    MadeTraces made;
    made.add_line(x_m, 0.0, 0.0, 0.0, 50, flat_trace);
    const TraceWindows windows = made.cut();
    ASSERT_EQ(windows.size(), 1U);
    for (const auto* channel : {&windows.x, &windows.y, &windows.z, &windows.along_x, &windows.along_y, &windows.slope,
                                &windows.variance_m2, &windows.length_m, &windows.nominal_m, &windows.range_m}) {
      EXPECT_TRUE(std::isfinite((*channel)[0]));
    }
    EXPECT_EQ(windows.variance_m2[0], 0.0F);
  }
}

TEST(TraceWindows, BelongToTheLastTracesAlone) {
  MadeTraces made;
  made.add_line(10.0, 0.0, 0.0, 0.05, 100, flat_trace);
  TraceWindows windows;
  cut_windows(made.traces, kWindow_m, windows);
  const std::size_t count = windows.size();
  cut_windows(made.traces, kWindow_m, windows);
  EXPECT_EQ(windows.size(), count);
  cut_windows({}, kWindow_m, windows);
  for (const auto* channel : {&windows.x, &windows.y, &windows.z, &windows.along_x, &windows.along_y, &windows.slope,
                              &windows.variance_m2, &windows.length_m, &windows.nominal_m, &windows.range_m}) {
    EXPECT_TRUE(channel->empty());
  }
}

}  // namespace
}  // namespace berm
