#include "berm/core/mount.hpp"

#include "berm/core/angle.hpp"

namespace berm {

Pose MountConfig::T_base_sensor() const {
  return Pose::from_yaw_pitch_roll(yaw_deg * kRadPerDeg, pitch_deg * kRadPerDeg, roll_deg * kRadPerDeg,
                                   {x_m, y_m, height_m});
}

}  // namespace berm
