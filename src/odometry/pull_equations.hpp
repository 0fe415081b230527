#pragma once

#include <array>
#include <cstddef>
#include <span>

#include <Eigen/Core>

#include "berm/core/pose.hpp"
#include "scan_poses.hpp"
#include "surface_map.hpp"

namespace berm {

/// What draws a sample to a surface: along one direction to a plane, along two to a cloud.
struct Pull {
  double share = 0.0;  ///< of the scan's time
  Eigen::Vector3d base_m;
  Eigen::Vector3d mean_m;  ///< of the surface
  /// The distance along each is 1 at one sigma: the rows of a root of the information.
  std::array<Eigen::Vector3d, 2> rows_per_m;
  std::size_t row_count = 0;

  /// To a plane, across it. `variance_m2`: of the sample and the plane together.
  void set_plane(const Eigen::Vector3d& normal, double variance_m2);
  /// To a cloud, by its `information_per_m2` with nothing known along `up`, a unit vector.
  void set_cloud(const Eigen::Matrix3d& information_per_m2, const Eigen::Vector3d& up);
};

/// Normal equations of the poses at begin and end of a scan, whose blocks share what they are made of: a sample at the
/// share s of the scan's time moves by (1 - s) times the begin's step and s times the end's.
struct PullEquations {
  Matrix6d begin = Matrix6d::Zero();
  Matrix6d mixed = Matrix6d::Zero();
  Matrix6d end = Matrix6d::Zero();
  Vector6d begin_gradient = Vector6d::Zero();
  Vector6d end_gradient = Vector6d::Zero();
  std::size_t inliers = 0;  ///< nearer to their surface than `inlier_sigmas`

  /// As if both poses were moved alike.
  [[nodiscard]] Matrix6d rigid() const { return begin + 2.0 * mixed + end; }
};

/// Steps are small motions along and about the axes of the world, about `center_m`. A pull loses its say beyond
/// `gate_sigmas`.
[[nodiscard]] PullEquations sum_pulls(std::span<const Pull> pulls, const PoseSteps& steps,
                                      const Eigen::Vector3d& center_m, double gate_sigmas, double inlier_sigmas);

}  // namespace berm
