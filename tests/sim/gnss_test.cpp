#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "berm/core/angle.hpp"
#include "berm/core/error.hpp"
#include "berm/sim/motion.hpp"

namespace berm::sim {
namespace {

using Eigen::Vector3d;

/// Stands still for `seconds`.
Trajectory standing(int seconds) {
  Trajectory truth;
  for (int i = 0; i <= 100 * seconds; ++i) {
    truth.append(i * 10'000'000LL, Pose::from_yaw_pitch_roll(1.0, 0.2, -0.1, {100.0, -50.0, 7.0}));
  }
  return truth;
}

GnssConfig silent() {
  GnssConfig config;
  config.noise_m = 0.0;
  config.drift_m = 0.0;
  config.attitude_noise_deg = 0.0;
  config.heading_noise_deg = 0.0;
  return config;
}

std::vector<Vector3d> offsets(const Trajectory& measured, const Trajectory& truth) {
  std::vector<Vector3d> result;
  for (const StampedPose& pose : measured.poses()) {
    result.push_back(pose.T_world_base.translation_m() - truth.at(pose.stamp_ns)->translation_m());
  }
  return result;
}

/// Root of the mean square of the difference of samples that lie `lag` apart, over the root of 2.
Vector3d spread(const std::vector<Vector3d>& values, std::size_t lag) {
  Vector3d squares = Vector3d::Zero();
  for (std::size_t i = lag; i < values.size(); ++i) {
    squares += (values[i] - values[i - lag]).cwiseAbs2();
  }
  return (squares / (2.0 * static_cast<double>(values.size() - lag))).cwiseSqrt();
}

TEST(Gnss, WithoutErrorsItSaysTheTruth) {
  const Trajectory truth = standing(2);
  const Trajectory measured = measure_gnss(truth, silent(), 1);
  ASSERT_EQ(measured.size(), truth.size());
  for (std::size_t i = 0; i < truth.size(); ++i) {
    EXPECT_NEAR((measured.poses()[i].T_world_base.inverse() * truth.poses()[i].T_world_base).log().norm(), 0.0, 1e-12);
  }
}

TEST(Gnss, ItsRateIsTheConfiguredOne) {
  GnssConfig config = silent();
  config.rate_hz = 8.0;
  const Trajectory measured = measure_gnss(standing(2), config, 1);
  ASSERT_EQ(measured.size(), 17U);
  EXPECT_EQ(measured.poses()[3].stamp_ns, 375'000'000);
  config.rate_hz = 0.0;
  EXPECT_TRUE(measure_gnss(standing(2), config, 1).empty());
}

TEST(Gnss, NoiseIsAsLargeAsConfigured) {
  GnssConfig config = silent();
  config.noise_m = 0.01;
  config.attitude_noise_deg = 0.1;
  config.heading_noise_deg = 0.5;
  const Trajectory truth = standing(200);
  const Trajectory measured = measure_gnss(truth, config, 3);
  const Vector3d noise = spread(offsets(measured, truth), 1);
  EXPECT_NEAR(noise.x(), 0.01, 0.0005);
  EXPECT_NEAR(noise.y(), 0.01, 0.0005);
  EXPECT_NEAR(noise.z(), 0.02, 0.001);
  Vector3d squares = Vector3d::Zero();
  const Pose& pose = truth.poses().front().T_world_base;
  for (const StampedPose& stamped : measured.poses()) {
    const Vector3d world_turn = pose.rotation() * (pose.inverse() * stamped.T_world_base).log().tail<3>();
    squares += world_turn.cwiseAbs2();
  }
  const Vector3d turn = (squares / static_cast<double>(measured.size())).cwiseSqrt() * kDegPerRad;
  EXPECT_NEAR(turn.z(), 0.5, 0.03);
  EXPECT_NEAR(turn.x(), 0.1, 0.02);
  EXPECT_NEAR(turn.y(), 0.1, 0.02);
}

TEST(Gnss, DriftIsSlow) {
  GnssConfig config = silent();
  config.rate_hz = 10.0;
  config.drift_m = 0.5;
  config.drift_s = 10.0;
  const Trajectory truth = standing(3000);
  const auto drift = offsets(measure_gnss(truth, config, 3), truth);
  // Gauss-Markov: the variance of differences is 2 sigma^2 (1 - exp(-t / tau)).
  for (const double lag_s : {0.1, 1.0, 10.0, 50.0}) {
    const double expected = 0.5 * std::sqrt(1.0 - std::exp(-lag_s / 10.0));
    const Vector3d found = spread(drift, static_cast<std::size_t>(std::lround(lag_s * 10.0)));
    EXPECT_NEAR(found.mean() / expected, 1.0, 0.1) << lag_s;
  }
}

TEST(Gnss, OutagesLeavePosesOutAndChangeNoOther) {
  GnssConfig config;
  const Trajectory truth = standing(300);
  const Trajectory whole = measure_gnss(truth, config, 9);
  config.outage_every_s = 30.0;
  config.outage_s = 4.0;
  const Trajectory measured = measure_gnss(truth, config, 9);
  const double missing_s = static_cast<double>(whole.size() - measured.size()) / config.rate_hz;
  EXPECT_NEAR(missing_s, 4.0 * 300.0 / 34.0, 12.0);
  std::size_t gaps = 0;
  for (std::size_t i = 0; i < measured.size(); ++i) {
    const StampedPose& pose = measured.poses()[i];
    EXPECT_EQ(pose.T_world_base.matrix(), whole.at(pose.stamp_ns)->matrix());
    if (i > 0 && pose.stamp_ns - measured.poses()[i - 1].stamp_ns > 20'000'000) {
      EXPECT_NEAR(to_seconds(pose.stamp_ns - measured.poses()[i - 1].stamp_ns), 4.0, 0.03);
      ++gaps;
    }
  }
  EXPECT_GE(gaps, 5U);
}

TEST(Gnss, JumpsOnceHalfway) {
  GnssConfig config = silent();
  config.jump_m = 0.8;
  const Trajectory truth = standing(10);
  const auto found = offsets(measure_gnss(truth, config, 2), truth);
  for (std::size_t i = 0; i < found.size(); ++i) {
    EXPECT_NEAR(found[i].norm(), i < 500 ? 0.0 : 0.8, 1e-9) << i;
    EXPECT_NEAR(found[i].z(), 0.0, 1e-12);
  }
}

TEST(Gnss, NonsenseIsRefused) {
  GnssConfig config;
  config.rate_hz = 1e-12;
  EXPECT_THROW(config.check(), ConfigError);
  config = {};
  config.outage_every_s = 1e-9;
  EXPECT_THROW(config.check(), ConfigError);
  config = {};
  config.noise_m = -1.0;
  EXPECT_THROW(static_cast<void>(measure_gnss(standing(1), config, 1)), ConfigError);
}

}  // namespace
}  // namespace berm::sim
