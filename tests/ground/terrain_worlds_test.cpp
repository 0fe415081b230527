#include <algorithm>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "berm/ground/terrain_ground.hpp"
#include "ground/ground_cases.hpp"

// How much of the ground of made worlds is found by each kind of sensor. The floors lie a little below what was
// measured over three seeds; they say what the method is worth there, not what one would wish.

namespace berm {
namespace {

using test::Sensor;
using test::Terrain;

/// F1 of one scan.
double f1_of(TerrainGround& ground, const Sensor& sensor, const Terrain& terrain, std::uint32_t seed = 1) {
  const test::MadeScan scan = sensor.look(terrain.world, seed);
  const GroundResult result = ground.process(scan.cloud.view(), sensor.T_base_sensor());
  EXPECT_TRUE(test::counts_add_up(result, scan.cloud.size())) << terrain.name;
  return test::ground_f1(result, scan);
}

void expect_floors(const Sensor& sensor, const std::map<std::string, double>& floors) {
  TerrainGround ground({});
  for (const Terrain& terrain : test::all_terrains()) {
    const double f1 = std::min(f1_of(ground, sensor, terrain, 1), f1_of(ground, sensor, terrain, 2));
    ::testing::Test::RecordProperty(terrain.name, std::to_string(f1));
    EXPECT_GT(f1, floors.at(terrain.name)) << sensor.name << ", " << terrain.name;
  }
}

TEST(TerrainWorlds, AreFoundBy64Rings) {
  expect_floors(test::rings_64(), {{"flat street", 0.99},
                                   {"slope along", 0.99},
                                   {"slope across", 0.99},
                                   {"bowl", 0.99},
                                   {"crest", 0.985},
                                   {"rolling hills", 0.98},
                                   {"ditch", 0.93},
                                   {"rough ground", 0.99}});
}

TEST(TerrainWorlds, AreFoundBy16Rings) {
  expect_floors(test::rings_16(), {{"flat street", 0.97},
                                   {"slope along", 0.98},
                                   {"slope across", 0.98},
                                   {"bowl", 0.87},
                                   {"crest", 0.84},
                                   {"rolling hills", 0.88},
                                   {"ditch", 0.89},
                                   {"rough ground", 0.965}});
}

TEST(TerrainWorlds, AreFoundByARosetteOf70Degrees) {
  expect_floors(test::rosette(), {{"flat street", 0.99},
                                  {"slope along", 0.99},
                                  {"slope across", 0.99},
                                  {"bowl", 0.965},
                                  {"crest", 0.98},
                                  {"rolling hills", 0.98},
                                  {"ditch", 0.97},
                                  {"rough ground", 0.935}});
}

TEST(TerrainWorlds, LabelsAreAsGoodWhenTheCloudIsTilted) {
  const Sensor sensor = test::rings_64();
  TerrainGround ground({});
  for (const Terrain& terrain : test::all_terrains()) {
    const test::MadeScan scan = sensor.look(terrain.world);
    const double level = test::ground_f1(ground.process(scan.cloud.view(), sensor.T_base_sensor()), scan);
    for (const auto& [pitch_deg, roll_deg] : {std::pair{10.0, 0.0}, {20.0, 0.0}, {0.0, 15.0}, {-10.0, -15.0}}) {
      const PointCloud tilted = test::turned(scan.cloud.view(), 0.0, pitch_deg, roll_deg);
      const double f1 = test::ground_f1(ground.process(tilted.view(), sensor.T_base_sensor()), scan);
      EXPECT_GT(f1, level - 0.003) << terrain.name << ", pitch " << pitch_deg << ", roll " << roll_deg;
    }
  }
}

TEST(TerrainWorlds, AWrongMountHeightHardlyMatters) {
  const Sensor sensor = test::rings_64();
  TerrainGround ground({});
  for (const Terrain& terrain : test::all_terrains()) {
    const test::MadeScan scan = sensor.look(terrain.world);
    const double right = test::ground_f1(ground.process(scan.cloud.view(), sensor.T_base_sensor()), scan);
    for (const double share : {0.0, 0.7, 1.4, 2.0}) {
      const Pose wrong = test::mount(share * sensor.height_m);
      const double f1 = test::ground_f1(ground.process(scan.cloud.view(), wrong), scan);
      EXPECT_GT(f1, right - 0.003) << terrain.name << ", mount height times " << share;
    }
  }
}

TEST(TerrainWorlds, EachStepIsWorthSomething) {
  const Sensor sensor = test::rings_64();
  const auto mean_with = [&sensor](const TerrainGroundConfig& config) {
    TerrainGround ground(config);
    double sum = 0.0;
    for (const Terrain& terrain : test::all_terrains()) {
      sum += f1_of(ground, sensor, terrain);
    }
    return sum / 8.0;
  };
  const double full = mean_with({});
  const auto worth_of = [&](bool TerrainGroundConfig::*step) {
    TerrainGroundConfig config;
    config.*step = false;
    return full - mean_with(config);
  };
  EXPECT_GT(worth_of(&TerrainGroundConfig::level), 0.05);
  EXPECT_GT(worth_of(&TerrainGroundConfig::follow), 0.05);
  EXPECT_GT(worth_of(&TerrainGroundConfig::smooth), 0.0005);
  EXPECT_GT(worth_of(&TerrainGroundConfig::strict_at_objects), 0.001);
}

}  // namespace
}  // namespace berm
