#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "berm/core/config.hpp"
#include "berm/core/pose.hpp"
#include "berm/ground/polar_ground.hpp"
#include "berm/ground/terrain_ground.hpp"

namespace berm {

struct MachineInfo {
  std::string name;
  std::string description;

  static void fields(auto&& field) {
    field("name", &MachineInfo::name, TextLimit{100}, "short name");
    field("description", &MachineInfo::description, TextLimit{1000}, "what it is, and which values are assumed");
  }
  void check() const { check_fields(*this, "machine"); }
};

struct SensorConfig {
  std::string model;
  double scan_hz = 10.0;

  static void fields(auto&& field) {
    field("model", &SensorConfig::model, TextLimit{100}, "maker and model");
    field("scan_hz", &SensorConfig::scan_hz, Range{0.1, 100.0},
          "scans per second; a recording of another rate is noted");
  }
  void check() const { check_fields(*this, "sensor"); }
};

/// Where the sensor sits: base_link is on the ground under the origin of the machine, x forward, y left, z up.
struct MountConfig {
  double height_m = 0.0;
  double pitch_deg = 0.0;
  double roll_deg = 0.0;
  double yaw_deg = 0.0;
  double x_m = 0.0;
  double y_m = 0.0;

  static void fields(auto&& field) {
    field("height_m", &MountConfig::height_m, Range{0.0, 50.0}, "height of the sensor above the ground");
    field("pitch_deg", &MountConfig::pitch_deg, Range{-180.0, 180.0}, "nose down is positive");
    field("roll_deg", &MountConfig::roll_deg, Range{-180.0, 180.0},
          "right side down is positive; 180 hangs it upside down");
    field("yaw_deg", &MountConfig::yaw_deg, Range{-180.0, 180.0}, "turned to the left is positive");
    field("x_m", &MountConfig::x_m, Range{-50.0, 50.0}, "forward of base_link");
    field("y_m", &MountConfig::y_m, Range{-50.0, 50.0}, "left of base_link");
  }
  void check() const { check_fields(*this, "mount"); }

  [[nodiscard]] Pose T_base_sensor() const;
};

/// Which method does each stage.
struct MethodConfig {
  std::string ground = "default";

  static void fields(auto&& field) {
    field("ground", &MethodConfig::ground, Choices{{"default", "reference"}},
          "default follows the terrain, reference is method G as published");
  }
  void check() const { check_fields(*this, "methods"); }
};

/// A machine with its sensor and the configuration of every stage: what a file machines/NAME.yaml says.
struct Machine {
  MachineInfo machine;
  SensorConfig sensor;
  MountConfig mount;
  MethodConfig methods;
  TerrainGroundConfig ground;
  PolarGroundConfig ground_reference;

  static void sections(auto&& section) {
    section("machine", &Machine::machine);
    section("sensor", &Machine::sensor);
    section("mount", &Machine::mount);
    section("methods", &Machine::methods);
    section("ground", &Machine::ground);
    section("ground_reference", &Machine::ground_reference);
  }
  /// Throws ConfigError for the first value that is not allowed.
  void check() const;
};

/// Reads a machine from the text of a YAML file: sections of `key: value`, every key optional but machine.name,
/// sensor.model and mount.height_m. `file` is for messages. Throws FileError if the text is no such file, and
/// ConfigError with line and key for an unknown or repeated key, a wrong type, or a value that is not allowed.
[[nodiscard]] Machine parse_machine(std::string_view yaml, const std::string& file);

/// `parse_machine` of the file's content. Files above 64 KiB are refused.
[[nodiscard]] Machine read_machine(const std::filesystem::path& file);

/// Sets one value from text like "ground.min_range_m=3", as strictly as a file would; returns the key that was set.
/// `where` names the origin in messages, such as "--set ground.min_range_m=3". Whether the values fit each other is
/// left to `Machine::check`, since more may follow.
std::string set_value(Machine& machine, std::string_view assignment, const std::string& where);

/// The machine as a YAML file with every key, its meaning and what is allowed; `parse_machine` reads it back.
[[nodiscard]] std::string to_yaml(const Machine& machine);

/// Folders that are searched for NAME.yaml, in this order: ./machines, then share/berm/machines beside the program
/// and one level above it (installed).
[[nodiscard]] std::vector<std::filesystem::path> machine_folders();

/// Names of the machines in `folders`, sorted, each once.
[[nodiscard]] std::vector<std::string> list_machines(const std::vector<std::filesystem::path>& folders);

/// The file of a machine: `name_or_file` itself if it names a file (it holds a slash or ends in .yaml or .yml), else
/// the first NAME.yaml in `folders`. Throws ConfigError listing the names that exist.
[[nodiscard]] std::filesystem::path find_machine(const std::string& name_or_file,
                                                 const std::vector<std::filesystem::path>& folders);

}  // namespace berm
