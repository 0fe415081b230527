#include "beam_pose.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace berm::sim {
namespace {

/// Below this angle (0.5 rad between two poses) four terms of the series leave less than 1e-9.
constexpr double kSeriesAngle_rad = 0.5;

Eigen::Matrix3d skew(const Eigen::Vector3d& v) {
  Eigen::Matrix3d m;
  m << 0.0, -v.z(), v.y(), v.z(), 0.0, -v.x(), -v.y(), v.x(), 0.0;
  return m;
}

struct Coefficients {
  double c1;  ///< sin(s a) / a
  double c2;  ///< (1 - cos(s a)) / a^2
  double c3;  ///< (s a - sin(s a)) / a^3
};

Coefficients coefficients(double s, double angle_rad) {
  const double turned_rad = s * angle_rad;
  const double x = turned_rad * turned_rad;
  if (angle_rad > kSeriesAngle_rad) {
    const double sine = std::sin(turned_rad);
    const double half_sine = std::sin(0.5 * turned_rad);
    return {sine / angle_rad, 2.0 * half_sine * half_sine / (angle_rad * angle_rad),
            (turned_rad - sine) / (angle_rad * angle_rad * angle_rad)};
  }
  return {s * (1.0 - x / 6.0 * (1.0 - x / 20.0 * (1.0 - x / 42.0 * (1.0 - x / 72.0)))),
          s * s * (0.5 - x / 24.0 * (1.0 - x / 30.0 * (1.0 - x / 56.0 * (1.0 - x / 90.0)))),
          s * s * s * (1.0 / 6.0 - x / 120.0 * (1.0 - x / 42.0 * (1.0 - x / 72.0 * (1.0 - x / 110.0))))};
}

}  // namespace

ScrewMotion::ScrewMotion(const Pose& T_world_from, const Pose& T_world_to, const Pose& T_from_mounted) {
  const Vector6d twist = (T_world_from.inverse() * T_world_to).log();
  const Eigen::Vector3d moved_m = twist.head<3>();
  const Eigen::Matrix3d turn = skew(twist.tail<3>());
  const Eigen::Matrix3d from = T_world_from.rotation().toRotationMatrix();
  const Eigen::Matrix3d mount = T_from_mounted.rotation().toRotationMatrix();
  const Eigen::Vector3d& arm_m = T_from_mounted.translation_m();
  angle_rad_ = twist.tail<3>().norm();
  const Eigen::Matrix3d from_turn = from * turn;
  const Eigen::Matrix3d from_turn_turn = from_turn * turn;
  rotation_ = {from * mount, from_turn * mount, from_turn_turn * mount};
  origin_ = {T_world_from.translation_m() + from * arm_m, from * moved_m, from_turn * arm_m,
             from_turn * moved_m + from_turn_turn * arm_m, from_turn_turn * moved_m};
}

void ScrewMotion::at(double s, Placed& placed) const {
  const Coefficients c = coefficients(s, angle_rad_);
  placed.rotation = rotation_[0] + c.c1 * rotation_[1] + c.c2 * rotation_[2];
  placed.origin_m = origin_[0] + s * origin_[1] + c.c1 * origin_[2] + c.c2 * origin_[3] + c.c3 * origin_[4];
}

void DensePoses::at(double time_s, Placed& placed) {
  if (!(time_s <= to_s_)) {
    // Most often the next time is soon after: then one end is known.
    const bool goes_on = time_s <= to_s_ + kMaxGap_s;
    from_s_ = goes_on ? to_s_ : time_s;
    to_s_ = from_s_ + kMaxGap_s;
    if (goes_on) {
      from_ = to_;
    } else {
      motion_.at(from_s_ / lasts_s_, from_);
    }
    motion_.at(to_s_ / lasts_s_, to_);
    per_s_.rotation = (to_.rotation - from_.rotation) * (1.0 / kMaxGap_s);
    per_s_.origin_m = (to_.origin_m - from_.origin_m) * (1.0 / kMaxGap_s);
  }
  const double since_s = time_s - from_s_;
  placed.rotation = from_.rotation + since_s * per_s_.rotation;
  placed.origin_m = from_.origin_m + since_s * per_s_.origin_m;
}

PoseTrack::PoseTrack(const Trajectory& trajectory) {
  const std::vector<StampedPose>& poses = trajectory.poses();
  for (std::size_t i = 0; i < poses.size(); ++i) {
    const StampedPose& next = poses[std::min(i + 1, poses.size() - 1)];
    times_s_.push_back(to_seconds(poses[i].stamp_ns));
    motions_.emplace_back(poses[i].T_world_base, next.T_world_base, Pose{});
    if (i + 1 < poses.size()) {
      const double moved_m = (next.T_world_base.translation_m() - poses[i].T_world_base.translation_m()).norm();
      // A screw bends the way; a quarter more covers turns of up to 2 rad from pose to pose.
      max_speed_m_per_s_ = std::max(max_speed_m_per_s_, 1.25 * moved_m / (to_seconds(next.stamp_ns) - times_s_[i]));
    }
  }
}

PoseTrack::Since PoseTrack::pose_before(double time_s) const {
  const auto after = std::upper_bound(times_s_.begin(), times_s_.end(), time_s);
  const std::size_t i = after == times_s_.begin() ? 0 : static_cast<std::size_t>(after - times_s_.begin()) - 1;
  const bool moves = after != times_s_.begin() && after != times_s_.end();
  return {i, moves ? time_s - times_s_[i] : 0.0};
}

void PoseTrack::at(double time_s, Placed& placed) const {
  const auto [i, since_s] = pose_before(time_s);
  motions_[i].at(since_s > 0.0 ? since_s / (times_s_[i + 1] - times_s_[i]) : 0.0, placed);
}

}  // namespace berm::sim
