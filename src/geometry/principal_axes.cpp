#include "principal_axes.hpp"

#include <limits>

#include <Eigen/Eigenvalues>

namespace berm {

std::optional<PrincipalAxes> principal_axes(const Moments& moments) {
  const Eigen::Matrix3d covariance_m2 = moments.covariance_m2();
  if (moments.count() == 0 || !covariance_m2.allFinite() || !moments.mean_m().allFinite()) {
    return std::nullopt;
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(covariance_m2);
  if (solver.info() != Eigen::Success) {
    return std::nullopt;
  }
  constexpr double kEpsilon = std::numeric_limits<double>::epsilon();
  const double coordinate_error_m = 4.0 * kEpsilon * moments.mean_m().cwiseAbs().maxCoeff();
  return PrincipalAxes{.eigenvalues_m2 = solver.eigenvalues().cwiseMax(0.0),
                       .axes = solver.eigenvectors(),
                       .smallest_m2 = coordinate_error_m * coordinate_error_m};
}

bool is_longer(double longer_m2, double shorter_m2, double smallest_m2) {
  constexpr double kRelative = 1e-9;
  return longer_m2 > smallest_m2 && longer_m2 - shorter_m2 > kRelative * longer_m2;
}

Eigen::Vector3d with_sign(const Eigen::Vector3d& axis, const Eigen::Vector3i& order) {
  for (const int component : order) {
    if (axis[component] != 0.0) {
      return axis[component] > 0.0 ? axis : Eigen::Vector3d(-axis);
    }
  }
  return axis;
}

}  // namespace berm
