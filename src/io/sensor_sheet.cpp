#include "berm/io/sensor_sheet.hpp"

#include <cmath>
#include <cstdint>

#include <nlohmann/json.hpp>

#include "berm/core/angle.hpp"
#include "berm/core/config.hpp"
#include "berm/core/error.hpp"
#include "berm/io/atomic_file.hpp"
#include "berm/io/file_reader.hpp"
#include "berm/io/trajectory_file.hpp"

namespace berm {
namespace {

using Json = nlohmann::json;

constexpr std::uint64_t kMaxBytes = std::uint64_t{1} << 20U;
constexpr int kMaxDepth = 16;

Json parse_bounded(std::string_view text, const std::string& name) {
  const auto check_depth = [&](int depth, Json::parse_event_t /*event*/, Json& /*parsed*/) {
    if (depth > kMaxDepth) {
      throw FileError(ErrorCode::malformed, name, std::nullopt,
                      "nested deeper than " + std::to_string(kMaxDepth) + " levels, expected a flat object");
    }
    return true;
  };
  try {
    return Json::parse(text, check_depth);
  } catch (const Json::parse_error& error) {
    // Counts bytes from 1.
    throw FileError(ErrorCode::malformed, name, error.byte > 0 ? error.byte - 1 : 0, "this is no JSON");
  } catch (const Json::exception& error) {
    throw FileError(ErrorCode::malformed, name, std::nullopt, error.what());
  }
}

double number_in(const Json& value, const std::string& key, const Range& range, const std::string& name) {
  const std::string expected = ", expected a number from " + Json(range.min).dump() + " to " + Json(range.max).dump();
  if (!value.is_number()) {
    throw FileError(ErrorCode::malformed, name, std::nullopt, "'" + key + "' is a " + value.type_name() + expected);
  }
  const auto number = value.get<double>();
  if (!(number >= range.min && number <= range.max)) {
    throw FileError(ErrorCode::malformed, name, std::nullopt, "'" + key + "' is " + value.dump() + expected);
  }
  return number;
}

std::string text_of(const Json& value, const std::string& key, const std::string& name) {
  if (!value.is_string()) {
    throw FileError(ErrorCode::malformed, name, std::nullopt,
                    "'" + key + "' is a " + value.type_name() + ", expected a text");
  }
  return value.get<std::string>();
}

std::uint64_t seed_of(const Json& value, const std::string& name) {
  if (!value.is_number_unsigned()) {
    throw FileError(ErrorCode::malformed, name, std::nullopt,
                    "'seed' is " + value.dump() + ", expected a whole number from 0 to 18446744073709551615");
  }
  return value.get<std::uint64_t>();
}

std::array<double, 3> point_of(const Json& value, const std::string& key, const std::string& name) {
  if (!value.is_array() || value.size() != 3) {
    throw FileError(ErrorCode::malformed, name, std::nullopt,
                    "'" + key + "' is a " + value.type_name() + ", expected an array of three numbers");
  }
  std::array<double, 3> point{};
  for (std::size_t i = 0; i < point.size(); ++i) {
    point[i] = number_in(value[i], key, {-kMaxCoordinate_m, kMaxCoordinate_m}, name);
  }
  return point;
}

/// Rid of the last digits that the way through radians left.
double to_deg(double angle_rad) {
  return std::round(angle_rad / kRadPerDeg * 1e9) / 1e9;
}

}  // namespace

SensorSheet read_sensor_sheet(const std::filesystem::path& path) {
  FileBuffer buffer;
  (void)read_file(path, buffer, kMaxBytes);
  return parse_sensor_sheet(buffer.text(), path.string());
}

SensorSheet parse_sensor_sheet(std::string_view text, const std::string& name) {
  const Json json = parse_bounded(text, name);
  if (!json.is_object()) {
    throw FileError(ErrorCode::malformed, name, std::nullopt, "expected a JSON object such as {\"scan_hz\": 10}");
  }
  SensorSheet sheet;
  // Keys of an object come in sorted order.
  for (const auto& [key, value] : json.items()) {
    if (key == "sensor") {
      sheet.sensor = text_of(value, key, name);
    } else if (key == "sensor_height_m") {
      sheet.height_m = number_in(value, key, {0.0, 100.0}, name);
    } else if (key == "sensor_pitch_deg") {
      sheet.pitch_rad = number_in(value, key, {-90.0, 90.0}, name) * kRadPerDeg;
    } else if (key == "sensor_roll_deg") {
      sheet.roll_rad = number_in(value, key, {-180.0, 180.0}, name) * kRadPerDeg;
    } else if (key == "sensor_yaw_deg") {
      sheet.yaw_rad = number_in(value, key, {-180.0, 180.0}, name) * kRadPerDeg;
    } else if (key == "scenario") {
      sheet.scenario = text_of(value, key, name);
    } else if (key == "seed") {
      sheet.seed = seed_of(value, name);
    } else if (key == "program") {
      sheet.program = text_of(value, key, name);
    } else if (key == "world_origin_m") {
      sheet.world_origin_m = point_of(value, key, name);
    } else if (key == "scan_hz") {
      sheet.scan_hz = number_in(value, key, {0.01, 1000.0}, name);
    } else {
      sheet.unknown_keys.push_back(key);
    }
  }
  return sheet;
}

void write_sensor_sheet(const std::filesystem::path& path, const SensorSheet& sheet) {
  nlohmann::ordered_json json = nlohmann::ordered_json::object();
  const auto put = [&json](const char* key, const auto& value) {
    if (value) {
      json[key] = *value;
    }
  };
  const auto put_angle = [&json](const char* key, const std::optional<double>& angle_rad) {
    if (angle_rad) {
      json[key] = to_deg(*angle_rad);
    }
  };
  put("sensor", sheet.sensor);
  put("sensor_height_m", sheet.height_m);
  put_angle("sensor_pitch_deg", sheet.pitch_rad);
  put_angle("sensor_roll_deg", sheet.roll_rad);
  put_angle("sensor_yaw_deg", sheet.yaw_rad);
  put("scan_hz", sheet.scan_hz);
  put("scenario", sheet.scenario);
  put("seed", sheet.seed);
  put("program", sheet.program);
  put("world_origin_m", sheet.world_origin_m);
  write_file_atomically(path, json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n");
}

}  // namespace berm
