#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "berm/core/config.hpp"
#include "berm/core/mount.hpp"
#include "berm/sim/motion.hpp"
#include "berm/sim/weather.hpp"
#include "berm/sim/world_config.hpp"

namespace berm::sim {

struct ScenarioInfo {
  std::string name;
  std::string description;
  std::string sensor = "livox_mid70";
  double seconds = 10.0;

  static void fields(auto&& field) {
    field("name", &ScenarioInfo::name, TextLimit{100}, "short name");
    field("description", &ScenarioInfo::description, TextLimit{1000}, "what it shows");
    field("sensor", &ScenarioInfo::sensor, TextLimit{1000},
          "name of a sensor, or its file, relative to that of the scenario");
    field("seconds", &ScenarioInfo::seconds, Range{0.0, 36000.0}, "how long the recording is");
  }
  void check() const { check_fields(*this, "scenario"); }
};

/// What a file scenarios/NAME.yaml says: a world, a machine with its sensor on its way through it, and the weather.
/// `set_value` and `to_yaml` are those of all settings (berm/io/settings.hpp).
struct Scenario : WorldPlan {
  ScenarioInfo scenario;
  MountConfig mount;
  SnowfallConfig snowfall;
  VehicleConfig vehicle;
  GnssConfig gnss;

  static void sections(auto&& section) {
    section("scenario", &Scenario::scenario);
    section("mount", &Scenario::mount);
    section("vehicle", &Scenario::vehicle);
    section("world", &Scenario::world);
    section("route", &Scenario::route);
    section("piste", &Scenario::piste);
    section("haul_road", &Scenario::haul_road);
    section("paved", &Scenario::paved);
    section("things", &Scenario::things);
    section("traffic", &Scenario::traffic);
    section("dust", &Scenario::dust);
    section("snowfall", &Scenario::snowfall);
    section("gnss", &Scenario::gnss);
  }
  /// Throws ConfigError for the first value that is not allowed.
  void check() const;
};

/// Reads a scenario from the text of a YAML file, every key optional but scenario.name and mount.height_m; `file` is
/// for messages. Throws FileError and ConfigError as `berm::parse_yaml`.
[[nodiscard]] Scenario parse_scenario(std::string_view yaml, const std::string& file);

/// `parse_scenario` of the file's content. Files that it names relative to itself (world.elevation, scenario.sensor)
/// come out relative to the working folder.
[[nodiscard]] Scenario read_scenario(const std::filesystem::path& file);

/// Folders that are searched for scenarios, as `machine_folders`.
[[nodiscard]] std::vector<std::filesystem::path> scenario_folders();

/// Names of the scenarios in `folders`, sorted, each once.
[[nodiscard]] std::vector<std::string> list_scenarios(const std::vector<std::filesystem::path>& folders);

/// The file of a scenario: `name_or_file` itself if it names a file, else the first NAME.yaml in `folders`. Throws
/// ConfigError listing the names that exist.
[[nodiscard]] std::filesystem::path find_scenario(const std::string& name_or_file,
                                                  const std::vector<std::filesystem::path>& folders);

}  // namespace berm::sim
