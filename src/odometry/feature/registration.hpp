#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "berm/core/pose.hpp"
#include "berm/odometry/feature_odometry.hpp"
#include "feature_map.hpp"
#include "feature_match.hpp"
#include "voxel_means.hpp"

namespace berm {

/// What was found out about the displacement since a known pose.
struct Registration {
  Displacement displacement = Displacement::Zero();
  bool is_sound = false;       ///< enough was matched, and the solver came to an end
  std::size_t matches = 0;     ///< of the last round
  std::size_t inliers = 0;     ///< of these, the smallest residuals
  std::size_t iterations = 0;  ///< steps of the solver over all rounds
  double weakest = 0.0;        ///< share of the residuals across the direction in which they say least, times 3: 0..1
  Matrix6d covariance = Matrix6d::Zero();  ///< of the displacement
};

/// A feature of the piece that is registered.
struct TimedFeature {
  Eigen::Vector3d base_m;  ///< frame base at its time
  double share = 1.0;      ///< of the time since the known pose
  FeatureClass kind = FeatureClass::obstacle_plane;
};

/// Moves features until they lie on the map: neighbours are found and a robust least squares problem is solved with
/// Ceres, in turns. The start is no displacement (LOAM-Livox knows no motion before).
[[nodiscard]] Registration register_features(const std::vector<TimedFeature>& features, const FeatureMap& map,
                                             const Pose& T_world_before, const FeatureOdometryConfig& config);

}  // namespace berm
