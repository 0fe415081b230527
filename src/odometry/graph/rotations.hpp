#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace berm {

/// Matrix of the cross product: skew(a) * b is a x b.
[[nodiscard]] Eigen::Matrix3d skew(const Eigen::Vector3d& a);

/// Rotation by a rotation vector, and back; the vector has norm <= pi.
[[nodiscard]] Eigen::Quaterniond rotation_exp(const Eigen::Vector3d& rotation_rad);
[[nodiscard]] Eigen::Vector3d rotation_log(const Eigen::Quaterniond& rotation);

/// exp(v + dv) = exp(v) exp(J dv) to first order (Sola et al. 2018, eq. 143), and its inverse (eq. 144).
[[nodiscard]] Eigen::Matrix3d right_jacobian(const Eigen::Vector3d& rotation_rad);
[[nodiscard]] Eigen::Matrix3d right_jacobian_inverse(const Eigen::Vector3d& rotation_rad);

}  // namespace berm
