#pragma once

#include <cstdint>
#include <vector>

#include "berm/core/point_cloud.hpp"
#include "berm/core/pose.hpp"

namespace berm {

/// The points of a scan in the levelled frame: origin on the ground plane below the sensor, z along its normal.
/// Channels have one entry per point of the scan; those of beams without a return mean nothing.
struct LevelPoints {
  std::vector<float> x;
  std::vector<float> y;
  std::vector<float> z;
  std::vector<float> range2;        ///< m^2, from the origin, on the map
  std::vector<std::uint16_t> turn;  ///< the bearing, see `bearing_grid::turn_of`
  float sensor_height_m = 0.0F;     ///< above the plane

  void fill(const PointsView& points, const Pose& T_level_sensor);
};

}  // namespace berm
