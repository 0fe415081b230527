#include "stage_times.hpp"

#include <chrono>
#include <thread>

#include <gtest/gtest.h>

namespace berm {
namespace {

TEST(StageTimes, NothingAddedIsZero) {
  EXPECT_EQ(StageTimes().summarize().max_ms, 0.0);
}

TEST(StageTimes, ByHand) {
  StageTimes times;
  for (int i = 100; i >= 1; --i) {
    times.add({.wall_ms = static_cast<double>(i), .cpu_ms = 2.0});
  }
  const StageSummary summary = times.summarize();
  EXPECT_DOUBLE_EQ(summary.mean_ms, 50.5);
  EXPECT_DOUBLE_EQ(summary.cpu_mean_ms, 2.0);
  EXPECT_DOUBLE_EQ(summary.p50_ms, 50.0);
  EXPECT_DOUBLE_EQ(summary.p95_ms, 95.0);
  EXPECT_DOUBLE_EQ(summary.p99_ms, 99.0);
  EXPECT_DOUBLE_EQ(summary.max_ms, 100.0);
}

TEST(StageTimes, OneScanIsEveryPercentile) {
  StageTimes times;
  times.add({.wall_ms = 3.0, .cpu_ms = 1.0});
  EXPECT_DOUBLE_EQ(times.summarize().p50_ms, 3.0);
  EXPECT_DOUBLE_EQ(times.summarize().p99_ms, 3.0);
}

TEST(StageTimes, LongRunsKeepMeansExactAndPercentilesClose) {
  StageTimes times;
  const std::size_t scans = 5 * StageTimes::kKept;
  for (std::size_t i = 0; i < scans; ++i) {
    times.add({.wall_ms = static_cast<double>(i), .cpu_ms = 1.0});
  }
  const StageSummary summary = times.summarize();
  EXPECT_EQ(times.count(), scans);
  EXPECT_DOUBLE_EQ(summary.mean_ms, static_cast<double>(scans - 1) / 2.0);
  EXPECT_DOUBLE_EQ(summary.max_ms, static_cast<double>(scans - 1));
  EXPECT_NEAR(summary.p50_ms, 0.5 * static_cast<double>(scans), 1e-3 * static_cast<double>(scans));
  EXPECT_NEAR(summary.p95_ms, 0.95 * static_cast<double>(scans), 1e-3 * static_cast<double>(scans));
}

TEST(StageClock, SleepCostsTimeButNoWork) {
  const StageClock clock;
  std::this_thread::sleep_for(std::chrono::milliseconds(30));
  const StageTime time = clock.stop();
  EXPECT_GE(time.wall_ms, 30.0);
  EXPECT_LT(time.cpu_ms, 15.0);
}

}  // namespace
}  // namespace berm
