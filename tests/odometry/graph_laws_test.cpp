#include <gtest/gtest.h>
#include <rapidcheck.h>

#include "odometry/graph_made.hpp"

namespace berm {
namespace {

using Eigen::Vector3d;
using test::MadeDrive;
using test::MadeFixes;

TEST(PoseGraphLaws, MovingTheWorldMovesTheAnswer) {
  EXPECT_TRUE(rc::check([] {
    const auto seed = *rc::gen::inRange(1U, 1000U);
    const MadeDrive drive{.seconds = 40.0, .seed = seed};
    const bool has_attitude = *rc::gen::arbitrary<bool>();
    auto fixes = test::moved(MadeFixes{.has_attitude = has_attitude, .seed = seed + 1}.of(drive), 20.0, 22.0,
                             Vector3d(3.0, 1.0, 0.0));
    // Up stays up: how the machine stands helps where fixes say nothing.
    const Pose move = Pose::from_yaw_pitch_roll(*rc::gen::inRange(-314, 315) * 0.01, 0.0, 0.0,
                                                Vector3d(*rc::gen::inRange(-5000, 5000), 4000.0, -300.0));
    const auto odometry = drive.odometry();
    const PoseGraphResult here = solve_pose_graph(odometry, fixes, {}, {});
    for (Fix& fix : fixes) {
      fix.position_m = move * fix.position_m;
      if (fix.R_world_base) {
        fix.R_world_base = move.rotation() * *fix.R_world_base;
      }
    }
    const PoseGraphResult there = solve_pose_graph(odometry, fixes, {}, {});
    RC_ASSERT(here.fixes == there.fixes);
    for (std::size_t i = 0; i < here.trajectory.size(); ++i) {
      const Pose expected = move * here.trajectory.poses()[i].T_world_base;
      RC_ASSERT((expected.inverse() * there.trajectory.poses()[i].T_world_base).log().norm() < 1e-3);
    }
  }));
}

TEST(PoseGraphLaws, WithoutFixesAndClosuresTheOdometryComesBack) {
  EXPECT_TRUE(rc::check([] {
    const auto seed = *rc::gen::inRange(1U, 1000U);
    const MadeDrive drive{.seconds = *rc::gen::inRange(1, 60) * 1.0, .seed = seed};
    const auto odometry = drive.odometry();
    const PoseGraphResult result = solve_pose_graph(odometry, {}, {}, {});
    RC_ASSERT(!result.is_in_world);
    RC_ASSERT(result.trajectory.size() == odometry.size());
    for (std::size_t i = 0; i < odometry.size(); ++i) {
      RC_ASSERT(result.trajectory.poses()[i].stamp_ns == odometry[i].stamp_ns);
      RC_ASSERT(result.trajectory.poses()[i].T_world_base.matrix() == odometry[i].T_odom_base.matrix());
    }
  }));
}

TEST(PoseGraphLaws, TheSameTwice) {
  const MadeDrive drive{.seconds = 100.0};
  const auto fixes = test::moved(MadeFixes{}.of(drive), 30.0, 35.0, Vector3d(5.0, 5.0, 1.0));
  const auto odometry = drive.odometry();
  const PoseGraphResult one = solve_pose_graph(odometry, fixes, {}, {});
  const PoseGraphResult two = solve_pose_graph(odometry, fixes, {}, {});
  for (std::size_t i = 0; i < one.trajectory.size(); ++i) {
    EXPECT_EQ(one.trajectory.poses()[i].T_world_base.matrix(), two.trajectory.poses()[i].T_world_base.matrix());
  }
}

TEST(PoseGraphLaws, TheOrderOfFixesDoesNotMatter) {
  const MadeDrive drive{.seconds = 60.0};
  auto fixes = MadeFixes{}.of(drive);
  const auto odometry = drive.odometry();
  const PoseGraphResult one = solve_pose_graph(odometry, fixes, {}, {});
  std::reverse(fixes.begin(), fixes.end());
  const PoseGraphResult two = solve_pose_graph(odometry, fixes, {}, {});
  EXPECT_LT((one.trajectory.poses()[300].T_world_base.translation_m() -
             two.trajectory.poses()[300].T_world_base.translation_m())
                .norm(),
            1e-6);
}

}  // namespace
}  // namespace berm
