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
/// Smaller steps change nothing that a map could show.
constexpr double kSmallStep_m = 1e-3;
constexpr double kSmallStep_rad = 1e-4;
/// With less of a scan on the map, chance could have put it there.
constexpr double kLeastInlierShare = 0.15;
constexpr std::size_t kLeastInliers = 50;

/// Geman and McClure's weight of a residual at `gates` times the gate.
double robust_weight(double gates_squared) {
  const double u = 1.0 / (1.0 + gates_squared);
  return u * u;
}

/// The information that is left if nothing is known along `direction`: that of the marginal distribution.
Eigen::Matrix3d without_direction(const Eigen::Matrix3d& information, const Eigen::Vector3d& direction) {
  const Eigen::Vector3d along = information * direction;
  return information - along * along.transpose() / direction.dot(along);
}

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

struct ScanMatcher::Equations {
  Matrix6d begin = Matrix6d::Zero();
  Matrix6d mixed = Matrix6d::Zero();
  Matrix6d end = Matrix6d::Zero();
  Vector6d begin_gradient = Vector6d::Zero();
  Vector6d end_gradient = Vector6d::Zero();
  std::size_t inliers = 0;

  void add(const Matrix6d& information, const Vector6d& gradient, double share) {
    const double rest = 1.0 - share;
    begin += rest * rest * information;
    mixed += rest * share * information;
    end += share * share * information;
    begin_gradient += rest * gradient;
    end_gradient += share * gradient;
  }
  /// As if both poses were moved alike.
  [[nodiscard]] Matrix6d rigid() const { return begin + 2.0 * mixed + end; }
};

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
    Pull pull{.shape = hit.cell->shape(), .share = sample.share, .base_m = sample.base_m, .mean_m = hit.mean_m};
    if (pull.shape == SurfaceShape::plane) {
      pull.normal = hit.cell->normal().cast<double>();
      pull.variance_m2 = noise_m2 + static_cast<double>(hit.cell->thickness_m2());
    } else {
      pull.information_per_m2 = without_direction(hit.cell->information_per_m2().cast<double>(), up);
    }
    pulls_.push_back(pull);
  }
}

void ScanMatcher::add_plane(const Pull& pull, const Eigen::Vector3d& world_m, const Eigen::Vector3d& center_m,
                            double gate, Equations& equations) {
  const double distance_m = pull.normal.dot(world_m - pull.mean_m);
  const double sigmas_squared = distance_m * distance_m / pull.variance_m2;
  const double weight = robust_weight(sigmas_squared / (gate * gate)) / pull.variance_m2;
  Vector6d jacobian;
  jacobian << pull.normal, (world_m - center_m).cross(pull.normal);
  const Vector6d weighted = weight * jacobian;
  equations.add(jacobian * weighted.transpose(), distance_m * weighted, pull.share);
  equations.inliers += sigmas_squared < kGate * kGate ? 1U : 0U;
}

void ScanMatcher::add_cloud(const Pull& pull, const Eigen::Vector3d& world_m, const Eigen::Vector3d& center_m,
                            double gate, Equations& equations) {
  const Eigen::Vector3d error_m = world_m - pull.mean_m;
  const double sigmas_squared = error_m.dot(pull.information_per_m2 * error_m);
  const Eigen::Matrix3d information = robust_weight(sigmas_squared / (gate * gate)) * pull.information_per_m2;
  const Eigen::Matrix<double, 3, 6> jacobian = lever(world_m, center_m).topRows<3>();
  const Eigen::Matrix<double, 6, 3> weighted = jacobian.transpose() * information;
  equations.add(weighted * jacobian, weighted * error_m, pull.share);
  equations.inliers += sigmas_squared < kGate * kGate ? 1U : 0U;
}

ScanMatcher::Equations ScanMatcher::weigh(const PoseSteps& steps, const Eigen::Vector3d& center_m, double gate) const {
  Equations equations;
  for (const Pull& pull : pulls_) {
    const Eigen::Vector3d world_m = steps.to_world(pull.base_m, pull.share);
    if (pull.shape == SurfaceShape::plane) {
      add_plane(pull, world_m, center_m, gate, equations);
    } else {
      add_cloud(pull, world_m, center_m, gate, equations);
    }
  }
  const double facts = 1.0 / config_.points_per_fact;
  equations.begin *= facts;
  equations.mixed *= facts;
  equations.end *= facts;
  equations.begin_gradient *= facts;
  equations.end_gradient *= facts;
  return equations;
}

ScanMatch ScanMatcher::match(std::span<const ScanPoint> samples, const Surfaces& map, const MotionPrior& prior) {
  ScanMatch result{.motion = prior.expected};
  ScanPoses& motion = result.motion;
  double gate = kFirstGate;
  for (std::size_t i = 0; i < kLookups * kStepsPerLookup; ++i) {
    const PoseSteps steps(motion);
    if (i % kStepsPerLookup == 0) {
      find_pulls(samples, map, steps);
    }
    const Eigen::Vector3d center_m = 0.5 * (motion.T_world_begin.translation_m() + motion.T_world_end.translation_m());
    const Equations equations = weigh(steps, center_m, gate);
    gate = std::max(kGate, kGateShrinks * gate);

    const PriorTerms terms = prior_terms(prior, motion, center_m);
    Matrix12d information = terms.information;
    information.topLeftCorner<6, 6>() += equations.begin;
    information.topRightCorner<6, 6>() += equations.mixed;
    information.bottomLeftCorner<6, 6>() += equations.mixed;
    information.bottomRightCorner<6, 6>() += equations.end;
    Vector12d gradient = terms.gradient;
    gradient.head<6>() += equations.begin_gradient;
    gradient.tail<6>() += equations.end_gradient;
    const Eigen::LDLT<Matrix12d> solver(information);
    const Vector12d step = -solver.solve(gradient);
    if (!step.allFinite()) {
      return result;
    }
    motion.T_world_begin = moved(motion.T_world_begin, step.head<6>(), center_m);
    motion.T_world_end = moved(motion.T_world_end, step.tail<6>(), center_m);

    result.iterations = i + 1;
    result.inliers = equations.inliers;
    result.weakest = weakest_share(equations.rigid(), terms.of_displacement);
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
