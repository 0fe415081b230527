#include "berm/core/pose.hpp"

#include <cmath>

namespace berm {
namespace {

using Eigen::Matrix3d;
using Eigen::Quaterniond;
using Eigen::Vector3d;

/// Below this angle the closed forms lose digits and the first terms of their series are exact in double.
constexpr double kSmallAngle_rad = 1e-4;

Matrix3d skew(const Vector3d& v) {
  Matrix3d m;
  m << 0.0, -v.z(), v.y(), v.z(), 0.0, -v.x(), -v.y(), v.x(), 0.0;
  return m;
}

Quaterniond rotation_exp(const Vector3d& rotation_rad) {
  const double angle = rotation_rad.norm();
  // sin(angle/2)/angle
  const double scale = angle < kSmallAngle_rad ? 0.5 - angle * angle / 48.0 : std::sin(0.5 * angle) / angle;
  const Vector3d v = scale * rotation_rad;
  return {std::cos(0.5 * angle), v.x(), v.y(), v.z()};
}

Vector3d rotation_log(const Quaterniond& rotation) {
  // q and -q are one rotation; the one with w >= 0 gives the angle in [0, pi].
  const double sign = rotation.w() < 0.0 ? -1.0 : 1.0;
  const double w = sign * rotation.w();
  const Vector3d v = sign * rotation.vec();
  const double sin_half = v.norm();
  if (sin_half < kSmallAngle_rad) {
    // 2 atan(t)/t with t = |v|/w
    const double t = sin_half / w;
    return (2.0 / w) * (1.0 - t * t / 3.0) * v;
  }
  return (2.0 * std::atan2(sin_half, w) / sin_half) * v;
}

/// The matrix V with exp([rho, phi]) = (exp(phi), V rho).
Matrix3d left_jacobian(const Vector3d& rotation_rad) {
  const double angle = rotation_rad.norm();
  const double angle_squared = angle * angle;
  const Matrix3d s = skew(rotation_rad);
  const bool small = angle < kSmallAngle_rad;
  // 1 - cos(x) as 2 sin(x/2)^2: the difference itself would leave eight digits at the switch.
  const double sinc_half = small ? 1.0 - angle_squared / 24.0 : std::sin(0.5 * angle) / (0.5 * angle);
  const double a = 0.5 * sinc_half * sinc_half;
  const double b = small ? 1.0 / 6.0 - angle_squared / 120.0 : (angle - std::sin(angle)) / (angle_squared * angle);
  return Matrix3d::Identity() + a * s + b * s * s;
}

Matrix3d left_jacobian_inverse(const Vector3d& rotation_rad) {
  const double angle = rotation_rad.norm();
  const double angle_squared = angle * angle;
  const Matrix3d s = skew(rotation_rad);
  const double half = 0.5 * angle;
  const double c = angle < kSmallAngle_rad ? 1.0 / 12.0 + angle_squared / 720.0
                                           : (1.0 - half * std::cos(half) / std::sin(half)) / angle_squared;
  return Matrix3d::Identity() - 0.5 * s + c * s * s;
}

}  // namespace

Pose::Pose(const Quaterniond& rotation, const Vector3d& translation_m)
    : rotation_(rotation.normalized()), translation_m_(translation_m) {}

Pose Pose::from_matrix(const Eigen::Matrix<double, 3, 4>& matrix) {
  return {Quaterniond(matrix.leftCols<3>()), matrix.col(3)};
}

Pose Pose::from_yaw_pitch_roll(double yaw_rad, double pitch_rad, double roll_rad, const Vector3d& translation_m) {
  const Quaterniond rotation = Eigen::AngleAxisd(yaw_rad, Vector3d::UnitZ()) *
                               Eigen::AngleAxisd(pitch_rad, Vector3d::UnitY()) *
                               Eigen::AngleAxisd(roll_rad, Vector3d::UnitX());
  return {rotation, translation_m};
}

Pose Pose::exp(const Vector6d& twist) {
  const Vector3d rotation_rad = twist.tail<3>();
  return {rotation_exp(rotation_rad), left_jacobian(rotation_rad) * twist.head<3>()};
}

Vector6d Pose::log() const {
  const Vector3d rotation_rad = rotation_log(rotation_);
  Vector6d twist;
  twist << left_jacobian_inverse(rotation_rad) * translation_m_, rotation_rad;
  return twist;
}

Eigen::Matrix4d Pose::matrix() const {
  Eigen::Matrix4d m = Eigen::Matrix4d::Identity();
  m.topLeftCorner<3, 3>() = rotation_.toRotationMatrix();
  m.topRightCorner<3, 1>() = translation_m_;
  return m;
}

Pose Pose::inverse() const {
  const Quaterniond back = rotation_.conjugate();
  return {back, -(back * translation_m_)};
}

Pose Pose::operator*(const Pose& other) const {
  return {rotation_ * other.rotation_, translation_m_ + rotation_ * other.translation_m_};
}

Vector3d Pose::operator*(const Vector3d& point_m) const {
  return rotation_ * point_m + translation_m_;
}

Pose interpolate(const Pose& from, const Pose& to, double s) {
  return from * Pose::exp(s * (from.inverse() * to).log());
}

}  // namespace berm
