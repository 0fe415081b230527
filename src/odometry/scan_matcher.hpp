#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "berm/odometry/odometry.hpp"
#include "berm/odometry/surface_odometry.hpp"
#include "pull_equations.hpp"
#include "scan_points.hpp"
#include "scan_poses.hpp"
#include "surface_map.hpp"

namespace berm {

/// What is expected of a scan's motion before the scan is looked at, and how surely.
struct MotionPrior {
  ScanPoses expected;
  Vector6d begin_sigma;         ///< of T_world_begin, along the axes of the world
  Vector6d displacement_sigma;  ///< of the displacement during the scan, frame of the base
};

/// Sigmas for a `MotionPrior`: the same along all axes.
[[nodiscard]] Vector6d motion_sigmas(double translation_m, double rotation_rad);

struct ScanMatch {
  ScanPoses motion;
  Matrix6d covariance = Matrix6d::Zero();  ///< of T_world_end
  double weakest = 0.0;
  std::size_t met = 0;  ///< samples for which the map has a surface
  std::size_t inliers = 0;
  std::size_t iterations = 0;
  bool is_sound = false;  ///< enough inliers, and finite
};

/// Moves the two poses of a scan until its samples lie on the surfaces of the map.
class ScanMatcher {
 public:
  explicit ScanMatcher(const SurfaceOdometryConfig& config) : config_(config) {}

  [[nodiscard]] ScanMatch match(std::span<const ScanPoint> samples, const Surfaces& map, const MotionPrior& prior);

 private:
  void find_pulls(std::span<const ScanPoint> samples, const Surfaces& map, const PoseSteps& steps);

  SurfaceOdometryConfig config_;
  std::vector<Pull> pulls_;
};

}  // namespace berm
