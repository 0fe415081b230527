#pragma once

#include <filesystem>
#include <string>

#include "berm/sim/sensor.hpp"

namespace berm::sim::test {

/// The folder of the sensors that the project describes.
[[nodiscard]] inline std::filesystem::path sensors_folder() {
  return std::filesystem::path(__FILE__).parent_path().parent_path().parent_path() / "sensors";
}

[[nodiscard]] inline Sensor sensor(const std::string& name) {
  return read_sensor(find_sensor(name, {sensors_folder()}));
}

}  // namespace berm::sim::test
