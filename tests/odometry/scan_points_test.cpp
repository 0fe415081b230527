#include "scan_points.hpp"

#include <limits>
#include <set>

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include "odometry/made_drive.hpp"

namespace berm {
namespace {

TEST(MetVoxels, IsASet) {
  EXPECT_TRUE(rc::check([] {
    MetVoxels met;
    for (int round = 0; round < 3; ++round) {
      met.clear();
      std::set<VoxelKey> expected;
      const int keys = *rc::gen::inRange(0, 3000);
      for (int i = 0; i < keys; ++i) {
        const VoxelKey key{*rc::gen::inRange(-9, 10), *rc::gen::inRange(-9, 10), *rc::gen::inRange(-9, 10)};
        RC_ASSERT(met.insert(key) == expected.insert(key).second);
      }
    }
  }));
}

TEST(ScanThinner, KeepsSceneryOnlyOncePerVoxelInRange) {
  const test::MadeScan scan(test::made_yard(), test::straight(1.0), 0.0);
  ScanThinner thinner;
  const SurfaceOdometryConfig config;
  thinner.process(scan.input(), config);
  EXPECT_GT(thinner.samples().size(), 500U);
  EXPECT_GT(thinner.for_map().size(), thinner.samples().size());
  EXPECT_NEAR(thinner.duration_s(), 0.1, 1e-3);
  const Pose T_sensor_base = scan.input().T_base_sensor.inverse();
  std::set<VoxelKey> met;
  for (const ScanPoint& point : thinner.for_map()) {
    const Eigen::Vector3d sensor_m = T_sensor_base * point.base_m;
    EXPECT_GE(sensor_m.norm(), config.min_range_m);
    EXPECT_LE(sensor_m.norm(), config.max_range_m);
    EXPECT_GE(point.share, 0.0);
    EXPECT_LE(point.share, 1.0);
  }
}

TEST(ScanThinner, KeepsTheLimitsAndEveryPartOfTheView) {
  const test::MadeScan scan(test::made_yard(), test::straight(1.0), 0.0);
  ScanThinner thinner;
  thinner.process(scan.input(), {.max_samples = 100.0, .max_map_points = 400.0});
  EXPECT_EQ(thinner.samples().size(), 100U);
  EXPECT_EQ(thinner.for_map().size(), 400U);
  // Rings turn once during a scan: the shares of what is left still cover all of it.
  double widest_gap = thinner.samples().front().share;
  for (std::size_t i = 1; i < thinner.samples().size(); ++i) {
    widest_gap = std::max(widest_gap, thinner.samples()[i].share - thinner.samples()[i - 1].share);
  }
  EXPECT_LT(widest_gap, 0.1);
}

TEST(ScanThinner, PartsTakeEveryPointOnceWithItsTimeInThem) {
  test::MadeScan scan(test::made_yard(), test::straight(1.0), 0.0, 5);
  const SurfaceOdometryConfig config{.map_spacing_m = 0.02, .max_map_points = 100'000.0};
  const std::size_t parts = count_parts(scan.input(), config);
  EXPECT_EQ(parts, 4U) << "of 0.15 s at most";
  scan.channels.time[7] = std::numeric_limits<float>::quiet_NaN();
  ScanThinner thinner;
  thinner.process(scan.input(), config);
  const std::size_t whole = thinner.for_map().size();
  std::size_t in_parts = 0;
  for (std::size_t i = 0; i < parts; ++i) {
    thinner.process(scan.input(), config, {i, parts});
    EXPECT_NEAR(thinner.duration_s(), 0.125, 1e-3);
    in_parts += thinner.for_map().size();
    for (const ScanPoint& point : thinner.for_map()) {
      EXPECT_GE(point.share, 0.0);
      EXPECT_LE(point.share, 1.0);
      EXPECT_NEAR(point.ray.norm(), 1.0F, 1e-5F);
    }
    EXPECT_LT(thinner.for_map().front().share, 0.05);
    EXPECT_GT(thinner.for_map().back().share, 0.95);
  }
  // Each part is thinned by itself, so that a voxel may give a point to several; whole, every other point is looked at.
  EXPECT_GE(in_parts, whole);
}

TEST(ScanThinner, AScanOfATurnOrWithoutTimesIsOnePart) {
  test::MadeScan scan(test::made_yard(), test::straight(1.0), 0.0);
  EXPECT_EQ(count_parts(scan.input(), {}), 1U);
  EXPECT_EQ(count_parts(scan.input(), {.deskew = false}), 1U);
  scan.channels.time.clear();
  EXPECT_EQ(count_parts(scan.input(), {}), 1U);
}

}  // namespace
}  // namespace berm
