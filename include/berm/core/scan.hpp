#pragma once

#include "berm/core/point_cloud.hpp"
#include "berm/core/pose.hpp"
#include "berm/core/stamp.hpp"

namespace berm {

/// One sweep of a sensor.
struct Scan {
  Stamp stamp_ns = 0;  ///< start of the sweep
  PointCloud cloud;    ///< in the frame of the sensor
  Pose T_base_sensor;  ///< mount: base_link is on the ground under the sensor, levelled with the chassis
};

}  // namespace berm
