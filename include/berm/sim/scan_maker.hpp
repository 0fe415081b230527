#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "berm/core/point_cloud.hpp"
#include "berm/core/pose.hpp"
#include "berm/core/trajectory.hpp"
#include "berm/sim/ray_caster.hpp"
#include "berm/sim/sensor.hpp"
#include "berm/sim/weather.hpp"

namespace berm::sim {

/// A scan as the sensor would give it, and what each of its points truly is.
struct MadeScan {
  Stamp stamp_ns = 0;
  PointChannels points;               ///< x y z intensity time, ring where the sensor has rings
  std::vector<std::uint32_t> labels;  ///< SemanticKITTI ids; number of a mover in the upper 16 bits
  std::size_t beams = 0;
};

/// Fires the beams of a sensor into a world: mixed and double echoes, porous crowns and nets, grazing and dark
/// surfaces, snowfall, dust, noise, motion within the scan.
class ScanMaker {
 public:
  /// The arguments are kept by reference and have to outlive this.
  ScanMaker(const Sensor& sensor, const Pose& T_base_sensor, const RayCaster& caster, const Weather& weather,
            const Trajectory& T_world_base, std::uint64_t seed);

  /// Makes scan `index`; the same bytes whenever and wherever. Thread-safe; `scan` keeps its memory.
  void make(std::size_t index, MadeScan& scan) const;
};

}  // namespace berm::sim
