#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "berm/core/pose.hpp"
#include "berm/ground/ground.hpp"
#include "support/made_scan.hpp"

namespace berm::bench {

struct NamedWorld {
  std::string name;
  test::World world;
};

/// Two streets, and eleven terrains with boxes and poles on them: slopes of 30 degrees, bowls, crests, rolling hills,
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

[[nodiscard]] Pose mount_of(const NamedSensor& sensor);
/// SemanticKITTI ids: 72 terrain, 99 things, 0 no return.
[[nodiscard]] std::vector<std::uint32_t> truth_of(const test::MadeScan& scan);
/// 40 for ground, 99 for everything else.
[[nodiscard]] std::vector<std::uint32_t> labels_of(const GroundResult& result);

}  // namespace berm::bench
