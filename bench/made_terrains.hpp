#pragma once

#include <string>
#include <vector>

#include "support/made_scan.hpp"

namespace berm::bench {

struct NamedWorld {
  std::string name;
  test::World world;
};

/// Two streets, and ten terrains with boxes and poles on them: slopes of 30 degrees, a bowl, crests, rolling hills,
/// rough ground, a ditch.
[[nodiscard]] std::vector<NamedWorld> made_terrains();

/// A sensor and how it is mounted.
struct NamedSensor {
  std::string name;
  test::Beams beams;
  double height_m;
  double pitch_deg;
};

/// 64 rings on a car, 16 rings on a truck, a 70.4 degree rosette on a groomer.
[[nodiscard]] std::vector<NamedSensor> made_sensors();

}  // namespace berm::bench
