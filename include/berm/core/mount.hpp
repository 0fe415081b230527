#pragma once

#include "berm/core/config.hpp"
#include "berm/core/pose.hpp"

namespace berm {

/// Where the sensor sits: base_link is on the ground under the origin of the machine, x forward, y left, z up.
struct MountConfig {
  double height_m = 0.0;
  double pitch_deg = 0.0;
  double roll_deg = 0.0;
  double yaw_deg = 0.0;
  double x_m = 0.0;
  double y_m = 0.0;

  static void fields(auto&& field) {
    field("height_m", &MountConfig::height_m, Range{0.0, 50.0}, "height of the sensor above the ground");
    field("pitch_deg", &MountConfig::pitch_deg, Range{-180.0, 180.0}, "nose down is positive");
    field("roll_deg", &MountConfig::roll_deg, Range{-180.0, 180.0},
          "right side down is positive; 180 hangs it upside down");
    field("yaw_deg", &MountConfig::yaw_deg, Range{-180.0, 180.0}, "turned to the left is positive");
    field("x_m", &MountConfig::x_m, Range{-50.0, 50.0}, "forward of base_link");
    field("y_m", &MountConfig::y_m, Range{-50.0, 50.0}, "left of base_link");
  }
  void check() const { check_fields(*this, "mount"); }

  [[nodiscard]] Pose T_base_sensor() const;
};

}  // namespace berm
