#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "berm/core/pose.hpp"
#include "berm/core/trajectory.hpp"
#include "berm/odometry/pose_graph.hpp"

namespace berm::test {

/// A drive up a piste: bends, slopes and heaving.
struct MadeDrive {
  double seconds = 120.0;
  double speed_mps = 1.5;
  double rate_hz = 10.0;
  std::uint32_t seed = 1;
  bool is_even = false;  ///< no change of speed
  double drift = 1.0;    ///< 1: about 0.5 % of the way; 0: none

  /// Where the machine is; truth.
  [[nodiscard]] Pose truth(double time_s) const;
  /// What an odometry says of it, which begins at the origin and drifts.
  [[nodiscard]] std::vector<OdometryStep> odometry() const;
};

struct MadeFixes {
  double rate_hz = 10.0;
  double sigma_m = 0.02;
  bool has_attitude = true;
  double attitude_sigma_rad = 0.003;
  double clock_late_s = 0.0;  ///< stamps are so much too high
  Eigen::Vector3d antenna_m = Eigen::Vector3d::Zero();
  std::uint32_t seed = 7;

  [[nodiscard]] std::vector<Fix> of(const MadeDrive& drive) const;
};

/// Those before `from_s` and from `to_s` on.
[[nodiscard]] std::vector<Fix> without(std::vector<Fix> fixes, double from_s, double to_s);
/// Those from `from_s` to `to_s` are moved.
[[nodiscard]] std::vector<Fix> moved(std::vector<Fix> fixes, double from_s, double to_s, const Eigen::Vector3d& by_m);

struct PathError {
  double rms_m = 0.0;
  double most_m = 0.0;
  double most_rad = 0.0;
};
/// Against truth, in the world: nothing is aligned. Between two times.
[[nodiscard]] PathError error_of(const Trajectory& trajectory, const MadeDrive& drive, double from_s = -1e9,
                                 double to_s = 1e9);
/// Mean error of an odometry over 30 s, in shares of the way.
[[nodiscard]] double drift_share(const std::vector<OdometryStep>& odometry, const MadeDrive& drive);

[[nodiscard]] std::size_t count_of(const PoseGraphResult& result, FixFate fate);
[[nodiscard]] std::size_t count_of(const PoseGraphResult& result, ClosureFate fate);

}  // namespace berm::test
