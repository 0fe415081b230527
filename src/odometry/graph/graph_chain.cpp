#include "graph_chain.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "berm/core/error.hpp"

namespace berm {
namespace {

/// Longer between two scans, and nothing is known of the motion there. The slowest sensors take 2 scans a second.
constexpr double kLongestGap_s = 1.5;
/// What an odometry is off even on the shortest way: the noise of its own surfaces.
constexpr double kLeast_m = 0.004;
constexpr double kLeast_rad = 0.0005;
/// Of a machine whose scan was lost: the motion before it went on, roughly.
constexpr double kLost_mps = 0.7;
constexpr double kLost_radps = 0.15;
/// Across a break the machine may have done anything that machines do.
constexpr double kBroken_m = 5.0;
constexpr double kBroken_mps = 10.0;
constexpr double kBroken_rad = 1.0;
/// A weak scan without a covariance drifts so many times as fast.
constexpr double kWeakFactor = 5.0;

double gap_s(const OdometryStep& from, const OdometryStep& to) {
  return to_seconds(to.stamp_ns - from.stamp_ns);
}

bool is_break(const OdometryStep& from, const OdometryStep& to) {
  return from.session != to.session || gap_s(from, to) > kLongestGap_s;
}

/// What the scan itself does not know, on the axes of a link: the odometry gives it along the axes of its world.
Matrix6d scan_covariance(const OdometryStep& step) {
  Matrix6d turned = Matrix6d::Zero();
  const Eigen::Matrix3d R = step.T_odom_base.rotation().toRotationMatrix();
  for (Eigen::Index i = 0; i < 2; ++i) {
    for (Eigen::Index j = 0; j < 2; ++j) {
      turned.block<3, 3>(3 * i, 3 * j) = R.transpose() * step.covariance.block<3, 3>(3 * i, 3 * j) * R;
    }
  }
  return 0.5 * (turned + turned.transpose());
}

Matrix6d diagonal(double move_m2, double turn_rad2) {
  Matrix6d m = Matrix6d::Zero();
  m.diagonal() << move_m2, move_m2, move_m2, turn_rad2, turn_rad2, turn_rad2;
  return m;
}

/// `path_m` is the way along the steps from `a` to `b`.
ChainLink make_link(std::span<const OdometryStep> odometry, std::size_t a, std::size_t b, double path_m,
                    const PoseGraphConfig& config) {
  ChainLink link{odometry[a].T_odom_base.inverse() * odometry[b].T_odom_base, Matrix6d::Zero()};
  double move_m2 = kLeast_m * kLeast_m + config.drift_m_per_sqrt_m * config.drift_m_per_sqrt_m * path_m;
  double turn_rad2 = kLeast_rad * kLeast_rad + config.drift_rad_per_sqrt_m * config.drift_rad_per_sqrt_m * path_m;
  Matrix6d unseen = Matrix6d::Zero();
  for (std::size_t i = a + 1; i <= b; ++i) {
    const OdometryStep& step = odometry[i];
    const double dt_s = gap_s(odometry[i - 1], step);
    if (is_break(odometry[i - 1], step)) {
      link.is_broken = true;
      move_m2 += std::pow(kBroken_m + kBroken_mps * dt_s, 2);
      turn_rad2 += kBroken_rad * kBroken_rad;
    } else if (step.health == OdometryHealth::lost) {
      move_m2 += std::pow(kLost_mps * dt_s, 2);
      turn_rad2 += std::pow(kLost_radps * dt_s, 2);
    } else if (step.health == OdometryHealth::weak) {
      const bool is_known = step.covariance.allFinite() && step.covariance.trace() > 0.0;
      if (is_known) {
        unseen = scan_covariance(step);  // that of the last: a covariance of a scan is one against the map
      } else {
        const double dp_m = (step.T_odom_base.translation_m() - odometry[i - 1].T_odom_base.translation_m()).norm();
        move_m2 += std::pow(kWeakFactor * config.drift_m_per_sqrt_m, 2) * dp_m;
        turn_rad2 += std::pow(kWeakFactor * config.drift_rad_per_sqrt_m, 2) * dp_m;
      }
    }
  }
  link.covariance = diagonal(move_m2, turn_rad2) + unseen;
  return link;
}

double turn_rad(const Pose& from, const Pose& to) {
  return from.rotation().angularDistance(to.rotation());
}

}  // namespace

void check_odometry(std::span<const OdometryStep> odometry) {
  for (std::size_t i = 0; i < odometry.size(); ++i) {
    if (i > 0 && odometry[i].stamp_ns <= odometry[i - 1].stamp_ns) {
      throw Error(ErrorCode::invalid_argument,
                  "stamps of the odometry must strictly increase, step " + std::to_string(i) + " does not");
    }
    if (!odometry[i].T_odom_base.matrix().allFinite()) {
      throw Error(ErrorCode::invalid_argument, "pose " + std::to_string(i) + " of the odometry is not finite");
    }
  }
}

GraphChain make_chain(std::span<const OdometryStep> odometry, const PoseGraphConfig& config) {
  GraphChain chain;
  double path_m = 0.0;
  double node_path_m = 0.0;
  for (std::size_t i = 0; i < odometry.size(); ++i) {
    const OdometryStep& step = odometry[i];
    if (i > 0 && odometry[i - 1].session == step.session) {
      path_m += (step.T_odom_base.translation_m() - odometry[i - 1].T_odom_base.translation_m()).norm();
    }
    const bool starts = i == 0 || is_break(odometry[i - 1], step);
    const bool ends = i + 1 == odometry.size() || is_break(step, odometry[i + 1]);
    const bool is_node = starts || ends || step.health == OdometryHealth::lost ||
                         path_m - node_path_m >= config.keyframe_m ||
                         turn_rad(odometry[chain.steps.back()].T_odom_base, step.T_odom_base) >= config.keyframe_rad;
    if (!is_node) {
      continue;
    }
    if (!chain.steps.empty()) {
      chain.links.push_back(make_link(odometry, chain.steps.back(), i, path_m - node_path_m, config));
    }
    chain.steps.push_back(i);
    chain.path_m.push_back(path_m);
    node_path_m = path_m;
  }
  return chain;
}

std::optional<OdometryClock::Place> OdometryClock::at(Stamp stamp_ns) const {
  const auto after = std::upper_bound(odometry_.begin(), odometry_.end(), stamp_ns,
                                      [](Stamp stamp, const OdometryStep& step) { return stamp < step.stamp_ns; });
  if (after == odometry_.begin()) {
    return std::nullopt;
  }
  const auto before = after - 1;
  const auto step = static_cast<std::size_t>(before - odometry_.begin());
  if (before->stamp_ns == stamp_ns) {
    return Place{before->T_odom_base, step};
  }
  if (after == odometry_.end() || is_break(*before, *after)) {
    return std::nullopt;
  }
  const double share = to_seconds(stamp_ns - before->stamp_ns) / gap_s(*before, *after);
  return Place{interpolate(before->T_odom_base, after->T_odom_base, share), step};
}

}  // namespace berm
