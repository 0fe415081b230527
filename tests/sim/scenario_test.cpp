#include "berm/sim/scenario.hpp"

#include <set>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "berm/core/error.hpp"
#include "berm/io/settings.hpp"
#include "berm/sim/sensor.hpp"
#include "support/temp_folder.hpp"

namespace berm::sim {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

constexpr const char* kSmallest = "scenario:\n  name: small\nmount:\n  height_m: 2\n";

std::string error_of(const std::string& yaml) {
  try {
    static_cast<void>(parse_scenario(yaml, "s.yaml"));
  } catch (const Error& error) {
    return error.what();
  }
  return "no error";
}

TEST(Scenario, SmallestFileLeavesTheRestAtDefaults) {
  const Scenario scenario = parse_scenario(kSmallest, "s.yaml");
  EXPECT_EQ(scenario.scenario.name, "small");
  EXPECT_EQ(scenario.mount.height_m, 2.0);
  EXPECT_EQ(scenario.vehicle.speed_m_per_s, VehicleConfig{}.speed_m_per_s);
  EXPECT_EQ(scenario.world.kind, "piste");
}

TEST(Scenario, WhatIsPrintedReadsBackTheSame) {
  Scenario scenario = parse_scenario(kSmallest, "s.yaml");
  set_value(scenario, "world.kind=haul_road", "--set");
  set_value(scenario, "snowfall.flakes_per_m3=1234.5", "--set");
  set_value(scenario, "traffic.parked=7", "--set");
  set_value(scenario, "things.lift=false", "--set");
  const std::string yaml = to_yaml(scenario);
  const Scenario again = parse_scenario(yaml, "s.yaml");
  EXPECT_EQ(to_yaml(again), yaml);
  EXPECT_EQ(again.world.kind, "haul_road");
  EXPECT_EQ(again.snowfall.flakes_per_m3, 1234.5);
  EXPECT_EQ(again.traffic.parked, 7);
  EXPECT_FALSE(again.things.lift);
}

TEST(Scenario, NonsenseIsRefusedWithItsPlace) {
  EXPECT_THAT(error_of("scenario:\n  name: x\n"), HasSubstr("mount.height_m: is missing"));
  EXPECT_THAT(error_of("mount:\n  height_m: 2\n"), HasSubstr("scenario.name: is missing"));
  EXPECT_THAT(
      error_of(std::string(kSmallest) + "vehicle:\n  sped_m_per_s: 2\n"),
      testing::AllOf(HasSubstr("s.yaml: line 6: vehicle.sped_m_per_s"), HasSubstr("did you mean 'speed_m_per_s'")));
  EXPECT_THAT(error_of(std::string(kSmallest) + "weather:\n  snow: 2\n"), HasSubstr("unknown section"));
  EXPECT_THAT(error_of(std::string(kSmallest) + "world:\n  kind: moon\n"),
              HasSubstr("expected piste, haul_road, flat_road or car_park"));
  EXPECT_THAT(error_of(std::string(kSmallest) + "vehicle:\n  speed_m_per_s: fast\n"), HasSubstr("expected a number"));
  EXPECT_THAT(error_of(std::string(kSmallest) + "vehicle:\n  speed_m_per_s: -1\n"), HasSubstr("-1 is not allowed"));
  EXPECT_THAT(error_of(std::string(kSmallest) + "snowfall:\n  flakes_per_m3: .nan\n"), HasSubstr("snowfall"));
  EXPECT_THAT(error_of(std::string(kSmallest) + "route:\n  min_gradient_deg: 20\n  max_gradient_deg: 10\n"),
              HasSubstr("route.min_gradient_deg"));
  EXPECT_THAT(error_of("just text"), HasSubstr("expected sections such as 'scenario:'"));
}

TEST(Scenario, FilesAreRelativeToTheScenario) {
  const test::TempFolder folder;
  fs::create_directories(folder / "mine");
  test::spill(folder / "mine/s.yaml",
              "scenario:\n  name: s\n  sensor: sensors/my.yaml\nmount:\n  height_m: 2\n"
              "world:\n  elevation: ../dem.asc\n");
  const Scenario scenario = read_scenario(folder / "mine/s.yaml");
  EXPECT_EQ(scenario.world.elevation, (folder / "dem.asc").string());
  EXPECT_EQ(scenario.scenario.sensor, (folder / "mine/sensors/my.yaml").string());
  test::spill(folder / "mine/s.yaml",
              "scenario:\n  name: s\n  sensor: vlp16\nmount:\n  height_m: 2\n"
              "world:\n  elevation: /dem.asc\n");
  EXPECT_EQ(read_scenario(folder / "mine/s.yaml").scenario.sensor, "vlp16");
  EXPECT_EQ(read_scenario(folder / "mine/s.yaml").world.elevation, "/dem.asc");
}

/// Machines whose mounts the scenarios have to share.
std::string machine_of(const std::string& scenario) {
  if (scenario.starts_with("groomer")) {
    return "groomer";
  }
  return scenario.starts_with("haul_road") ? "haul_truck" : "car";
}

TEST(Scenario, ThoseThatComeWithBermAreWhole) {
  const fs::path root = BERM_SOURCE_FOLDER;
  const auto names = list_scenarios({root / "scenarios"});
  const std::set<std::string> known(names.begin(), names.end());
  for (const char* name : {"groomer_snowfall", "groomer_clear", "groomer_forks", "groomer_night_storm", "haul_road",
                           "haul_road_dust", "flat_road", "car_park"}) {
    EXPECT_TRUE(known.contains(name)) << name;
  }
  for (const std::string& name : names) {
    SCOPED_TRACE(name);
    const Scenario scenario = read_scenario(find_scenario(name, {root / "scenarios"}));
    EXPECT_EQ(scenario.scenario.name, name);
    EXPECT_GT(scenario.scenario.description.size(), 20U);
    EXPECT_NO_THROW(read_sensor(find_sensor(scenario.scenario.sensor, {root / "sensors"})));
    // The mount, as it stands in the file of the machine.
    const std::string machine = test::slurp(root / "machines" / (machine_of(name) + ".yaml"));
    const auto value = [&machine](const std::string& key) {
      return std::stod(machine.substr(machine.find(key + ": ") + key.size() + 2));
    };
    EXPECT_EQ(scenario.mount.height_m, value("height_m"));
    EXPECT_EQ(scenario.mount.pitch_deg, value("pitch_deg"));
    EXPECT_EQ(scenario.mount.roll_deg, value("roll_deg"));
    EXPECT_EQ(scenario.mount.yaw_deg, value("yaw_deg"));
  }
}

}  // namespace
}  // namespace berm::sim
