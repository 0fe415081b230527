#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "berm/odometry/pose_graph.hpp"
#include "berm/odometry/pose_graph_places.hpp"

namespace berm {

/// A scan of the way, thinned.
struct SeenScan {
  std::size_t step = 0;                   ///< index of its OdometryStep
  Pose T_odom_base;                       ///< as it was first known
  std::vector<Eigen::Vector3f> points_m;  ///< frame of the base at the stamp of the scan
};

/// As PlaceMemory::find. `scans`: steps rise.
[[nodiscard]] FoundClosures search_closures(std::span<const SeenScan> scans, std::span<const OdometryStep> odometry,
                                            const PoseGraphResult& estimate, const PoseGraphConfig& config);

}  // namespace berm
