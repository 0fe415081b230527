#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

#include "berm/core/config.hpp"
#include "berm/core/mount.hpp"
#include "berm/sim/motion.hpp"
#include "berm/sim/sensor.hpp"
#include "berm/sim/weather.hpp"
#include "berm/sim/world_config.hpp"

namespace berm::sim {

struct ScenarioInfo {
  std::string name;
  std::string description;
  std::string sensor = "livox_mid70";  ///< NAME of sensors/NAME.yaml, or a file
  double seconds = 10.0;

  static void fields(auto&& field) {
    field("name", &ScenarioInfo::name, TextLimit{100}, "short name");
    field("description", &ScenarioInfo::description, TextLimit{1000}, "what it shows");
    field("sensor", &ScenarioInfo::sensor, TextLimit{1000}, "name of a sensor, or its file");
    field("seconds", &ScenarioInfo::seconds, Range{0.0, 36000.0}, "how long the recording is");
  }
  void check() const { check_fields(*this, "scenario"); }
};

/// What a file scenarios/NAME.yaml says.
struct Scenario {
  ScenarioInfo scenario;
  MountConfig mount;
  WorldConfig world;
  RouteConfig route;
  PisteConfig piste;
  HaulRoadConfig haul_road;
  ThingsConfig things;
  TrafficConfig traffic;
  SnowfallConfig snowfall;
  DustConfig dust;
  VehicleConfig vehicle;
  GnssConfig gnss;

  static void sections(auto&& section) {
    section("scenario", &Scenario::scenario);
    section("mount", &Scenario::mount);
    section("world", &Scenario::world);
    section("route", &Scenario::route);
    section("piste", &Scenario::piste);
    section("haul_road", &Scenario::haul_road);
    section("things", &Scenario::things);
    section("traffic", &Scenario::traffic);
    section("snowfall", &Scenario::snowfall);
    section("dust", &Scenario::dust);
    section("vehicle", &Scenario::vehicle);
    section("gnss", &Scenario::gnss);
  }
  void check() const;
};

}  // namespace berm::sim
