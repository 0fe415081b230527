#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "berm/core/config.hpp"

namespace berm::sim {

struct SensorInfo {
  std::string name;
  std::string description;

  static void fields(auto&& field) {
    field("name", &SensorInfo::name, TextLimit{100}, "maker and model");
    field("description", &SensorInfo::description, TextLimit{1000}, "where its figures come from");
  }
  void check() const { check_fields(*this, "sensor"); }
};

/// In which directions the beams go, and when. Three kinds:
///
/// - spinning: columns of lasers on a head that turns `scan_hz` times a second.
/// - rosette: one laser behind two prisms that turn at speeds of their own (Livox Mid-40, Mid-70).
/// - swirl: a fan of lasers that a fast mirror throws around while a slow one tilts it (Livox Mid-360).
struct PatternConfig {
  std::string kind = "spinning";
  double scan_hz = 10.0;

  // Spinning.
  std::string elevations_deg;
  std::string azimuth_offsets_deg;
  double column_s = 0.0;
  double firing_s = 0.0;
  int lasers_at_once = 1;
  bool clockwise = true;

  // Rosette and swirl.
  double points_per_s = 100'000.0;

  // Rosette. Speeds as fitted to the recording of a Mid-40, docs/simulator.md.
  double field_of_view_deg = 70.4;
  double prism_hz = -122.306;
  double prism_ratio = -0.639332;
  double prism_share = 0.5;

  // Swirl. Fitted to a scan of a Mid-360, docs/simulator.md.
  double min_elevation_deg = -7.0;
  double max_elevation_deg = 52.0;
  double turn_hz = 182.1;
  double sweep_hz = 9.85;
  int fan_lasers = 4;
  double fan_height_deg = 4.55;
  double fan_width_deg = 6.46;

  static void fields(auto&& field) {
    field("kind", &PatternConfig::kind, Choices{{"spinning", "rosette", "swirl"}}, "how the beams move");
    field("scan_hz", &PatternConfig::scan_hz, Range{0.1, 100.0}, "scans per second; turns of the head if it spins");
    field("elevations_deg", &PatternConfig::elevations_deg, TextLimit{4000},
          "spinning: elevation of every laser in firing order, separated by blanks");
    field("azimuth_offsets_deg", &PatternConfig::azimuth_offsets_deg, TextLimit{4000},
          "spinning: what every laser looks to the left of the head, same order; empty for none");
    field("column_s", &PatternConfig::column_s, Range{0.0, 1.0}, "spinning: from one firing of all lasers to the next");
    field("firing_s", &PatternConfig::firing_s, Range{0.0, 1.0},
          "spinning: from one laser, or group of lasers, to the next within a column");
    field("lasers_at_once", &PatternConfig::lasers_at_once, Range{1.0, 1000.0},
          "spinning: how many neighbours in the firing order fire together");
    field("clockwise", &PatternConfig::clockwise, "spinning: which way it turns, seen from above");
    field("points_per_s", &PatternConfig::points_per_s, Range{1.0, 1e7}, "rosette, swirl: beams per second");
    field("field_of_view_deg", &PatternConfig::field_of_view_deg, Range{0.1, 170.0},
          "rosette: diameter of the circle that it fills");
    field("prism_hz", &PatternConfig::prism_hz, Range{-10'000.0, 10'000.0}, "rosette: turns per second of prism one");
    field("prism_ratio", &PatternConfig::prism_ratio, Range{-100.0, 100.0},
          "rosette: speed of prism two over that of prism one; negative turns against it");
    field("prism_share", &PatternConfig::prism_share, Range{0.01, 0.99},
          "rosette: deflection by prism one over that by both; apart from 0.5 a hole stays in the middle");
    field("min_elevation_deg", &PatternConfig::min_elevation_deg, Range{-90.0, 90.0}, "swirl: lower end of the view");
    field("max_elevation_deg", &PatternConfig::max_elevation_deg, Range{-90.0, 90.0}, "swirl: upper end of the view");
    field("turn_hz", &PatternConfig::turn_hz, Range{0.1, 10'000.0}, "swirl: turns per second of the fast mirror");
    field("sweep_hz", &PatternConfig::sweep_hz, Range{0.001, 1000.0}, "swirl: tilts per second, up and down");
    field("fan_lasers", &PatternConfig::fan_lasers, Range{1.0, 128.0}, "swirl: lasers that fire in turn");
    field("fan_height_deg", &PatternConfig::fan_height_deg, Range{0.0, 60.0},
          "swirl: from the first to the last of these lasers where they stand upright");
    field("fan_width_deg", &PatternConfig::fan_width_deg, Range{0.0, 60.0},
          "swirl: the same a quarter of a turn later, where they lie side by side");
  }
  /// Throws ConfigError for the first value that is not allowed, or that does not fit the others.
  void check() const;
};

/// What becomes of a beam on its way and in the receiver.
struct OpticsConfig {
  double min_range_m = 0.5;
  double max_range_m = 200.0;
  double range_at_10_percent_m = 90.0;
  double near_field_m = 2.0;
  double range_noise_m = 0.02;
  double range_quantum_m = 0.0;
  double aperture_m = 0.01;
  double divergence_x_mrad = 3.0;
  double divergence_y_mrad = 3.0;
  double reflectivity_scale = 1.0;
  double weak_echo_reflectivity = 1.0;
  double echo_separation_m = 1.0;
  std::string echo = "strongest";
  double dropout = 0.001;
  bool keeps_no_returns = true;

  static void fields(auto&& field) {
    field("min_range_m", &OpticsConfig::min_range_m, Range{0.0, 100.0}, "nothing nearer is reported");
    field("max_range_m", &OpticsConfig::max_range_m, Range{1.0, 10'000.0}, "nothing farther is reported");
    field("range_at_10_percent_m", &OpticsConfig::range_at_10_percent_m, Range{1.0, 10'000.0},
          "where half of the beams on a surface of 10 % reflectivity come back");
    field("near_field_m", &OpticsConfig::near_field_m, Range{0.0, 100.0},
          "below it the receiver loses light: its view does not overlap the beam, and it is less sensitive at once "
          "after the shot");
    field("range_noise_m", &OpticsConfig::range_noise_m, Range{0.0, 1.0}, "standard deviation at good signal");
    field("range_quantum_m", &OpticsConfig::range_quantum_m, Range{0.0, 1.0}, "step of the reported range; 0: none");
    field("aperture_m", &OpticsConfig::aperture_m, Range{0.0, 0.5}, "diameter of the beam where it leaves the sensor");
    field("divergence_x_mrad", &OpticsConfig::divergence_x_mrad, Range{0.0, 100.0}, "full width of the beam, across");
    field("divergence_y_mrad", &OpticsConfig::divergence_y_mrad, Range{0.0, 100.0}, "full width of the beam, upwards");
    field("reflectivity_scale", &OpticsConfig::reflectivity_scale, Range{0.001, 100.0},
          "what is reported, 0..255, over the reflectivity in percent");
    field("weak_echo_reflectivity", &OpticsConfig::weak_echo_reflectivity, Range{0.0, 50.0},
          "what echoes of next to no reflectivity are reported with, on average");
    field("echo_separation_m", &OpticsConfig::echo_separation_m, Range{0.0, 10.0},
          "echoes that are nearer to each other melt into one between them");
    field("echo", &OpticsConfig::echo, Choices{{"strongest", "first", "last"}}, "which echo of a beam is reported");
    field("dropout", &OpticsConfig::dropout, Range{0.0, 1.0}, "share of beams that are lost for no reason");
    field("keeps_no_returns", &OpticsConfig::keeps_no_returns,
          "beams without echo are points (0, 0, 0) instead of missing");
  }
  void check() const;

  /// Received light at which half of the echoes are found, in the unit of `received_light`.
  [[nodiscard]] double detection_limit() const;
};

/// Light that comes back from `range_m`: reflectivity 0..1 times the share of the beam that meets it, over the square
/// of the range, less what the receiver loses in the near field. The one scale for surfaces, flakes and dust.
[[nodiscard]] double received_light(const OpticsConfig& optics, double reflectivity, double share, double range_m);

/// A sensor: what a file sensors/NAME.yaml says.
struct Sensor {
  SensorInfo sensor;
  PatternConfig pattern;
  OpticsConfig optics;

  static void sections(auto&& section) {
    section("sensor", &Sensor::sensor);
    section("pattern", &Sensor::pattern);
    section("optics", &Sensor::optics);
  }
  void check() const;
};

/// Reads a sensor from the text of a YAML file; `file` is for messages. Throws FileError and ConfigError as
/// `berm::parse_yaml`.
[[nodiscard]] Sensor parse_sensor(std::string_view yaml, const std::string& file);

/// `parse_sensor` of the file's content.
[[nodiscard]] Sensor read_sensor(const std::filesystem::path& file);

/// Folders that are searched for sensors, as `machine_folders`.
[[nodiscard]] std::vector<std::filesystem::path> sensor_folders();

/// The file of a sensor: `name_or_file` itself if it names a file, else the first NAME.yaml in `folders`. Throws
/// ConfigError listing the names that exist.
[[nodiscard]] std::filesystem::path find_sensor(const std::string& name_or_file,
                                                const std::vector<std::filesystem::path>& folders);

/// The beams of one scan in firing order. Directions are unit vectors in the frame of the sensor (x is the boresight).
struct Beams {
  std::vector<float> x;
  std::vector<float> y;
  std::vector<float> z;
  std::vector<float> time_s;        ///< since the start of the scan, not decreasing
  std::vector<std::uint16_t> ring;  ///< empty where the sensor has none; 0 is the lowest laser

  [[nodiscard]] std::size_t size() const { return x.size(); }
  void resize(std::size_t size, bool with_ring);
};

class DirectionMaker;

/// Makes the beams of any scan of a sensor. Nothing restarts with a scan: scan k holds what the sensor fires from
/// k / scan_hz to (k + 1) / scan_hz, so that patterns go on, and scans of a spinning head may differ by a column.
class BeamPattern {
 public:
  /// Throws ConfigError as `PatternConfig::check`.
  explicit BeamPattern(const PatternConfig& config);

  /// Thread-safe; `beams` keeps its memory.
  void beams_of_scan(std::size_t scan, Beams& beams) const;
  /// The most beams that a scan has.
  [[nodiscard]] std::size_t beams_per_scan() const;

 private:
  std::shared_ptr<const DirectionMaker> maker_;
};

}  // namespace berm::sim
