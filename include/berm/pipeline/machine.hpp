#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "berm/core/config.hpp"
#include "berm/core/mount.hpp"
#include "berm/core/pose_guard.hpp"
#include "berm/edge/ring_edges.hpp"
#include "berm/edge/trace_edges.hpp"
#include "berm/ground/polar_ground.hpp"
#include "berm/ground/terrain_ground.hpp"
#include "berm/io/datum.hpp"
#include "berm/io/pose_log.hpp"
#include "berm/io/settings.hpp"
#include "berm/map/edge_lines.hpp"
#include "berm/map/edge_map.hpp"
#include "berm/map/road_survey.hpp"
#include "berm/map/surface_tiles.hpp"
#include "berm/odometry/feature_odometry.hpp"
#include "berm/odometry/map_localizer.hpp"
#include "berm/odometry/pose_graph.hpp"
#include "berm/odometry/surface_odometry.hpp"
#include "berm/piste/boundary_piste.hpp"
#include "berm/piste/envelope_piste.hpp"
#include "berm/snow/box_snow.hpp"
#include "berm/snow/sparse_snow.hpp"

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

/// Which method does each stage.
struct MethodConfig {
  std::string snow = "default";
  std::string ground = "default";
  std::string piste = "none";
  std::string edge = "none";
  std::string odometry = "none";

  static void fields(auto&& field) {
    field("snow", &MethodConfig::snow, Choices{{"none", "default", "reference"}},
          "default finds flakes by what surrounds them, reference is method P as published");
    field("ground", &MethodConfig::ground, Choices{{"default", "reference"}},
          "default follows the terrain, reference is method G as published");
    field("piste", &MethodConfig::piste, Choices{{"none", "default", "reference"}},
          "default finds the piste by its boundary, reference is method P as published");
    field("edge", &MethodConfig::edge, Choices{{"none", "default", "reference"}},
          "default finds the edges of a road by the traces of the beams, reference is method E as published");
    field("odometry", &MethodConfig::odometry, Choices{{"none", "default", "reference"}},
          "default finds where the machine is by the surfaces around it, reference is method P as published");
  }
  void check() const { check_fields(*this, "methods"); }
};

/// A machine with its sensor and the configuration of every stage: what a file machines/NAME.yaml says. `set_value`
/// and `to_yaml` are those of all settings.
struct Machine {
  MachineInfo machine;
  SensorConfig sensor;
  MountConfig mount;
  MethodConfig methods;
  SparseSnowConfig snow;
  BoxSnowConfig snow_reference;
  TerrainGroundConfig ground;
  PolarGroundConfig ground_reference;
  BoundaryPisteConfig piste;
  EnvelopePisteConfig piste_reference;
  TraceEdgesConfig edge;
  RingEdgesConfig edge_reference;
  SurfaceOdometryConfig odometry;
  FeatureOdometryConfig odometry_reference;
  PoseGraphConfig pose_graph;
  MapLocalizerConfig localize;
  EdgeMapConfig map;
  EdgeLinesConfig lines;
  RoadConfig road;
  SurfaceMapConfig mapping;
  PoseLogConfig poses;
  GnssMountConfig gnss;
  PoseGuardConfig pose_guard;
  DatumConfig datum;

  static void sections(auto&& section) {
    section("machine", &Machine::machine);
    section("sensor", &Machine::sensor);
    section("mount", &Machine::mount);
    section("methods", &Machine::methods);
    section("snow", &Machine::snow);
    section("snow_reference", &Machine::snow_reference);
    section("ground", &Machine::ground);
    section("ground_reference", &Machine::ground_reference);
    section("piste", &Machine::piste);
    section("piste_reference", &Machine::piste_reference);
    section("edge", &Machine::edge);
    section("edge_reference", &Machine::edge_reference);
    section("odometry", &Machine::odometry);
    section("odometry_reference", &Machine::odometry_reference);
    section("pose_graph", &Machine::pose_graph);
    section("localize", &Machine::localize);
    section("map", &Machine::map);
    section("lines", &Machine::lines);
    section("road", &Machine::road);
    section("mapping", &Machine::mapping);
    section("poses", &Machine::poses);
    section("gnss", &Machine::gnss);
    section("pose_guard", &Machine::pose_guard);
    section("datum", &Machine::datum);
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
