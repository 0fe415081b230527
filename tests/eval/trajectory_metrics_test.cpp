#include "berm/eval/trajectory_metrics.hpp"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include "berm/core/angle.hpp"

namespace berm {
namespace {

using Eigen::Vector3d;

/// Straight on along x, a pose every metre.
std::vector<PosePair> straight_path(int poses) {
  std::vector<PosePair> pairs;
  for (int i = 0; i < poses; ++i) {
    const Pose pose = Pose::from_yaw_pitch_roll(0.0, 0.0, 0.0, Vector3d(i, 0.0, 0.0));
    pairs.push_back({pose, pose});
  }
  return pairs;
}

/// A climbing bend, so that the alignment has no free direction.
std::vector<PosePair> winding_path(int poses) {
  std::vector<PosePair> pairs;
  for (int i = 0; i < poses; ++i) {
    const double angle = 0.05 * i;
    const Pose pose = Pose::from_yaw_pitch_roll(
        angle, 0.1, -0.05, Vector3d(30.0 * std::sin(angle), 30.0 * (1.0 - std::cos(angle)), 0.2 * i));
    pairs.push_back({pose, pose});
  }
  return pairs;
}

TEST(AbsoluteError, NeedsThreePoses) {
  EXPECT_FALSE(absolute_error_m(straight_path(2)).has_value());
  EXPECT_FALSE(absolute_error_m({}).has_value());
  EXPECT_NEAR(*absolute_error_m(straight_path(3)), 0.0, 1e-12);
}

TEST(AbsoluteError, PureScaleOnALineByHand) {
  // Poses 0..4 m stretched by 1.5: after the means coincide, 0.5 * |i - 2| is left.
  auto pairs = straight_path(5);
  for (auto& pair : pairs) {
    pair.estimate = Pose(pair.estimate.rotation(), 1.5 * pair.estimate.translation_m());
  }
  EXPECT_NEAR(*absolute_error_m(pairs), 0.5 * std::sqrt((4.0 + 1.0 + 0.0 + 1.0 + 4.0) / 5.0), 1e-12);
}

TEST(AbsoluteError, IsNotFooledByAMirroredPath) {
  auto pairs = winding_path(100);
  for (auto& pair : pairs) {
    pair.estimate = Pose(pair.estimate.rotation(), -pair.estimate.translation_m());
  }
  EXPECT_GT(*absolute_error_m(pairs), 1.0);
}

TEST(AbsoluteErrorLaws, ForgivesEveryRigidMotion) {
  EXPECT_TRUE(rc::check([] {
    Vector6d twist;
    for (Eigen::Index i = 0; i < 6; ++i) {
      twist(i) = 1e-3 * *rc::gen::inRange(-3000, 3000);
    }
    const Pose moved = Pose::exp(twist);
    auto pairs = winding_path(60);
    for (auto& pair : pairs) {
      pair.estimate = moved * pair.estimate;
    }
    RC_ASSERT(*absolute_error_m(pairs) < 1e-9);
  }));
}

TEST(AbsoluteError, KeepsItsDigitsFarFromTheOrigin) {
  auto pairs = winding_path(60);
  const Pose utm(Eigen::Quaterniond::Identity(), Vector3d(6.5e5, 5.2e6, 2000.0));
  for (auto& pair : pairs) {
    pair.truth = utm * pair.truth;
  }
  EXPECT_LT(*absolute_error_m(pairs), 1e-6);
}

TEST(RelativeErrors, PureScaleGivesItsPercentage) {
  auto pairs = straight_path(151);
  for (auto& pair : pairs) {
    pair.estimate = Pose(pair.estimate.rotation(), 1.02 * pair.estimate.translation_m());
  }
  const auto errors = relative_errors(pairs);
  ASSERT_EQ(errors.size(), 4U);
  const double lengths_m[] = {10.0, 25.0, 50.0, 100.0};
  const std::size_t stretches[] = {141, 126, 101, 51};
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_EQ(errors[i].length_m, lengths_m[i]);
    EXPECT_EQ(errors[i].stretches, stretches[i]);
    EXPECT_NEAR(errors[i].translation_percent, 2.0, 1e-9);
    EXPECT_NEAR(errors[i].rotation_deg_per_m, 0.0, 1e-9);
  }
  EXPECT_NEAR(mean_error(errors)->translation_percent, 2.0, 1e-9);
  EXPECT_EQ(mean_error(errors)->stretches, 419U);
}

TEST(RelativeErrors, PureTurnGivesDegreesPerMetre) {
  // The heading drifts by 0.1 deg a metre while the position stays right.
  auto pairs = straight_path(31);
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    const double drift_rad = 0.1 * kRadPerDeg * static_cast<double>(i);
    pairs[i].estimate = Pose::from_yaw_pitch_roll(drift_rad, 0.0, 0.0, pairs[i].truth.translation_m());
  }
  const auto errors = relative_errors(pairs);
  ASSERT_EQ(errors.size(), 2U);
  EXPECT_NEAR(errors[0].rotation_deg_per_m, 0.1, 1e-9);
  EXPECT_NEAR(errors[1].rotation_deg_per_m, 0.1, 1e-9);
}

TEST(RelativeErrors, UsesThePathThatWasDrivenNotTheNominalLength) {
  // Poses every 4 m: the first that reaches 10 m is 12 m away.
  auto pairs = straight_path(20);
  for (auto& pair : pairs) {
    pair.truth = Pose(pair.truth.rotation(), 4.0 * pair.truth.translation_m());
    pair.estimate = Pose(pair.estimate.rotation(), 4.4 * pair.estimate.translation_m());
  }
  const auto errors = relative_errors(pairs);
  EXPECT_NEAR(errors.at(0).translation_percent, 10.0, 1e-9);
}

TEST(RelativeErrors, PathsThatAreTooShortHaveNone) {
  EXPECT_TRUE(relative_errors(straight_path(9)).empty());
  EXPECT_FALSE(mean_error({}).has_value());
  EXPECT_TRUE(relative_errors({}).empty());
}

TEST(RelativeErrorsLaws, TheWorldFramesDoNotMatter) {
  auto pairs = winding_path(120);
  for (auto& pair : pairs) {
    pair.estimate = Pose(pair.estimate.rotation(), 1.01 * pair.estimate.translation_m());
  }
  const auto before = relative_errors(pairs);
  const Pose elsewhere = Pose::from_yaw_pitch_roll(2.0, -0.4, 0.3, Vector3d(10.0, -20.0, 5.0));
  for (auto& pair : pairs) {
    pair.estimate = elsewhere * pair.estimate;
  }
  const auto after = relative_errors(pairs);
  ASSERT_EQ(before.size(), after.size());
  for (std::size_t i = 0; i < before.size(); ++i) {
    EXPECT_NEAR(before[i].translation_percent, after[i].translation_percent, 1e-9);
    EXPECT_NEAR(before[i].rotation_deg_per_m, after[i].rotation_deg_per_m, 1e-9);
  }
}

TEST(PairPoses, InterpolatesTruthAndLeavesOutWhatItDoesNotCover) {
  Trajectory truth;
  truth.append(1000, Pose(Eigen::Quaterniond::Identity(), Vector3d(0.0, 0.0, 0.0)));
  truth.append(2000, Pose(Eigen::Quaterniond::Identity(), Vector3d(10.0, 0.0, 0.0)));
  Trajectory estimate;
  for (const Stamp stamp_ns : {500, 1000, 1250, 2000, 2001}) {
    estimate.append(stamp_ns, Pose());
  }
  const auto pairs = pair_poses(estimate, truth);
  ASSERT_EQ(pairs.size(), 3U);
  EXPECT_NEAR(pairs[1].truth.translation_m().x(), 2.5, 1e-12);
  EXPECT_NEAR(path_length_m(pairs), 10.0, 1e-12);
}

}  // namespace
}  // namespace berm
