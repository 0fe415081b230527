#pragma once

#include <vector>

#include <Eigen/Core>

#include "berm/core/pose.hpp"
#include "berm/core/stamp.hpp"
#include "berm/core/trajectory.hpp"

namespace berm {

/// How the sensor moved during one scan: where each point was measured from, at its own time. Poses are taken every
/// millisecond and blended between, which for a machine that turns by 1 rad/s is 5 um at 40 m. Keeps its memory.
class ScanMotion {
 public:
  /// The motion from `first_ns` to `last_ns`, which `T_world_base` must cover; longer than 10 s it is not for scans.
  /// False if it is not covered.
  [[nodiscard]] bool set(const Trajectory& T_world_base, const Pose& T_base_sensor, Stamp first_ns, Stamp last_ns);

  /// From the frame of the sensor to the world; `since_first_s` is the time after `first_ns`, held at both ends.
  [[nodiscard]] Eigen::Vector3d to_world_m(const Eigen::Vector3d& point_m, double since_first_s) const;

 private:
  std::vector<Eigen::Matrix<double, 3, 4>> T_world_sensor_;  ///< at steps of the same length
  double steps_per_s_ = 0.0;
};

}  // namespace berm
