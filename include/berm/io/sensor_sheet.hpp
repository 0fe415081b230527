#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace berm {

/// What sequence.json says about the sensor; everything is optional.
struct SensorSheet {
  std::optional<std::string> sensor;      ///< "sensor": a name
  std::optional<double> height_m;         ///< "sensor_height_m" above base_link, 0 to 100
  std::optional<double> pitch_rad;        ///< "sensor_pitch_deg" -90 to 90, positive: nose down
  std::optional<double> scan_hz;          ///< "scan_hz", 0.01 to 1000
  std::vector<std::string> unknown_keys;  ///< keys of the file that mean nothing here, sorted
};

/// Reads sequence.json, at most 1 MiB. Throws FileError: not there, unreadable, no JSON object, nested deeper than 16,
/// a key above with a value of another type or outside its range. Unknown keys are listed, not refused.
[[nodiscard]] SensorSheet read_sensor_sheet(const std::filesystem::path& path);

/// The same from memory; `name` stands for the file in errors.
[[nodiscard]] SensorSheet parse_sensor_sheet(std::string_view text, const std::string& name);

}  // namespace berm
