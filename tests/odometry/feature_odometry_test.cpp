#include "berm/odometry/feature_odometry.hpp"

#include <algorithm>
#include <limits>
#include <vector>

#include <gtest/gtest.h>

#include "berm/core/error.hpp"
#include "berm/core/stamp.hpp"
#include "odometry/made_drive.hpp"

namespace berm {
namespace {

using test::made_yard;
using test::MadeScan;
using test::straight;

/// The made scans come without the numbers of their 16 lasers, which take turns.
class RingedScan {
 public:
  explicit RingedScan(const MadeScan& scan) : scan_(scan) {
    for (std::size_t i = 0; i < scan.labels.size(); ++i) {
      rings_.push_back(static_cast<std::uint16_t>(i % 16));
    }
  }
  [[nodiscard]] OdometryInput input() const {
    OdometryInput input = scan_.input();
    input.points.ring = rings_;
    return input;
  }

 private:
  const MadeScan& scan_;
  std::vector<std::uint16_t> rings_;
};

/// A drive that begins from standing, as the program that P builds on wants it: 0.8 m/s after a second.
Pose drive(double time_s) {
  const double x_m = time_s < 1.0 ? 0.4 * time_s * time_s : 0.4 + 0.8 * (time_s - 1.0);
  return Pose::from_yaw_pitch_roll(0.0, 0.0, 0.0, {x_m, 0.0, 0.0});
}

std::vector<OdometryResult> follow(const FeatureOdometryConfig& config, std::size_t scans,
                                   const test::MadePlace& place = made_yard()) {
  FeatureOdometry odometry(config);
  std::vector<OdometryResult> results;
  for (std::size_t i = 0; i < scans; ++i) {
    const MadeScan scan(place, drive, 0.1 * static_cast<double>(i));
    results.push_back(odometry.process(RingedScan(scan).input()));
  }
  return results;
}

double error_m(const Pose& estimate, double time_s) {
  return (estimate.translation_m() - drive(time_s).translation_m()).norm();
}

class FeatureOdometryVariants : public testing::TestWithParam<const char*> {};

TEST_P(FeatureOdometryVariants, FollowADrive) {
  // In one piece: in a third of a turn these lasers see a third of the yard, and planes of the ground drown the rest.
  const auto results = follow({.variant = GetParam(), .pieces = 1}, 30);
  EXPECT_EQ(results[0].health, OdometryHealth::starting);
  for (std::size_t i = 1; i < results.size(); ++i) {
    const double time_s = 0.1 * static_cast<double>(i);
    EXPECT_LT(error_m(results[i].T_world_begin, time_s), 0.1) << "scan " << i;
    EXPECT_LT(error_m(results[i].T_world_end, time_s + results[i].duration_s), 0.1) << "scan " << i;
    EXPECT_EQ(results[i].health, OdometryHealth::good) << "scan " << i;
    EXPECT_NEAR(results[i].duration_s, 0.1, 1e-3);
    EXPECT_GT(results[i].covariance.diagonal().minCoeff(), 0.0);
    EXPECT_LE(results[i].inliers, results[i].samples);
  }
}

INSTANTIATE_TEST_SUITE_P(OfTheFigure, FeatureOdometryVariants,
                         testing::Values("one_class", "four_classes", "four_classes_capped"),
                         [](const auto& variant) { return std::string(variant.param); });

TEST(FeatureOdometry, FollowsWithAnEvenMotionWithinTheScan) {
  const auto results = follow({.deskew = "interpolate", .pieces = 1}, 30);
  // Less exact than in pieces: it is up to the rounding of the compiler on which side of 0.1 m this ends.
  EXPECT_LT(error_m(results.back().T_world_begin, 2.9), 0.2);
}

TEST(FeatureOdometry, CapsAreKept) {
  const auto all = follow({.variant = "four_classes"}, 2);
  const auto capped = follow({.max_piste_planes = 50}, 2);
  const auto few = follow({.variant = "four_classes", .max_class_features = 60, .pieces = 1}, 2);
  EXPECT_LT(capped.back().samples + 200, all.back().samples);
  EXPECT_LE(few.back().samples, 4U * 60U);
}

TEST(FeatureOdometry, SameScansSamePoses) {
  const auto a = follow({}, 8);
  const auto b = follow({}, 8);
  for (std::size_t i = 0; i < a.size(); ++i) {
    EXPECT_EQ(a[i].T_world_end.matrix(), b[i].T_world_end.matrix());
    EXPECT_EQ(a[i].covariance, b[i].covariance);
  }
}

TEST(FeatureOdometry, SaysWhereTheGroundIsBare) {
  const auto results = follow({}, 12, test::bare_ground());
  const auto weak = std::count_if(results.begin(), results.end(), [](const OdometryResult& result) {
    return result.health == OdometryHealth::weak || result.health == OdometryHealth::lost;
  });
  EXPECT_GE(weak, 10);
}

TEST(FeatureOdometry, FallingSnowIsNotSeen) {
  FeatureOdometry clear({});
  FeatureOdometry snowy({});
  for (int i = 0; i < 5; ++i) {
    MadeScan scan(made_yard(), drive, 0.1 * i);
    const OdometryResult expected = clear.process(scan.input());
    for (int flake = 0; flake < 300; ++flake) {
      scan.channels.x.push_back(3.0F);
      scan.channels.y.push_back(0.01F * static_cast<float>(flake));
      scan.channels.z.push_back(0.1F);
      scan.channels.time.push_back(0.05F);
      scan.labels.push_back(Label::falling_snow);
    }
    EXPECT_EQ(snowy.process(scan.input()).T_world_end.matrix(), expected.T_world_end.matrix()) << "scan " << i;
  }
}

TEST(FeatureOdometryBadInput, RefusesWhatIsNoScanAndNoConfiguration) {
  FeatureOdometry odometry({});
  MadeScan scan(made_yard(), drive, 0.0);
  (void)odometry.process(scan.input());
  EXPECT_THROW((void)odometry.process(scan.input()), Error) << "the same stamp";
  scan.labels.pop_back();
  EXPECT_THROW((void)FeatureOdometry({}).process(scan.input()), Error);
  EXPECT_THROW(FeatureOdometry({.plane_spacing_m = 0.0}), ConfigError);
  EXPECT_THROW(FeatureOdometry({.variant = "five_classes"}), ConfigError);
}

TEST(FeatureOdometryBadInput, LivesOnNothing) {
  FeatureOdometry odometry({});
  for (int i = 0; i < 5; ++i) {
    const OdometryResult result = odometry.process({.stamp_ns = from_seconds(0.1 * i)});
    EXPECT_TRUE(result.T_world_end.matrix().allFinite());
    EXPECT_EQ(result.samples, 0U);
  }
}

TEST(FeatureOdometryBadInput, AScanOfFlakesOnlyIsLostAndLeavesNoTrace) {
  FeatureOdometry odometry({});
  Pose before;
  for (int i = 0; i < 12; ++i) {
    MadeScan scan(made_yard(), straight(0.0), 0.1 * i);
    if (i == 6) {
      scan.labels.assign(scan.labels.size(), Label::falling_snow);
    }
    const RingedScan ringed(scan);
    const OdometryResult result = odometry.process(ringed.input());
    EXPECT_EQ(result.health == OdometryHealth::lost, i == 6) << "scan " << i;
    EXPECT_LT(result.T_world_end.translation_m().norm(), 0.05);
  }
}

TEST(FeatureOdometryBadInput, LivesOnNaNAndFivePoints) {
  FeatureOdometry odometry({});
  const float nan = std::numeric_limits<float>::quiet_NaN();
  for (int i = 0; i < 10; ++i) {
    MadeScan scan(made_yard(), straight(0.0), 0.1 * i);
    if (i >= 5) {
      scan.channels = {};
      scan.channels.x = {5.0F, nan, 6.0F, 7.0F, std::numeric_limits<float>::infinity()};
      scan.channels.y = {1.0F, 1.0F, nan, 2.0F, 3.0F};
      scan.channels.z = {-2.0F, -1.0F, 0.0F, 1.0F, 0.0F};
      scan.channels.time = {0.0F, nan, 0.02F, nan, 0.1F};
      scan.labels.assign(5, Label::obstacle);
    }
    const OdometryResult result = odometry.process(scan.input());
    EXPECT_TRUE(result.T_world_end.matrix().allFinite());
    EXPECT_TRUE(result.covariance.allFinite());
  }
}

TEST(FeatureOdometryBadInput, PointsWithoutTimesAreTakenAtTheStamp) {
  FeatureOdometry odometry({});
  for (int i = 0; i < 10; ++i) {
    const Pose T_world_base(Eigen::Quaterniond::Identity(), {0.08 * i, 0.0, 0.0});
    MadeScan scan(
        made_yard(), [&T_world_base](double) { return T_world_base; }, 0.1 * i);
    scan.channels.time.clear();
    const OdometryResult result = odometry.process(RingedScan(scan).input());
    EXPECT_EQ(result.duration_s, 0.0);
    EXPECT_LT((result.T_world_begin.translation_m() - T_world_base.translation_m()).norm(), 0.1) << "scan " << i;
  }
}

TEST(FeatureOdometryBadInput, AJumpIsLost) {
  FeatureOdometry odometry({.max_speed_mps = 2.0});
  for (int i = 0; i < 8; ++i) {
    // 3 m within a tenth of a second.
    const double x_m = i < 5 ? 0.0 : 3.0;
    const MadeScan scan(
        made_yard(),
        [x_m](double) {
          return Pose(Eigen::Quaterniond::Identity(), {x_m, 0, 0});
        },
        0.1 * i);
    const OdometryResult result = odometry.process(RingedScan(scan).input());
    EXPECT_LT(result.T_world_end.translation_m().norm(), 1.0);
    if (i == 5) {
      EXPECT_NE(result.health, OdometryHealth::good);
    }
  }
}

}  // namespace
}  // namespace berm
