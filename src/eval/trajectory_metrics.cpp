#include "berm/eval/trajectory_metrics.hpp"

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>
#include <Eigen/SVD>

#include "berm/core/angle.hpp"

namespace berm {
namespace {

/// Fewer points leave the alignment free to hide any error.
constexpr std::size_t kMinPairs = 3;

/// Truth's path from the first pair to each.
std::vector<double> path_lengths(std::span<const PosePair> pairs) {
  std::vector<double> lengths_m(pairs.size(), 0.0);
  for (std::size_t i = 1; i < pairs.size(); ++i) {
    const double step_m = (pairs[i].truth.translation_m() - pairs[i - 1].truth.translation_m()).norm();
    lengths_m[i] = lengths_m[i - 1] + step_m;
  }
  return lengths_m;
}

/// What is left when truth's motion from `from` to `to` is taken from the estimate's.
Pose motion_error(const PosePair& from, const PosePair& to) {
  const Pose true_motion = from.truth.inverse() * to.truth;
  const Pose motion = from.estimate.inverse() * to.estimate;
  return true_motion.inverse() * motion;
}

}  // namespace

std::vector<PosePair> pair_poses(const Trajectory& estimate, const Trajectory& truth) {
  std::vector<PosePair> pairs;
  for (const StampedPose& pose : estimate.poses()) {
    if (const auto true_pose = truth.at(pose.stamp_ns)) {
      pairs.push_back({pose.T_world_base, *true_pose});
    }
  }
  return pairs;
}

std::optional<double> absolute_error_m(std::span<const PosePair> pairs) {
  if (pairs.size() < kMinPairs) {
    return std::nullopt;
  }
  const auto columns = static_cast<Eigen::Index>(pairs.size());
  Eigen::Matrix3Xd estimate(3, columns);
  Eigen::Matrix3Xd truth(3, columns);
  for (Eigen::Index i = 0; i < columns; ++i) {
    const PosePair& pair = pairs[static_cast<std::size_t>(i)];
    estimate.col(i) = pair.estimate.translation_m();
    truth.col(i) = pair.truth.translation_m();
  }
  // Both about their own means: coordinates far from the origin (UTM) would cost digits.
  estimate.colwise() -= Eigen::Vector3d(estimate.rowwise().mean());
  truth.colwise() -= Eigen::Vector3d(truth.rowwise().mean());
  const Eigen::Matrix4d T_truth_estimate = Eigen::umeyama(estimate, truth, false);
  const Eigen::Matrix3Xd rest =
      (T_truth_estimate.topLeftCorner<3, 3>() * estimate).colwise() + T_truth_estimate.topRightCorner<3, 1>().eval();
  return std::sqrt((rest - truth).colwise().squaredNorm().mean());
}

double path_length_m(std::span<const PosePair> pairs) {
  return pairs.empty() ? 0.0 : path_lengths(pairs).back();
}

std::vector<RelativeError> relative_errors(std::span<const PosePair> pairs, std::span<const double> lengths_m) {
  const std::vector<double> path_m = path_lengths(pairs);
  std::vector<RelativeError> errors;
  for (const double length_m : lengths_m) {
    RelativeError error{.length_m = length_m};
    for (std::size_t from = 0; from < pairs.size(); ++from) {
      const auto to = std::lower_bound(path_m.begin(), path_m.end(), path_m[from] + length_m);
      if (to == path_m.end()) {
        break;
      }
      const Pose wrong = motion_error(pairs[from], pairs[static_cast<std::size_t>(to - path_m.begin())]);
      const double stretch_m = *to - path_m[from];
      error.translation_percent += 100.0 * wrong.translation_m().norm() / stretch_m;
      error.rotation_deg_per_m += kDegPerRad * wrong.log().tail<3>().norm() / stretch_m;
      ++error.stretches;
    }
    if (error.stretches > 0) {
      error.translation_percent /= static_cast<double>(error.stretches);
      error.rotation_deg_per_m /= static_cast<double>(error.stretches);
      errors.push_back(error);
    }
  }
  return errors;
}

std::optional<RelativeError> mean_error(std::span<const RelativeError> errors) {
  RelativeError mean;
  for (const RelativeError& error : errors) {
    const auto weight = static_cast<double>(error.stretches);
    mean.translation_percent += weight * error.translation_percent;
    mean.rotation_deg_per_m += weight * error.rotation_deg_per_m;
    mean.stretches += error.stretches;
  }
  if (mean.stretches == 0) {
    return std::nullopt;
  }
  mean.translation_percent /= static_cast<double>(mean.stretches);
  mean.rotation_deg_per_m /= static_cast<double>(mean.stretches);
  return mean;
}

}  // namespace berm
