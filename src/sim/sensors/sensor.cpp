#include "berm/sim/sensor.hpp"

#include <algorithm>
#include <cmath>

#include "beam_pattern.hpp"
#include "berm/core/error.hpp"
#include "berm/io/settings.hpp"
#include "berm/io/settings_folders.hpp"

namespace berm::sim {
namespace {

/// Ten times the densest sensor sold: what a mistyped rate must not exceed.
constexpr double kMaxBeamsPerScan = 4e6;
constexpr std::size_t kMaxLasers = 512;

SettingsKind sensor_kind() {
  return {"sensor", "sensors", "scenario.sensor"};
}

void refuse(const std::string& key, const std::string& problem) {
  throw ConfigError("pattern." + key, problem);
}

void check_spinning(const PatternConfig& config) {
  const auto elevations_deg = parse_angles_deg(config.elevations_deg, "elevations_deg");
  const auto offsets_deg = parse_angles_deg(config.azimuth_offsets_deg, "azimuth_offsets_deg");
  if (elevations_deg.empty() || elevations_deg.size() > kMaxLasers) {
    refuse("elevations_deg",
           "expected 1 to " + std::to_string(kMaxLasers) + " angles, found " + std::to_string(elevations_deg.size()));
  }
  if (!offsets_deg.empty() && offsets_deg.size() != elevations_deg.size()) {
    refuse("azimuth_offsets_deg", "expected as many as elevations, " + std::to_string(elevations_deg.size()) +
                                      ", or none, found " + std::to_string(offsets_deg.size()));
  }
  const double lasers = static_cast<double>(elevations_deg.size());
  if (config.column_s * config.scan_hz > 1.0 || lasers > kMaxBeamsPerScan * config.column_s * config.scan_hz) {
    refuse("column_s", "must leave 1 to " + std::to_string(static_cast<int>(kMaxBeamsPerScan / lasers)) +
                           " columns a scan at this scan_hz");
  }
  const double groups = std::ceil(lasers / config.lasers_at_once);
  if ((groups - 1.0) * config.firing_s >= config.column_s) {
    refuse("firing_s", "the lasers take longer than pattern.column_s");
  }
}

void check_rate(const PatternConfig& config) {
  const double beams = config.points_per_s / config.scan_hz;
  if (beams < 1.0 || beams > kMaxBeamsPerScan) {
    refuse("points_per_s",
           "must be 1 to " + std::to_string(static_cast<int>(kMaxBeamsPerScan)) + " beams a scan at this scan_hz");
  }
}

void check_swirl(const PatternConfig& config) {
  if (config.max_elevation_deg - config.min_elevation_deg < config.fan_height_deg) {
    refuse("max_elevation_deg", "the view from pattern.min_elevation_deg up is lower than pattern.fan_height_deg");
  }
}

}  // namespace

void PatternConfig::check() const {
  check_fields(*this, "pattern");
  if (kind == "spinning") {
    check_spinning(*this);
    return;
  }
  check_rate(*this);
  if (kind == "swirl") {
    check_swirl(*this);
  }
}

void OpticsConfig::check() const {
  check_fields(*this, "optics");
  if (min_range_m >= max_range_m) {
    throw ConfigError("optics.min_range_m", "must be less than optics.max_range_m");
  }
}

double OpticsConfig::detection_limit() const {
  return received_light(*this, 0.1, 1.0, range_at_10_percent_m);
}

// The exponent and the ranges were fitted to the flakes of a real recording (docs/simulator.md). Surfaces are to be
// seen down to the least range, hence the loss ends somewhere.
double received_light(const OpticsConfig& optics, double reflectivity, double share, double range_m) {
  constexpr double kMostLoss = 1e4;
  const double square = std::max(range_m * range_m, 1e-6);
  const double near = optics.near_field_m * optics.near_field_m / square;
  return reflectivity * share / (square * (1.0 + std::min(near * near * near, kMostLoss)));
}

void Sensor::check() const {
  sections([this](std::string_view, auto member) { (this->*member).check(); });
}

Sensor parse_sensor(std::string_view yaml, const std::string& file) {
  return parse_yaml<Sensor>(yaml, file, {"sensor.name", "pattern.kind", "pattern.scan_hz"});
}

Sensor read_sensor(const std::filesystem::path& file) {
  return read_yaml<Sensor>(file, {"sensor.name", "pattern.kind", "pattern.scan_hz"});
}

std::vector<std::filesystem::path> sensor_folders() {
  return settings_folders(sensor_kind());
}

std::filesystem::path find_sensor(const std::string& name_or_file, const std::vector<std::filesystem::path>& folders) {
  return find_settings(sensor_kind(), name_or_file, folders);
}

}  // namespace berm::sim
