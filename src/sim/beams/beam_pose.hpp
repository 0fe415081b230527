#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include <Eigen/Core>

#include "berm/core/pose.hpp"
#include "berm/core/trajectory.hpp"

namespace berm::sim {

/// A frame at one time: `p_world = rotation * p + origin_m`.
struct Placed {
  Eigen::Matrix3d rotation;
  Eigen::Vector3d origin_m;
};

/// The screw motion from one pose to the next of something mounted on it: what `interpolate(from, to, s) * mount` says,
/// to rounding, for a twentieth of its cost.
class ScrewMotion {
 public:
  ScrewMotion(const Pose& T_world_from, const Pose& T_world_to, const Pose& T_from_mounted);

  void at(double s, Placed& placed) const;

 private:
  double angle_rad_ = 0.0;
  // R(s) = R0 + c1 R1 + c2 R2 and o(s) = o0 + s os + c1 o1 + c2 o2 + c3 o3, with c1..c3 of s and the angle.
  std::array<Eigen::Matrix3d, 3> rotation_;
  std::array<Eigen::Vector3d, 5> origin_;
};

/// The poses of a screw motion at rising times, most of them from the straight line between two exact ones: no more
/// than `kMaxGap_s` apart a machine's turns and pushes stay below 1e-9 rad and 1e-7 m.
class DensePoses {
 public:
  static constexpr double kMaxGap_s = 2e-4;

  DensePoses(const ScrewMotion& motion, double lasts_s) : motion_(motion), lasts_s_(lasts_s) {}

  /// `time_s` since the start of the motion, not before that of the last call.
  void at(double time_s, Placed& placed);

 private:
  const ScrewMotion& motion_;
  double lasts_s_;
  double from_s_ = 0.0;
  double to_s_ = -1.0;  ///< nothing is known yet
  Placed from_;
  Placed to_;
  Placed per_s_;
};

/// Something on a trajectory; it stands still before the first and after the last pose.
class PoseTrack {
 public:
  /// The trajectory must not be empty.
  explicit PoseTrack(const Trajectory& trajectory);

  void at(double time_s, Placed& placed) const;

  struct Since {
    std::size_t index;  ///< of a pose
    double since_s;     ///< how long it moves from there on, 0 where it stands still
  };
  /// The last pose that is no later, or the first.
  [[nodiscard]] Since pose_before(double time_s) const;
  /// Largest speed of the origin between two poses.
  [[nodiscard]] double max_speed_m_per_s() const { return max_speed_m_per_s_; }

 private:
  std::vector<double> times_s_;
  std::vector<ScrewMotion> motions_;
  double max_speed_m_per_s_ = 0.0;
};

}  // namespace berm::sim
