#include "pull_equations.hpp"

#include <random>
#include <vector>

#include <gtest/gtest.h>
#include <rapidcheck.h>

namespace berm {
namespace {

constexpr double kGate = 4.0;
constexpr double kInlier = 2.0;

class RandomPulls {
 public:
  explicit RandomPulls(unsigned seed) : random_(seed) {}

  double even(double low, double high) { return std::uniform_real_distribution<double>(low, high)(random_); }
  Eigen::Vector3d vector(double size) { return {even(-size, size), even(-size, size), even(-size, size)}; }

  Pull pull(const ScanPoses& motion) {
    Pull pull;
    pull.share = static_cast<double>(random_() % 65) / 64.0;  // the poses within a scan are known at 65 places
    pull.base_m = vector(20.0);
    pull.mean_m = motion.T_world_begin * pull.base_m + vector(0.1);
    if (random_() % 2 == 0) {
      pull.set_plane(vector(1.0).normalized(), even(1e-4, 1e-2));
    } else {
      Eigen::Matrix3d root;
      root << vector(30.0), vector(30.0), vector(30.0);
      pull.set_cloud(root * root.transpose() + Eigen::Matrix3d::Identity(), Eigen::Vector3d::UnitZ());
    }
    return pull;
  }

 private:
  std::mt19937 random_;
};

/// The sum as it is written down: every distance by the twelve unknowns of both poses.
struct WrittenOut {
  Eigen::Matrix<double, 12, 12> information = Eigen::Matrix<double, 12, 12>::Zero();
  Eigen::Matrix<double, 12, 1> gradient = Eigen::Matrix<double, 12, 1>::Zero();
  std::size_t inliers = 0;

  void add(const Pull& pull, const PoseSteps& steps, const Eigen::Vector3d& center_m) {
    const Eigen::Vector3d world_m = steps.to_world(pull.base_m, pull.share);
    double squared = 0.0;
    for (std::size_t i = 0; i < pull.row_count; ++i) {
      squared += std::pow(pull.rows_per_m[i].dot(world_m - pull.mean_m), 2.0);
    }
    const double weight = std::pow(1.0 / (1.0 + squared / (kGate * kGate)), 2.0);
    for (std::size_t i = 0; i < pull.row_count; ++i) {
      const Eigen::Vector3d& row = pull.rows_per_m[i];
      Vector6d one;
      one << row, (world_m - center_m).cross(row);
      Eigen::Matrix<double, 12, 1> both;
      both << (1.0 - pull.share) * one, pull.share * one;
      information += weight * both * both.transpose();
      gradient += weight * row.dot(world_m - pull.mean_m) * both;
    }
    inliers += squared < kInlier * kInlier ? 1U : 0U;
  }
};

TEST(PullEquations, AreTheSumThatIsWrittenOut) {
  EXPECT_TRUE(rc::check([] {
    RandomPulls random(*rc::gen::arbitrary<unsigned>());
    ScanPoses motion;
    motion.T_world_begin = Pose::exp((Vector6d() << random.vector(5.0), random.vector(1.0)).finished());
    motion.T_world_end =
        motion.T_world_begin * Pose::exp((Vector6d() << random.vector(0.5), random.vector(0.05)).finished());
    const PoseSteps steps(motion);
    const Eigen::Vector3d center_m = motion.T_world_begin.translation_m();
    std::vector<Pull> pulls;
    WrittenOut expected;
    for (std::size_t i = 0; i < 40; ++i) {
      pulls.push_back(random.pull(motion));
      expected.add(pulls.back(), steps, center_m);
    }
    const PullEquations sum = sum_pulls(pulls, steps, center_m, kGate, kInlier);
    const double scale = 1e-12 * expected.information.norm();
    RC_ASSERT((sum.begin - expected.information.topLeftCorner<6, 6>()).norm() < scale);
    RC_ASSERT((sum.mixed - expected.information.topRightCorner<6, 6>()).norm() < scale);
    RC_ASSERT((sum.end - expected.information.bottomRightCorner<6, 6>()).norm() < scale);
    const double gradient_scale = 1e-9 * (1.0 + expected.gradient.norm());
    RC_ASSERT((sum.begin_gradient - expected.gradient.head<6>()).norm() < gradient_scale);
    RC_ASSERT((sum.end_gradient - expected.gradient.tail<6>()).norm() < gradient_scale);
    RC_ASSERT(sum.inliers == expected.inliers);
  }));
}

TEST(PullEquations, OfNothingAreZero) {
  const PullEquations sum = sum_pulls({}, PoseSteps(ScanPoses{}), Eigen::Vector3d::Zero(), kGate, kInlier);
  EXPECT_EQ(sum.rigid(), Matrix6d::Zero());
  EXPECT_EQ(sum.end_gradient, Vector6d::Zero());
  EXPECT_EQ(sum.inliers, 0U);
}

TEST(Pull, OfACloudKnowsNothingUpwards) {
  // What is known sideways once the height is taken to be unknown: the inverse of the covariance's part across.
  Eigen::Matrix3d information_per_m2;
  information_per_m2 << 40.0, 5.0, -8.0, 5.0, 90.0, 12.0, -8.0, 12.0, 30.0;
  const Eigen::Vector3d up = Eigen::Vector3d(0.3, -0.2, 1.0).normalized();
  Pull pull;
  pull.set_cloud(information_per_m2, up);
  ASSERT_EQ(pull.row_count, 2U);
  const Eigen::Vector3d along = up.unitOrthogonal();
  Eigen::Matrix<double, 3, 2> across;
  across << along, up.cross(along);
  Eigen::Matrix<double, 2, 3> rows;
  rows << pull.rows_per_m[0].transpose(), pull.rows_per_m[1].transpose();
  EXPECT_LT((rows * up).norm(), 1e-12);
  const Eigen::Matrix2d known = across.transpose() * rows.transpose() * rows * across;
  const Eigen::Matrix2d expected = (across.transpose() * information_per_m2.inverse() * across).inverse();
  EXPECT_LT((known - expected).norm(), 1e-9);
}

}  // namespace
}  // namespace berm
