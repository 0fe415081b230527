#include "berm/pipeline/mount_check.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "berm/core/angle.hpp"
#include "berm/core/mount.hpp"
#include "support/made_scan.hpp"

namespace berm {
namespace {

Pose mount(double height_m, double pitch_deg = 0.0, double roll_deg = 0.0) {
  return MountConfig{.height_m = height_m, .pitch_deg = pitch_deg, .roll_deg = roll_deg}.T_base_sensor();
}

PointCloud street() {
  const test::World world = test::made_street(3);
  return test::cast(world, test::spinning_beams(32, -25.0, 10.0, 600), test::standing_at_origin(world, 1.8)).cloud;
}

PointCloud slope(double terrain_deg, double heel_deg = 0.0) {
  test::World world;
  world.terrain_m = [terrain_deg, heel_deg](double x_m, double y_m) {
    return std::tan(terrain_deg * kRadPerDeg) * x_m + std::tan(heel_deg * kRadPerDeg) * y_m;
  };
  // The machine stands on the slope: nose up.
  return test::cast(world, test::rosette_beams(70.4, 10000), test::standing_at_origin(world, 2.3, 11.0 - terrain_deg))
      .cloud;
}

MountCheckResult check(const PointCloud& cloud, const Pose& T_base_sensor) {
  return MountCheck().process(cloud.view(), {}, T_base_sensor);
}

TEST(MountCheck, BelievesWhatIsRight) {
  const MountCheckResult result = check(street(), mount(1.8));
  EXPECT_EQ(result.verdict, MountVerdict::plausible);
  ASSERT_TRUE(result.estimate);
  EXPECT_LT(result.estimate->tilt_rad, 3.0 * kRadPerDeg);
  EXPECT_NEAR(result.estimate->height_m, 1.8, 0.15);
}

TEST(MountCheck, ASlopeIsNoReasonToDoubt) {
  for (const double terrain_deg : {-34.0, -15.0, 0.0, 15.0, 34.0}) {
    EXPECT_EQ(check(slope(terrain_deg), mount(2.3, 11.0)).verdict, MountVerdict::plausible) << terrain_deg;
  }
}

TEST(MountCheck, SaysHowMuchAndInWhichDirection) {
  const PointCloud cloud = street();
  const MountCheckResult nose = check(cloud, mount(1.8, -30.0));
  EXPECT_EQ(nose.verdict, MountVerdict::implausible);
  ASSERT_TRUE(nose.estimate);
  EXPECT_NEAR(nose.estimate->pitch_rad, 30.0 * kRadPerDeg, 3.0 * kRadPerDeg) << "the nose looks down more than it says";
  EXPECT_NEAR(nose.estimate->roll_rad, 0.0, 3.0 * kRadPerDeg);
  const MountCheckResult side = check(cloud, mount(1.8, 0.0, 30.0));
  EXPECT_EQ(side.verdict, MountVerdict::implausible);
  ASSERT_TRUE(side.estimate);
  EXPECT_NEAR(side.estimate->roll_rad, -30.0 * kRadPerDeg, 3.0 * kRadPerDeg);
}

TEST(MountCheck, NoticesUpsideDown) {
  const MountCheckResult result = check(street(), mount(1.8, 0.0, 180.0));
  EXPECT_EQ(result.verdict, MountVerdict::implausible);
  ASSERT_TRUE(result.estimate);
  EXPECT_GT(result.estimate->tilt_rad, 175.0 * kRadPerDeg);
}

TEST(MountCheck, NoticesAWrongHeightUnlessNoneIsGiven) {
  const PointCloud cloud = street();
  EXPECT_EQ(check(cloud, mount(6.0)).verdict, MountVerdict::implausible);
  EXPECT_EQ(check(cloud, mount(0.5)).verdict, MountVerdict::implausible);
  EXPECT_EQ(check(cloud, mount(0.0)).verdict, MountVerdict::plausible);
  EXPECT_EQ(check(cloud, mount(2.3)).verdict, MountVerdict::plausible) << "half a metre is what snow can do";
}

TEST(MountCheck, AWallAloneTellsNothing) {
  PointChannels channels;
  for (int i = 0; i < 5000; ++i) {
    channels.x.push_back(8.0F);
    channels.y.push_back(-10.0F + 0.2F * static_cast<float>(i % 100));
    channels.z.push_back(0.2F * static_cast<float>(i / 100));
  }
  const MountCheckResult result = check(PointCloud(std::move(channels)), mount(1.8));
  EXPECT_EQ(result.verdict, MountVerdict::unknown);
  EXPECT_FALSE(result.estimate);
}

TEST(MountCheck, TooFewPointsTellNothing) {
  PointChannels channels;
  for (int i = 0; i < 40; ++i) {
    channels.x.push_back(3.0F + 0.3F * static_cast<float>(i % 7));
    channels.y.push_back(0.5F * static_cast<float>(i / 7));
    channels.z.push_back(-1.8F);
  }
  EXPECT_EQ(check(PointCloud(std::move(channels)), mount(1.8)).verdict, MountVerdict::unknown);
  EXPECT_EQ(check(PointCloud(), mount(1.8)).verdict, MountVerdict::unknown);
}

TEST(MountCheck, FlakesHaveNoSay) {
  const PointCloud ground = slope(10.0);
  PointChannels channels;
  const PointsView view = ground.view();
  std::vector<std::uint8_t> falling;
  for (std::size_t i = 0; i < view.size(); ++i) {
    // Every other beam meets a sheet of flakes above the sensor.
    const bool flake = i % 2 == 0;
    falling.push_back(flake ? 1 : 0);
    channels.x.push_back(flake ? 2.0F + 0.01F * static_cast<float>(i % 1000) : view.x[i]);
    channels.y.push_back(flake ? -5.0F + 0.01F * static_cast<float>(i / 10) : view.y[i]);
    channels.z.push_back(flake ? 2.0F : view.z[i]);
  }
  const PointCloud cloud(std::move(channels));
  EXPECT_EQ(MountCheck().process(cloud.view(), falling, mount(2.3, 11.0)).verdict, MountVerdict::plausible);
}

TEST(MountCheck, KeepsNothingFromScanToScan) {
  MountCheck used;
  static_cast<void>(used.process(slope(20.0).view(), {}, mount(2.3, 11.0)));
  const PointCloud cloud = street();
  const auto again = used.process(cloud.view(), {}, mount(1.8));
  const auto fresh = check(cloud, mount(1.8));
  ASSERT_TRUE(again.estimate && fresh.estimate);
  EXPECT_EQ(again.estimate->tilt_rad, fresh.estimate->tilt_rad);
  EXPECT_EQ(again.estimate->height_m, fresh.estimate->height_m);
}

MountCheckResult made_result(MountVerdict verdict, double tilt_rad) {
  MountCheckResult result{.verdict = verdict};
  if (verdict != MountVerdict::unknown) {
    result.estimate = MountEstimate{.tilt_rad = tilt_rad, .height_m = 2.0};
  }
  return result;
}

TEST(MountStatistics, MostScansDecide) {
  MountStatistics statistics;
  EXPECT_EQ(statistics.summarize().verdict, MountVerdict::unknown);
  statistics.add(made_result(MountVerdict::implausible, 0.5));
  EXPECT_EQ(statistics.summarize().verdict, MountVerdict::implausible);
  statistics.add(made_result(MountVerdict::plausible, 0.1));
  statistics.add(made_result(MountVerdict::plausible, 0.2));
  const MountSummary summary = statistics.summarize();
  EXPECT_EQ(summary.verdict, MountVerdict::plausible);
  EXPECT_EQ(summary.scans, 3U);
  EXPECT_DOUBLE_EQ(summary.estimate->tilt_rad, 0.2);
}

TEST(MountStatistics, AFewScansAmongManyThatCannotTellAreNotEnough) {
  MountStatistics statistics;
  statistics.add(made_result(MountVerdict::implausible, 0.5));
  for (int i = 0; i < 10; ++i) {
    statistics.add(made_result(MountVerdict::unknown, 0.0));
  }
  EXPECT_EQ(statistics.summarize().verdict, MountVerdict::unknown);
  EXPECT_EQ(statistics.summarize().scans, 1U);
}

}  // namespace
}  // namespace berm
