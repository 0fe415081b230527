#include "fix_groups.hpp"

#include <algorithm>
#include <cmath>

#include "rotations.hpp"

namespace berm {
namespace {

/// Errors of fixes last for seconds, so that many are hardly better than a few.
constexpr double kFacts = 4.0;
/// What any two fixes may differ from the odometry between them, besides their noise.
constexpr double kSlack_m = 0.05;
/// Rotation of a window against the odometry at its ends, at most.
constexpr double kTurnShare = 0.05;
/// Beyond such a way without fixes nothing is said of jumps.
constexpr double kLongestWay_m = 20.0;
/// Levels apart by less are the same, and by this share of the jumps between them.
constexpr double kSameLevel_m = 0.25;
constexpr double kSameLevelShare = 0.02;

struct Place {
  std::size_t node = 0;
  std::size_t seen = 0;
  Eigen::Vector3d off_m;  ///< the fix from where the odometry has it, in the frame of the odometry
};

std::size_t nearest_node(std::span<const OdometryStep> odometry, const GraphChain& chain, const SeenFix& seen,
                         Stamp stamp_ns) {
  const auto after = std::upper_bound(chain.steps.begin(), chain.steps.end(), seen.step);
  const auto before = static_cast<std::size_t>(after - chain.steps.begin()) - 1;
  if (after == chain.steps.end()) {
    return before;
  }
  const Stamp since_ns = stamp_ns - odometry[chain.steps[before]].stamp_ns;
  const Stamp until_ns = odometry[*after].stamp_ns - stamp_ns;
  const bool same = odometry[*after].session == odometry[chain.steps[before]].session;
  return same && until_ns < since_ns ? before + 1 : before;
}

Eigen::Vector3d middle_of(std::span<const Place> places) {
  Eigen::Vector3d middle;
  std::vector<double> values(places.size());
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    for (std::size_t i = 0; i < places.size(); ++i) {
      values[i] = places[i].off_m[axis];
    }
    const auto half = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), half, values.end());
    middle[axis] = *half;
  }
  return middle;
}

class Gatherer {
 public:
  Gatherer(std::span<const OdometryStep> odometry, const GraphChain& chain, std::span<const Fix> fixes,
           std::span<const SeenFix> seen, double sigma_factor, const PoseGraphConfig& config)
      : odometry_(odometry), chain_(chain), fixes_(fixes), seen_(seen), factor_(sigma_factor), config_(config) {}

  /// `places`: of one node. Returns whether any is left.
  void gather(std::span<const Place> places, FixGroups& result) const {
    const Eigen::Vector3d middle_m = middle_of(places);
    FixGroup group;
    group.node = places.front().node;
    const Pose T_base_odom = odometry_[chain_.steps[group.node]].T_odom_base.inverse();
    for (const Place& place : places) {
      const SeenFix& seen = seen_[place.seen];
      if ((place.off_m - middle_m).norm() > config_.gate_sigma * factor_ * seen.sigma_m + kSlack_m) {
        result.jumped.push_back(seen.fix);
        continue;
      }
      group.members.push_back(seen.fix);
      group.antenna_m += T_base_odom * seen.antenna_odom_m;
      group.position_m += seen.position_m;
      group.sigma_m += fixes_[seen.fix].sigma_m;
      add_attitude(seen, T_base_odom.rotation() * seen.T_odom_base.rotation(), group, result);
    }
    if (group.members.empty()) {
      return;
    }
    const double n = static_cast<double>(group.members.size());
    group.antenna_m /= n;
    group.position_m /= n;
    group.sigma_m *= factor_ / n / std::sqrt(std::min(n, kFacts));
    result.groups.push_back(std::move(group));
  }

 private:
  /// The mean on the sphere, one by one.
  void add_attitude(const SeenFix& seen, const Eigen::Quaterniond& R_node_base, FixGroup& group,
                    FixGroups& result) const {
    const Fix& fix = fixes_[seen.fix];
    const auto attitude = attitude_of(fix);
    if (!attitude) {
      result.bad_attitudes += fix.R_world_base ? 1U : 0U;
      return;
    }
    const Eigen::Quaterniond R_world_node = *attitude * R_node_base.conjugate();
    GroupAttitude& mean = group.attitude;
    if (++mean.count == 1) {
      mean.R_world_base = R_world_node;
      mean.sigma_rad << fix.tilt_sigma_rad, fix.tilt_sigma_rad, fix.heading_sigma_rad;
      return;
    }
    const Eigen::Vector3d off_rad = rotation_log(R_world_node * mean.R_world_base.conjugate());
    mean.R_world_base = rotation_exp(off_rad / static_cast<double>(mean.count)) * mean.R_world_base;
  }

  std::span<const OdometryStep> odometry_;
  const GraphChain& chain_;
  std::span<const Fix> fixes_;
  std::span<const SeenFix> seen_;
  double factor_;
  const PoseGraphConfig& config_;
};

/// Which groups lie on the level that most of them share.
class Levels {
 public:
  Levels(std::span<const OdometryStep> odometry, const GraphChain& chain, const PoseGraphConfig& config)
      : odometry_(odometry), chain_(chain), config_(config) {}

  /// `T_world_odom`: of the window that a group is in.
  void add(const FixGroup& group, const Pose& T_world_odom) {
    const Pose& T_odom_base = odometry_[chain_.steps[group.node]].T_odom_base;
    const Eigen::Vector3d antenna_odom_m = T_odom_base * group.antenna_m;
    const double sigma_m = group.sigma_m.norm();
    const std::size_t session = odometry_[chain_.steps[group.node]].session;
    if (!level_of_.empty() && session == session_) {
      const double way_m = chain_.path_m[group.node] - path_m_;
      const Eigen::Vector3d step_m = group.position_m - position_m_;
      const Eigen::Vector3d driven_m = T_world_odom.rotation() * (antenna_odom_m - antenna_odom_m_);
      const Eigen::Vector3d jump_m = step_m - driven_m;
      const double bound_m =
          config_.gate_sigma * (std::hypot(sigma_m, sigma_m_) + config_.drift_m_per_sqrt_m * std::sqrt(way_m)) +
          kSlack_m + kTurnShare * driven_m.norm();
      if (way_m < kLongestWay_m && jump_m.norm() > bound_m) {
        level_m_ += jump_m;
        jumped_m_ += jump_m.norm();
        ++jumps_;
        find_level();
      }
    } else {
      level_m_.setZero();
      session_ = session;
      find_level();
    }
    level_of_.push_back(current_);
    ++levels_[current_].groups;
    antenna_odom_m_ = antenna_odom_m;
    position_m_ = group.position_m;
    sigma_m_ = sigma_m;
    path_m_ = chain_.path_m[group.node];
  }

  [[nodiscard]] bool is_kept(std::size_t group) const {
    const Level& level = levels_[level_of_[group]];
    return std::all_of(levels_.begin(), levels_.end(), [&](const Level& other) {
      return other.session != level.session || other.groups <= level.groups;
    });
  }
  [[nodiscard]] std::size_t jumps() const { return jumps_; }

 private:
  struct Level {
    Eigen::Vector3d off_m;
    std::size_t session = 0;
    std::size_t groups = 0;
  };
  void find_level() {
    const double same_m = kSameLevel_m + kSameLevelShare * jumped_m_;
    for (std::size_t i = 0; i < levels_.size(); ++i) {
      if (levels_[i].session == session_ && (levels_[i].off_m - level_m_).norm() < same_m) {
        current_ = i;
        level_m_ = levels_[i].off_m;  // so that errors of jumps do not add up
        jumped_m_ = 0.0;
        return;
      }
    }
    current_ = levels_.size();
    levels_.push_back({level_m_, session_, 0});
  }

  std::span<const OdometryStep> odometry_;
  const GraphChain& chain_;
  const PoseGraphConfig& config_;
  std::vector<Level> levels_;
  std::vector<std::size_t> level_of_;
  std::size_t current_ = 0;
  std::size_t jumps_ = 0;
  std::size_t session_ = 0;
  Eigen::Vector3d level_m_ = Eigen::Vector3d::Zero();
  double jumped_m_ = 0.0;
  Eigen::Vector3d antenna_odom_m_;
  Eigen::Vector3d position_m_;
  double sigma_m_ = 0.0;
  double path_m_ = 0.0;
};

/// For every window one near it whose fit can be believed, itself at best: a jump within a window turns its fit, and a
/// turned fit makes jumps of plain driving.
std::vector<std::size_t> nearest_sound(std::span<const WindowFit> fits) {
  constexpr double kSound = 3.0;
  constexpr double kSound_m = 0.1;
  std::vector<double> residuals_m;
  for (const WindowFit& fit : fits) {
    residuals_m.push_back(fit.residual_m);
  }
  const auto middle = residuals_m.begin() + static_cast<std::ptrdiff_t>(residuals_m.size() / 2);
  std::nth_element(residuals_m.begin(), middle, residuals_m.end());
  const double bound_m = kSound * *middle + kSound_m;
  const auto is_sound = [&](std::size_t w) { return fits[w].mean_m < bound_m && fits[w].has_heading(); };
  std::vector<std::size_t> nearest(fits.size());
  for (std::size_t w = 0; w < fits.size(); ++w) {
    nearest[w] = w;
    for (std::size_t apart = 0; apart < fits.size(); ++apart) {
      if (w >= apart && is_sound(w - apart)) {
        nearest[w] = w - apart;
        break;
      }
      if (w + apart < fits.size() && is_sound(w + apart)) {
        nearest[w] = w + apart;
        break;
      }
    }
  }
  return nearest;
}

/// Groups that may be believed. If nothing is agreed upon for half of the time, jumps are no rarity, and all stay.
void drop_jumps(const std::vector<bool>& kept, FixGroups& result) {
  const auto count = static_cast<std::size_t>(std::count(kept.begin(), kept.end(), true));
  if (2 * count < kept.size()) {
    return;
  }
  std::vector<FixGroup> left;
  for (std::size_t i = 0; i < kept.size(); ++i) {
    if (kept[i]) {
      left.push_back(std::move(result.groups[i]));
    } else {
      const auto& members = result.groups[i].members;
      result.jumped.insert(result.jumped.end(), members.begin(), members.end());
    }
  }
  result.groups = std::move(left);
}

}  // namespace

FixGroups gather_fixes(std::span<const OdometryStep> odometry, const GraphChain& chain, std::span<const Fix> fixes,
                       std::span<const SeenFix> seen, std::span<const FixWindow> windows,
                       std::span<const WindowFit> fits, double sigma_factor, const PoseGraphConfig& config) {
  const Gatherer gatherer(odometry, chain, fixes, seen, sigma_factor, config);
  FixGroups result;
  std::vector<std::size_t> window_of;  // of every group
  std::vector<Place> places;
  const auto finish_group = [&](std::size_t window) {
    const std::size_t before = result.groups.size();
    if (!places.empty()) {
      gatherer.gather(places, result);
    }
    if (result.groups.size() > before) {
      window_of.push_back(window);
    }
    places.clear();
  };
  if (windows.empty()) {
    return result;
  }
  const std::vector<std::size_t> sound = nearest_sound(fits);
  std::size_t last_window = 0;
  for (std::size_t w = 0; w < windows.size(); ++w) {
    for (std::size_t i = windows[w].first; i < windows[w].first + windows[w].count; ++i) {
      const std::size_t node = nearest_node(odometry, chain, seen[i], seen[i].stamp_ns);
      if (!places.empty() && places.front().node != node) {
        finish_group(last_window);
      }
      places.push_back({node, i, fits[sound[w]].T_world_odom.inverse() * seen[i].position_m - seen[i].antenna_odom_m});
      last_window = w;
    }
  }
  finish_group(last_window);
  Levels levels(odometry, chain, config);
  for (std::size_t i = 0; i < result.groups.size(); ++i) {
    levels.add(result.groups[i], fits[sound[window_of[i]]].T_world_odom);
  }
  std::vector<bool> kept(result.groups.size());
  for (std::size_t i = 0; i < kept.size(); ++i) {
    kept[i] = levels.is_kept(i);
  }
  result.jumps = levels.jumps();
  drop_jumps(kept, result);
  return result;
}

}  // namespace berm
