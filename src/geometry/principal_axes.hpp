#pragma once

#include <optional>

#include <Eigen/Core>

#include "berm/geometry/moments.hpp"

namespace berm {

/// Axes of the ellipsoid of a covariance, from the shortest to the longest.
struct PrincipalAxes {
  Eigen::Vector3d eigenvalues_m2;  ///< ascending, never negative
  Eigen::Matrix3d axes;            ///< columns, unit length
  double smallest_m2;              ///< a variance below this may come from rounding alone
};

/// None without points and where the numbers overflow.
[[nodiscard]] std::optional<PrincipalAxes> principal_axes(const Moments& moments);

/// Whether `longer` exceeds `shorter` by more than rounding, so that the axes between them are determined.
[[nodiscard]] bool is_longer(double longer_m2, double shorter_m2, double smallest_m2);

/// `axis` or its opposite: the one whose first component that is not zero, in the order of `order`, is positive.
[[nodiscard]] Eigen::Vector3d with_sign(const Eigen::Vector3d& axis, const Eigen::Vector3i& order);

}  // namespace berm
