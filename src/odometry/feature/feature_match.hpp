#pragma once

#include <Eigen/Core>

#include "berm/core/pose.hpp"

namespace berm {

/// Displacement of the machine since a known pose, along the axes of that pose: translation (m), then rotation vector
/// (rad). A point at share s of the time since then was taken after s times the translation and the rotation vector.
using Displacement = Vector6d;

/// Where a point of the base, taken at `share`, lies in the frame of the known pose.
[[nodiscard]] Eigen::Vector3d displaced_m(const Displacement& displacement, const Eigen::Vector3d& base_m,
                                          double share);

/// A feature and what it was matched with: all in the frames of the known pose, so that nothing but the displacement
/// is unknown.
struct FeatureMatch {
  Eigen::Vector3d base_m;    ///< the feature, frame base at its time
  double share = 1.0;        ///< of the time since the known pose at which it was taken
  Eigen::Vector3d anchor_m;  ///< a point of the plane or line
  Eigen::Vector3d axis;      ///< normal of the plane, direction of the line: unit length
  bool on_line = false;
};

/// Distance to the plane with its sign (P eq. 11) or to the line (P eq. 12), m. `gradient`, if not null: its derivative
/// by the displacement.
[[nodiscard]] double residual_m(const FeatureMatch& match, const Displacement& displacement, Vector6d* gradient);

}  // namespace berm
