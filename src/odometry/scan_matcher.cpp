#include "scan_matcher.hpp"

#include <algorithm>
#include <cmath>

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>

namespace berm {
namespace {

using Matrix12d = Eigen::Matrix<double, 12, 12>;
using Vector12d = Eigen::Matrix<double, 12, 1>;

/// Surfaces are looked up so often, and so many steps are taken with each.
constexpr std::size_t kLookups = 4;
constexpr std::size_t kStepsPerLookup = 2;
/// A sample farther from its surface than so many sigmas loses its say, at first more of them.
constexpr double kGate = 3.0;
constexpr double kFirstGate = 9.0;
constexpr double kGateShrinks = 0.7;
/// Beams that fan out into a crown end at random depths, in a plane that holds the beams: one of the sensor, which
/// comes along with it. So planes that are seen edge on tell nothing, but for the ground. Sine of the angle between
/// both.
constexpr double kEdgeOn = 0.15;
/// Points along a ring err together, and the next scan draws the ring anew: the pitch that it tells wanders, and the
/// road in the map bends with it. The say of a point as a share of one that is scattered.
constexpr double kRingSay = 0.2;
/// Smaller steps change nothing that a map could show.
constexpr double kSmallStep_m = 1e-3;
constexpr double kSmallStep_rad = 1e-4;
/// With less of a scan on the map, chance could have put it there.
constexpr double kLeastInlierShare = 0.15;
constexpr std::size_t kLeastInliers = 50;

/// How a pose moves at `about_m` if the step is taken about `center_m`.
Matrix6d lever(const Eigen::Vector3d& about_m, const Eigen::Vector3d& center_m) {
  const Eigen::Vector3d arm_m = about_m - center_m;
  Matrix6d jacobian = Matrix6d::Identity();
  jacobian.topRightCorner<3, 3>() << 0.0, arm_m.z(), -arm_m.y(),  //
      -arm_m.z(), 0.0, arm_m.x(),                                 //
      arm_m.y(), -arm_m.x(), 0.0;
  return jacobian;
}

/// What is left of `pose` against `expected`, along the axes of the world.
Vector6d difference(const Pose& pose, const Pose& expected) {
  Vector6d result;
  result << pose.translation_m() - expected.translation_m(),
      Pose(pose.rotation() * expected.rotation().conjugate(), Eigen::Vector3d::Zero()).log().tail<3>();
  return result;
}

/// The share of the information that `data` brings in the direction in which it brings least.
double weakest_share(const Matrix6d& data, const Matrix6d& prior) {
  const Eigen::GeneralizedSelfAdjointEigenSolver<Matrix6d> solver(data, prior, Eigen::EigenvaluesOnly);
  if (solver.info() != Eigen::Success) {
    return 0.0;
  }
  const double ratio = std::max(0.0, solver.eigenvalues()[0]);
  return ratio / (1.0 + ratio);
}

/// The prior as a part of the normal equations, and alone.
struct PriorTerms {
  Matrix12d information = Matrix12d::Zero();
  Vector12d gradient = Vector12d::Zero();
  Matrix6d of_displacement = Matrix6d::Zero();  ///< information on the displacement, axes of the world
};

PriorTerms prior_terms(const MotionPrior& prior, const ScanPoses& motion, const Eigen::Vector3d& center_m) {
  PriorTerms terms;
  const Matrix6d begin = lever(motion.T_world_begin.translation_m(), center_m);
  const Matrix6d end = lever(motion.T_world_end.translation_m(), center_m);

  const Vector6d begin_weight = prior.begin_sigma.cwiseAbs2().cwiseInverse();
  const Vector6d begin_error = difference(motion.T_world_begin, prior.expected.T_world_begin);
  terms.information.topLeftCorner<6, 6>() += begin.transpose() * begin_weight.asDiagonal() * begin;
  terms.gradient.head<6>() += begin.transpose() * begin_weight.cwiseProduct(begin_error);

  const Vector6d weight = prior.displacement_sigma.cwiseAbs2().cwiseInverse();
  const Vector6d error = motion.displacement() - prior.expected.displacement();
  Matrix6d R_base_world = Matrix6d::Zero();
  R_base_world.topLeftCorner<3, 3>() = motion.T_world_begin.rotation().conjugate().toRotationMatrix();
  R_base_world.bottomRightCorner<3, 3>() = R_base_world.topLeftCorner<3, 3>();
  Eigen::Matrix<double, 6, 12> jacobian;
  jacobian << -R_base_world * begin, R_base_world * end;
  terms.information += jacobian.transpose() * weight.asDiagonal() * jacobian;
  terms.gradient += jacobian.transpose() * weight.cwiseProduct(error);
  terms.of_displacement = R_base_world.transpose() * weight.asDiagonal() * R_base_world;
  return terms;
}

}  // namespace

Vector6d motion_sigmas(double translation_m, double rotation_rad) {
  Vector6d result;
  result << Eigen::Vector3d::Constant(translation_m), Eigen::Vector3d::Constant(rotation_rad);
  return result;
}

void ScanMatcher::find_pulls(std::span<const ScanPoint> samples, const Surfaces& map, const PoseSteps& steps) {
  pulls_.clear();
  const double noise_m2 = config_.noise_m * config_.noise_m;
  // The rings of a sensor lie at the same height on a wall wherever the machine is: clouds say nothing of height.
  const Eigen::Vector3d up = steps.up();
  for (const ScanPoint& sample : samples) {
    const SurfaceHit hit = map.find(steps.to_world(sample.base_m, sample.share), sample.is_ground);
    if (hit.cell == nullptr) {
      continue;
    }
    const double say = hit.say * (sample.is_on_ring ? kRingSay : 1.0);
    Pull pull{.share = sample.share, .base_m = sample.base_m, .mean_m = hit.mean_m};
    if (hit.cell->shape() == SurfaceShape::plane) {
      const Eigen::Vector3d normal = hit.cell->normal().cast<double>();
      if (!sample.is_ground &&
          std::abs(normal.dot(steps.turned_to_world(sample.ray.cast<double>(), sample.share))) < kEdgeOn) {
        continue;
      }
      pull.set_plane(normal, (noise_m2 + static_cast<double>(hit.cell->thickness_m2())) / say);
    } else {
      pull.set_cloud(say * hit.cell->information_per_m2().cast<double>(), up);
    }
    pulls_.push_back(pull);
  }
}

ScanMatch ScanMatcher::match(std::span<const ScanPoint> samples, const Surfaces& map, const MotionPrior& prior) {
  ScanMatch result{.motion = prior.expected};
  ScanPoses& motion = result.motion;
  const double facts = 1.0 / config_.points_per_fact;
  double gate = kFirstGate;
  for (std::size_t i = 0; i < kLookups * kStepsPerLookup; ++i) {
    const PoseSteps steps(motion);
    if (i % kStepsPerLookup == 0) {
      find_pulls(samples, map, steps);
    }
    const Eigen::Vector3d center_m = 0.5 * (motion.T_world_begin.translation_m() + motion.T_world_end.translation_m());
    const PullEquations equations = sum_pulls(pulls_, steps, center_m, gate, kGate);
    gate = std::max(kGate, kGateShrinks * gate);

    const PriorTerms terms = prior_terms(prior, motion, center_m);
    Matrix12d information = terms.information;
    information.topLeftCorner<6, 6>() += facts * equations.begin;
    information.topRightCorner<6, 6>() += facts * equations.mixed;
    information.bottomLeftCorner<6, 6>() += facts * equations.mixed;
    information.bottomRightCorner<6, 6>() += facts * equations.end;
    Vector12d gradient = terms.gradient;
    gradient.head<6>() += facts * equations.begin_gradient;
    gradient.tail<6>() += facts * equations.end_gradient;
    const Eigen::LDLT<Matrix12d> solver(information);
    const Vector12d step = -solver.solve(gradient);
    if (!step.allFinite()) {
      return result;
    }
    motion.T_world_begin = moved(motion.T_world_begin, step.head<6>(), center_m);
    motion.T_world_end = moved(motion.T_world_end, step.tail<6>(), center_m);

    result.iterations = i + 1;
    result.met = pulls_.size();
    result.inliers = equations.inliers;
    result.weakest = weakest_share(facts * equations.rigid(), terms.of_displacement);
    result.covariance = solver.solve(Matrix12d::Identity()).bottomRightCorner<6, 6>();
    const bool is_small =
        step.tail<6>().head<3>().norm() < kSmallStep_m && step.tail<6>().tail<3>().norm() < kSmallStep_rad;
    if (is_small && gate <= kGate) {
      break;
    }
  }
  result.is_sound = result.inliers >= kLeastInliers &&
                    static_cast<double>(result.inliers) >= kLeastInlierShare * static_cast<double>(samples.size());
  return result;
}

}  // namespace berm
