#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace berm {

/// Twist: translational part first (m), rotational part second (rad).
using Vector6d = Eigen::Matrix<double, 6, 1>;

/// A rigid motion, element of SE(3). A pose named `T_target_source` takes coordinates from source to target:
/// `p_target = T_target_source * p_source`, and `T_a_c = T_a_b * T_b_c`.
///
/// Laws (tested): associative; `T * T.inverse()` is the identity; `exp(T.log())` is T; `exp(xi).log()` is xi for
/// rotations below pi; `interpolate(A, B, 0)` is A and `interpolate(A, B, 1)` is B.
class Pose {
 public:
  Pose() = default;
  /// `rotation` is normalised here; it must not be zero.
  Pose(const Eigen::Quaterniond& rotation, const Eigen::Vector3d& translation_m);

  /// Nearest pose to a 3x4 or 4x4 matrix whose left upper block is a rotation up to rounding.
  [[nodiscard]] static Pose from_matrix(const Eigen::Matrix<double, 3, 4>& matrix);
  /// Rotation by `yaw` about z, then `pitch` about the new y (positive: nose down), then `roll` about the new x.
  [[nodiscard]] static Pose from_yaw_pitch_roll(double yaw_rad, double pitch_rad, double roll_rad,
                                                const Eigen::Vector3d& translation_m);
  /// Exponential map of SE(3).
  [[nodiscard]] static Pose exp(const Vector6d& twist);
  /// Inverse of `exp`; the rotational part has norm <= pi.
  [[nodiscard]] Vector6d log() const;

  [[nodiscard]] const Eigen::Quaterniond& rotation() const { return rotation_; }
  [[nodiscard]] const Eigen::Vector3d& translation_m() const { return translation_m_; }
  [[nodiscard]] Eigen::Matrix4d matrix() const;
  [[nodiscard]] Pose inverse() const;

  [[nodiscard]] Pose operator*(const Pose& other) const;
  [[nodiscard]] Eigen::Vector3d operator*(const Eigen::Vector3d& point_m) const;

 private:
  Eigen::Quaterniond rotation_ = Eigen::Quaterniond::Identity();
  Eigen::Vector3d translation_m_ = Eigen::Vector3d::Zero();
};

/// The pose at share `s` of the screw motion from `from` (s = 0) to `to` (s = 1).
[[nodiscard]] Pose interpolate(const Pose& from, const Pose& to, double s);

}  // namespace berm
