#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace berm {

/// What sequence.json says about the sensor; everything is optional.
struct SensorSheet {
  std::optional<std::string> sensor;    ///< "sensor": a name
  std::optional<double> height_m;       ///< "sensor_height_m" above base_link, 0 to 100
  std::optional<double> pitch_rad;      ///< "sensor_pitch_deg" -90 to 90, positive: nose down
  std::optional<double> roll_rad;       ///< "sensor_roll_deg" -180 to 180, positive: right side down
  std::optional<double> yaw_rad;        ///< "sensor_yaw_deg" -180 to 180, positive: turned to the left
  std::optional<double> scan_hz;        ///< "scan_hz", 0.01 to 1000
  std::optional<std::string> scenario;  ///< "scenario" of a made recording
  std::optional<std::uint64_t> seed;    ///< "seed" of a made recording
  std::optional<std::string> program;   ///< "program" that made it, with its version
  /// "world_origin_m": where the world frame has its origin, in the coordinates of an elevation model.
  std::optional<std::array<double, 3>> world_origin_m;
  std::vector<std::string> unknown_keys;  ///< keys of the file that mean nothing here, sorted
};

/// Reads sequence.json, at most 1 MiB. Throws FileError: not there, unreadable, no JSON object, nested deeper than 16,
/// a key above with a value of another type or outside its range. Unknown keys are listed, not refused.
[[nodiscard]] SensorSheet read_sensor_sheet(const std::filesystem::path& path);

/// The same from memory; `name` stands for the file in errors.
[[nodiscard]] SensorSheet parse_sensor_sheet(std::string_view text, const std::string& name);

/// Writes sequence.json with what `sheet` has, degrees rounded to 1e-9. Throws FileError(write_failed) as AtomicFile.
void write_sensor_sheet(const std::filesystem::path& path, const SensorSheet& sheet);

}  // namespace berm
