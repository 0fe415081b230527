#include "level_plane.hpp"

#include <algorithm>
#include <cmath>
#include <random>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "berm/core/angle.hpp"
#include "ground/ground_cases.hpp"

namespace berm {
namespace {

using Eigen::Vector3d;
using Eigen::Vector3f;

constexpr double kHeight_m = 2.0;

struct Miss {
  double angle_deg;
  double height_m;
};

/// The ground is the plane z = 0 of the world: how far off is what was found?
Miss miss_of(const LevelPlane& plane, const Pose& T_world_sensor) {
  const Vector3d up_sensor = T_world_sensor.rotation().conjugate() * Vector3d::UnitZ();
  const Vector3d found_sensor = plane.T_level_sensor.rotation().conjugate() * Vector3d::UnitZ();
  const double cosine = std::min(1.0, up_sensor.dot(found_sensor));
  return {std::acos(cosine) / kRadPerDeg,
          std::fabs(plane.T_level_sensor.translation_m().z() - T_world_sensor.translation_m().z())};
}

Pose tilted(double pitch_deg, double roll_deg, double height_m = kHeight_m) {
  return Pose::from_yaw_pitch_roll(0.0, pitch_deg * kRadPerDeg, roll_deg * kRadPerDeg, {0.0, 0.0, height_m});
}

/// Within 1 deg and 5 cm, unless more is allowed.
void expect_found(const LevelPlane& plane, const Pose& T_world_sensor, const std::string& what,
                  const Miss& allowed = {.angle_deg = 1.0, .height_m = 0.05}) {
  const Miss miss = miss_of(plane, T_world_sensor);
  EXPECT_TRUE(plane.found) << what;
  EXPECT_LT(miss.angle_deg, allowed.angle_deg) << what;
  EXPECT_LT(miss.height_m, allowed.height_m) << what;
}

const test::Beams& spinner() {
  static const test::Beams beams = test::spinning_beams(32, -30.0, 10.0, 600);
  return beams;
}

LevelPlane find(const PointCloud& cloud, const Pose& T_base_sensor, const TerrainGroundConfig& config = {}) {
  LevelPlaneFinder finder;
  return finder.find(cloud.view(), T_base_sensor, config);
}

TEST(LevelPlane, IsFoundUnderATiltUpTo45DegreesWithoutBeingTold) {
  const test::World world = test::flat_street().world;
  for (const double tilt_deg : {0.0, 5.0, 15.0, 30.0, 45.0}) {
    for (const double sign : {-1.0, 1.0}) {
      for (const bool pitch : {false, true}) {
        const Pose T_world_sensor = pitch ? tilted(sign * tilt_deg, 0.0) : tilted(0.0, sign * tilt_deg);
        const test::MadeScan scan = test::cast(world, spinner(), T_world_sensor);
        // At 45 deg this sensor sees ground on one side only, and between cars.
        const Miss allowed = tilt_deg < 40.0 ? Miss{1.0, 0.05} : Miss{2.5, 0.1};
        expect_found(find(scan.cloud, test::mount(kHeight_m)), T_world_sensor,
                     (pitch ? "pitch " : "roll ") + std::to_string(sign * tilt_deg), allowed);
      }
    }
  }
}

TEST(LevelPlane, IsNotLookedForBeyondTheTiltThatIsAllowed) {
  TerrainGroundConfig config;
  config.max_tilt_deg = 20.0;
  const Pose T_world_sensor = tilted(35.0, 0.0);
  const test::MadeScan scan = test::cast(test::flat_street().world, spinner(), T_world_sensor);
  EXPECT_GT(miss_of(find(scan.cloud, test::mount(kHeight_m), config), T_world_sensor).angle_deg, 10.0);
  // The mount that knows of the tilt needs none to be allowed.
  expect_found(find(scan.cloud, T_world_sensor, config), T_world_sensor, "told by the mount");
}

TEST(LevelPlane, MakesAFrameOnThePlaneWithXTowardsTheSensorsX) {
  const Pose T_world_sensor = tilted(20.0, 10.0);
  const test::MadeScan scan = test::cast(test::World{}, spinner(), T_world_sensor);
  const LevelPlane plane = find(scan.cloud, test::mount(kHeight_m));
  const Vector3d x_level = plane.T_level_sensor.rotation() * Vector3d::UnitX();
  EXPECT_NEAR(x_level.y(), 0.0, 1e-9);
  EXPECT_GT(x_level.x(), 0.9);
  EXPECT_NEAR(plane.T_level_sensor.translation_m().x(), 0.0, 1e-9);
  EXPECT_NEAR(plane.T_level_sensor.translation_m().y(), 0.0, 1e-9);
  EXPECT_LT(plane.rms_m, 0.05);
}

TEST(LevelPlane, KnowsTheBlindSpotAroundTheSensor) {
  // The lowest beam of 30 deg meets the ground at 2 / tan 30 deg = 3.46 m; cells of 2 m blur that.
  const test::MadeScan scan = test::cast(test::World{}, spinner(), tilted(0.0, 0.0));
  EXPECT_NEAR(find(scan.cloud, test::mount(kHeight_m)).nearest_m, 3.46, 0.5);
}

TEST(LevelPlane, IsFoundAmong30PercentClutter) {
  std::mt19937 random(11);
  std::uniform_real_distribution<float> unit(0.0F, 1.0F);
  for (const double tilt_deg : {0.0, 25.0}) {
    const Pose T_world_sensor = tilted(tilt_deg, -0.5 * tilt_deg);
    const Pose T_sensor_world = T_world_sensor.inverse();
    const test::MadeScan scan = test::cast(test::flat_street().world, spinner(), T_world_sensor);
    std::vector<Vector3f> points = test::points_of(scan.cloud.view());
    for (Vector3f& p : points) {
      if (unit(random) < 0.3F) {
        // Anywhere within 20 m up to 4 m, and one in 500 below the ground as reflections are.
        const double low_m = unit(random) < 0.002F ? -2.0 : 0.0;
        const Vector3d place(40.0 * static_cast<double>(unit(random)) - 20.0,
                             40.0 * static_cast<double>(unit(random)) - 20.0,
                             low_m + 4.0 * static_cast<double>(unit(random)));
        p = (T_sensor_world * place).cast<float>();
      }
    }
    // Where no ground is seen the lowest clutter lies a little above it and lifts and turns the plane.
    expect_found(find(test::cloud_of(points), test::mount(kHeight_m)), T_world_sensor, std::to_string(tilt_deg),
                 {.angle_deg = 1.5, .height_m = 0.25});
  }
}

TEST(LevelPlane, IsFoundWithALimitedFieldOfView) {
  const test::Beams beams = test::rosette_beams(70.4, 10000);
  for (const double pitch_deg : {0.0, 11.0, 30.0}) {
    for (const double roll_deg : {-20.0, 0.0, 20.0}) {
      const Pose T_world_sensor = tilted(pitch_deg, roll_deg, 2.3);
      const test::MadeScan scan = test::cast(test::flat_street().world, beams, T_world_sensor);
      expect_found(find(scan.cloud, test::mount(2.3)), T_world_sensor,
                   std::to_string(pitch_deg) + " " + std::to_string(roll_deg));
    }
  }
}

TEST(LevelPlane, HardlyMindsAWrongMountHeight) {
  for (const double tilt_deg : {0.0, 20.0}) {
    const Pose T_world_sensor = tilted(tilt_deg, 0.0);
    const test::MadeScan scan = test::cast(test::flat_street().world, spinner(), T_world_sensor);
    for (const double share : {0.0, 0.7, 1.4, 2.0}) {  // off by half of itself, or unknown
      expect_found(find(scan.cloud, test::mount(share * kHeight_m)), T_world_sensor,
                   "mount height times " + std::to_string(share) + ", tilt " + std::to_string(tilt_deg));
    }
  }
}

TEST(LevelPlane, FallsBackToTheMountWithTooFewPoints) {
  const Pose T_base_sensor = tilted(12.0, 3.0, 1.4);
  for (const int count : {0, 1, 5, 9}) {
    std::vector<Vector3f> points;
    for (int i = 0; i < count; ++i) {
      points.emplace_back(5.0F, 2.5F * static_cast<float>(i - 4), -1.0F);
    }
    const LevelPlane plane = find(test::cloud_of(points), T_base_sensor);
    EXPECT_FALSE(plane.found) << count;
    const Miss miss = miss_of(plane, T_base_sensor);
    EXPECT_LT(miss.angle_deg, 1e-4) << count;
    EXPECT_LT(miss.height_m, 1e-12) << count;
  }
}

TEST(LevelPlane, IsThatOfTheMountWhereLevellingIsOff) {
  TerrainGroundConfig config;
  config.level = false;
  const test::MadeScan scan = test::cast(test::flat_street().world, spinner(), tilted(20.0, 0.0));
  const LevelPlane plane = find(scan.cloud, test::mount(kHeight_m), config);
  EXPECT_FALSE(plane.found);
  EXPECT_LT(miss_of(plane, test::mount(kHeight_m)).angle_deg, 1e-4);
}

TEST(LevelPlane, RemembersNothingOfTheScanBefore) {
  const test::MadeScan scan = test::cast(test::flat_street().world, spinner(), tilted(10.0, 0.0));
  const test::MadeScan other = test::cast(test::World{}, spinner(), tilted(0.0, 30.0, 4.0));
  LevelPlaneFinder finder;
  const LevelPlane first = finder.find(scan.cloud.view(), test::mount(kHeight_m), {});
  (void)finder.find(other.cloud.view(), test::mount(kHeight_m), {});
  const LevelPlane again = finder.find(scan.cloud.view(), test::mount(kHeight_m), {});
  EXPECT_EQ(first.T_level_sensor.matrix(), again.T_level_sensor.matrix());
  EXPECT_EQ(first.rms_m, again.rms_m);
  EXPECT_EQ(first.nearest_m, again.nearest_m);
}

}  // namespace
}  // namespace berm
