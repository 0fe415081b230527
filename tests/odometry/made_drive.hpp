#pragma once

#include <functional>
#include <optional>
#include <vector>

#include <Eigen/Core>

#include "berm/core/label.hpp"
#include "berm/core/point_cloud.hpp"
#include "berm/core/pose.hpp"
#include "berm/odometry/odometry.hpp"

namespace berm::test {

/// Axis-parallel box.
struct Box {
  Eigen::Vector3d low_m;
  Eigen::Vector3d high_m;
};

/// Level ground at z = 0 and what stands on it.
struct MadePlace {
  std::vector<Box> boxes;
  bool has_ground = true;
};

/// Containers and posts on both sides of the x axis, up to 100 m.
[[nodiscard]] MadePlace made_yard();
/// Ground and nothing else.
[[nodiscard]] MadePlace bare_ground();

/// T_world_base at a time in s.
using MadeMotion = std::function<Pose(double)>;

/// Forward at a speed from the origin on, heaving by `heave_rad` about the y axis once a second.
[[nodiscard]] MadeMotion straight(double speed_mps, double heave_rad = 0.0);

/// A scan as a sensor with 16 rings takes it in `turns` turns of 0.1 s, 2 m above the base: range noise of 0.02 m, one
/// sigma.
class MadeScan {
 public:
  MadeScan(const MadePlace& place, const MadeMotion& motion, double begin_s, std::size_t turns = 1);
  [[nodiscard]] OdometryInput input() const;

  PointChannels channels;
  std::vector<Label> labels;
  Stamp stamp_ns = 0;

 private:
  void cast(const MadePlace& place, const Pose& T_world_sensor, const Eigen::Vector3d& direction, double time_s,
            double noise_m);
};

/// Where a drive of `scans` scans, one after the other, was at the stamps of its scans according to `odometry`,
/// revisions included; `look` sees every result.
[[nodiscard]] std::vector<Pose> follow(Odometry& odometry, const MadePlace& place, const MadeMotion& motion,
                                       std::size_t scans, const std::function<void(const OdometryResult&)>& look = {},
                                       std::size_t turns = 1);

}  // namespace berm::test
