#pragma once

#include <array>
#include <cstddef>

#include <Eigen/Core>

#include "berm/core/pose.hpp"

namespace berm {

/// How the base moved during a scan: on a screw from one pose to the other.
struct ScanPoses {
  Pose T_world_begin;
  Pose T_world_end;

  /// From begin to end, in the frame of the base.
  [[nodiscard]] Vector6d displacement() const { return (T_world_begin.inverse() * T_world_end).log(); }
};

/// The poses within a scan, in steps that are short against its noise: 64 steps of 2 m are 3 cm each.
class PoseSteps {
 public:
  explicit PoseSteps(const ScanPoses& motion);

  [[nodiscard]] Eigen::Vector3d to_world(const Eigen::Vector3d& base_m, double share) const {
    const Step& step = steps_[static_cast<std::size_t>(share * kSteps + 0.5)];
    return step.R_world_base * base_m + step.translation_m;
  }
  [[nodiscard]] Eigen::Vector3d turned_to_world(const Eigen::Vector3d& base, double share) const {
    return steps_[static_cast<std::size_t>(share * kSteps + 0.5)].R_world_base * base;
  }
  /// The z axis of the base in the middle of the scan.
  [[nodiscard]] Eigen::Vector3d up() const { return steps_[kSteps / 2].R_world_base.col(2); }

 private:
  static constexpr std::size_t kSteps = 64;
  struct Step {
    Eigen::Matrix3d R_world_base;
    Eigen::Vector3d translation_m;
  };
  std::array<Step, kSteps + 1> steps_;
};

/// `T` after it was turned about `center_m` by a rotation vector and moved: both along the axes of the world.
[[nodiscard]] Pose moved(const Pose& T_world_base, const Vector6d& step, const Eigen::Vector3d& center_m);

}  // namespace berm
