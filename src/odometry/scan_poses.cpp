#include "scan_poses.hpp"

namespace berm {

PoseSteps::PoseSteps(const ScanPoses& motion) {
  const Vector6d displacement = motion.displacement();
  for (std::size_t i = 0; i <= kSteps; ++i) {
    const double share = static_cast<double>(i) / static_cast<double>(kSteps);
    const Pose T_world_base = motion.T_world_begin * Pose::exp(share * displacement);
    steps_[i] = {T_world_base.rotation().toRotationMatrix(), T_world_base.translation_m()};
  }
}

Pose moved(const Pose& T_world_base, const Vector6d& step, const Eigen::Vector3d& center_m) {
  Vector6d turn = Vector6d::Zero();
  turn.tail<3>() = step.tail<3>();
  const Eigen::Quaterniond rotation = Pose::exp(turn).rotation();
  return {rotation * T_world_base.rotation(),
          rotation * (T_world_base.translation_m() - center_m) + center_m + step.head<3>()};
}

}  // namespace berm
