#pragma once

#include <span>

#include <Eigen/Core>

#include "berm/odometry/pose_graph.hpp"
#include "place_surfaces.hpp"

namespace berm {

/// How one place lies on another.
struct PlaceMatch {
  ClosureFate fate = ClosureFate::too_little;  ///< `used` if it may be believed by itself
  Pose T_first_second;
  Matrix6d covariance = Matrix6d::Identity();  ///< as Closure::covariance
  double overlap = 0.0;                        ///< share of the points that meet a surface
  double residual_m = 0.0;                     ///< median distance of those that do
};

/// How far off the guess may be.
struct PlaceGuess {
  Pose T_first_second;
  double reach_m = 1.0;
};

/// Lays `points` (frame of the second place) onto the surfaces of the first. Tries places all around the guess, and
/// refuses to choose where two of them fit alike.
[[nodiscard]] PlaceMatch match_places(const PlaceSurfaces& first, std::span<const Eigen::Vector3d> points,
                                      const PlaceGuess& guess, const PoseGraphConfig& config);

}  // namespace berm
