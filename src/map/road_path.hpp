#pragma once

#include <cstdint>
#include <vector>

#include <Eigen/Core>

#include "berm/core/pose_guard.hpp"
#include "berm/core/stamp.hpp"
#include "berm/core/trajectory.hpp"

namespace berm {

/// A place on the driven path that is measured.
struct RoadPlace {
  Eigen::Vector3d position_m = Eigen::Vector3d::Zero();
  Eigen::Vector2d ahead = Eigen::Vector2d::UnitX();  ///< horizontally, the way that was driven; unit length
  double chainage_m = 0.0;
  std::uint32_t piece = 0;
  Stamp stamp_ns = 0;  ///< when it was driven over

  /// Along the path and to the left of it.
  [[nodiscard]] Eigen::Vector2d in_path(const Eigen::Vector3d& point_m) const {
    const Eigen::Vector2d from_here = (point_m - position_m).head<2>();
    return {from_here.dot(ahead), ahead.x() * from_here.y() - ahead.y() * from_here.x()};
  }
};

/// Places every `spacing_m` along the pieces of the path, see RoadSurvey; stamps and chainages never fall.
[[nodiscard]] std::vector<RoadPlace> lay_places(const Trajectory& path, const PoseGuardConfig& guard, double spacing_m);

}  // namespace berm
