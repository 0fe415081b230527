#include "scan_poses.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

namespace berm {
namespace {

Pose any_pose() {
  const auto unit = [] { return *rc::gen::inRange(-1000, 1001) * 1e-3; };
  Vector6d twist;
  twist << 5.0 * unit(), 5.0 * unit(), 5.0 * unit(), unit(), unit(), unit();
  return Pose::exp(twist);
}

TEST(ScanPoses, StepsEndWhereTheMotionDoes) {
  EXPECT_TRUE(rc::check([] {
    const ScanPoses motion{any_pose(), any_pose()};
    const PoseSteps steps(motion);
    const Eigen::Vector3d point_m(1.0, 2.0, 3.0);
    RC_ASSERT((steps.to_world(point_m, 0.0) - motion.T_world_begin * point_m).norm() < 1e-9);
    RC_ASSERT((steps.to_world(point_m, 1.0) - motion.T_world_end * point_m).norm() < 1e-9);
    const Pose middle = interpolate(motion.T_world_begin, motion.T_world_end, 0.5);
    RC_ASSERT((steps.to_world(point_m, 0.5) - middle * point_m).norm() < 1e-9);
  }));
}

TEST(ScanPoses, MovedTurnsAboutTheCenter) {
  EXPECT_TRUE(rc::check([] {
    const Pose T_world_base = any_pose();
    const Eigen::Vector3d center_m = any_pose().translation_m();
    Vector6d step = any_pose().log();
    step.head<3>().setZero();
    // What lies at the center stays there.
    const Eigen::Vector3d base_m = T_world_base.inverse() * center_m;
    RC_ASSERT((moved(T_world_base, step, center_m) * base_m - center_m).norm() < 1e-9);
    step.head<3>() = Eigen::Vector3d(1.0, -2.0, 0.5);
    RC_ASSERT((moved(T_world_base, step, center_m) * base_m - center_m - step.head<3>()).norm() < 1e-9);
  }));
}

}  // namespace
}  // namespace berm
