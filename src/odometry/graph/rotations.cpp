#include "rotations.hpp"

#include <cmath>

#include "berm/core/pose.hpp"

namespace berm {
namespace {

/// Below this the series are exact to the last digits.
constexpr double kSmall_rad = 1e-4;

}  // namespace

Eigen::Matrix3d skew(const Eigen::Vector3d& a) {
  Eigen::Matrix3d m;
  m << 0.0, -a.z(), a.y(), a.z(), 0.0, -a.x(), -a.y(), a.x(), 0.0;
  return m;
}

Eigen::Quaterniond rotation_exp(const Eigen::Vector3d& rotation_rad) {
  Vector6d twist = Vector6d::Zero();
  twist.tail<3>() = rotation_rad;
  return Pose::exp(twist).rotation();
}

Eigen::Vector3d rotation_log(const Eigen::Quaterniond& rotation) {
  return Pose(rotation, Eigen::Vector3d::Zero()).log().tail<3>();
}

Eigen::Matrix3d right_jacobian(const Eigen::Vector3d& rotation_rad) {
  const double angle = rotation_rad.norm();
  const Eigen::Matrix3d cross = skew(rotation_rad);
  if (angle < kSmall_rad) {
    return Eigen::Matrix3d::Identity() - 0.5 * cross + cross * cross / 6.0;
  }
  const double square = angle * angle;
  return Eigen::Matrix3d::Identity() - (1.0 - std::cos(angle)) / square * cross +
         (angle - std::sin(angle)) / (square * angle) * cross * cross;
}

Eigen::Matrix3d right_jacobian_inverse(const Eigen::Vector3d& rotation_rad) {
  const double angle = rotation_rad.norm();
  const Eigen::Matrix3d cross = skew(rotation_rad);
  if (angle < kSmall_rad) {
    return Eigen::Matrix3d::Identity() + 0.5 * cross + cross * cross / 12.0;
  }
  // (1 + cos) / sin as the cotangent of half the angle, which is finite up to pi.
  const double square = angle * angle;
  const double share = 1.0 / square - 0.5 / (angle * std::tan(0.5 * angle));
  return Eigen::Matrix3d::Identity() + 0.5 * cross + share * cross * cross;
}

}  // namespace berm
