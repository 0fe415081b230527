#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
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

/// In which directions the beams go, and when.
struct PatternConfig {
  std::string kind = "spinning";
  double scan_hz = 10.0;
  int beams_per_scan = 0;
  // Spinning: all lasers of a column fire within `column_s`, in the order of `elevations_deg`.
  std::string elevations_deg;       ///< of the lasers in firing order, separated by blanks
  std::string azimuth_offsets_deg;  ///< of the lasers, same order; empty: none
  double firing_s = 0.0;            ///< between two lasers of a column
  bool clockwise = true;            ///< seen from above
  // Rosette: two counter-rotating prisms.
  double field_of_view_deg = 70.4;
  double prism_hz = 0.0;
  double prism_ratio = 0.0;  ///< speed of the second prism over that of the first, negative: counter-rotating
  double prism_share = 0.5;  ///< deflection of the first prism over that of both

  static void fields(auto&& field);
  void check() const;
};

/// What becomes of a beam on its way and in the receiver.
struct OpticsConfig {
  double min_range_m = 0.5;
  double max_range_m = 200.0;
  double range_at_10_percent_m = 90.0;  ///< where half of the beams on a surface of 10 % reflectivity come back
  double range_noise_m = 0.02;          ///< standard deviation at good signal
  double range_quantum_m = 0.0;         ///< step of the range that the sensor reports
  double divergence_x_mrad = 3.0;       ///< full width across, horizontal
  double divergence_y_mrad = 3.0;       ///< full width, vertical
  double echo_separation_m = 1.0;       ///< echoes that are nearer to each other melt into one between them
  std::string echo = "strongest";       ///< which echo is reported
  double dropout = 0.001;               ///< share of beams that are lost for no reason
  bool keeps_no_returns = true;         ///< beams without echo are (0, 0, 0) instead of missing

  static void fields(auto&& field);
  void check() const;
};

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

/// The beams of one scan in firing order. Directions are unit vectors in the frame of the sensor (x is the boresight).
struct Beams {
  std::vector<float> x;
  std::vector<float> y;
  std::vector<float> z;
  std::vector<float> time_s;        ///< since the start of the scan, not decreasing
  std::vector<std::uint16_t> ring;  ///< empty where the sensor has none; 0 is the lowest laser

  [[nodiscard]] std::size_t size() const { return x.size(); }
};

/// Makes the beams of any scan of a sensor. Non-repeating patterns go on from scan to scan.
class BeamPattern {
 public:
  /// Throws ConfigError as `PatternConfig::check`.
  explicit BeamPattern(const PatternConfig& config);
  /// Thread-safe; `beams` keeps its memory.
  void beams_of_scan(std::size_t scan, Beams& beams) const;
  [[nodiscard]] std::size_t beams_per_scan() const;

 private:
  PatternConfig config_;
  std::vector<double> elevations_rad_;
  std::vector<double> azimuth_offsets_rad_;
};

}  // namespace berm::sim
