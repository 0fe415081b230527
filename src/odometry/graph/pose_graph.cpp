#include "berm/odometry/pose_graph.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <utility>

#include "berm/core/error.hpp"
#include "first_alignment.hpp"
#include "fix_groups.hpp"
#include "graph_chain.hpp"
#include "graph_solver.hpp"
#include "seen_fixes.hpp"
#include "time_offset.hpp"

namespace berm {
namespace {

/// Fixes that scatter by more around any path the odometry can have driven are not of this drive, whatever they say of
/// themselves.
constexpr double kStrange_m = 3.0;
/// A path that is off by more, laid into the world as a whole, starts in parts: over 10 km an odometry turns so far
/// that no solver gets it straight from there.
constexpr double kBent_m = 10.0;

std::string text(double value, int digits) {
  std::array<char, 64> buffer{};
  const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value, std::chars_format::fixed, digits);
  return {buffer.data(), end.ptr};
}

std::vector<double> path_along(std::span<const OdometryStep> odometry) {
  std::vector<double> path_m(odometry.size(), 0.0);
  for (std::size_t i = 1; i < odometry.size(); ++i) {
    const bool same = odometry[i].session == odometry[i - 1].session;
    const double step_m =
        (odometry[i].T_odom_base.translation_m() - odometry[i - 1].T_odom_base.translation_m()).norm();
    path_m[i] = path_m[i - 1] + (same ? step_m : 0.0);
  }
  return path_m;
}

class PoseGraph {
 public:
  PoseGraph(std::span<const OdometryStep> odometry, std::span<const Fix> fixes, std::span<const Closure> closures,
            const PoseGraphConfig& config)
      : odometry_(odometry),
        fixes_(fixes),
        config_(config),
        path_m_(path_along(odometry)),
        chain_(make_chain(odometry, config)),
        fates_(fixes.size(), FixFate::no_scan) {
    for (const Closure& closure : closures) {
      if (closure.first >= odometry.size() || closure.second >= odometry.size()) {
        throw Error(ErrorCode::invalid_argument, "a closure names a step that the odometry does not have");
      }
    }
    if (config.use_closures) {
      closures_ = closures;
    }
  }

  [[nodiscard]] PoseGraphResult solve() {
    FixGroups groups;
    std::vector<std::optional<Alignment>> alignments;
    if (config_.use_fixes) {
      place_fixes(groups, alignments);
    }
    result_.is_in_world = !groups.groups.empty();
    if (!result_.is_in_world && closures_.empty()) {
      keep_odometry();
      return std::move(result_);
    }
    std::vector<Pose> start = start_poses(alignments);
    if (farthest_m(groups, start) > kBent_m) {
      bend(alignments, start);
    }
    const std::vector<NodeClosure> closures = node_closures();
    const GraphSolution solution =
        solve_graph({.chain = chain_, .groups = groups.groups, .closures = closures, .start = start}, config_);
    judge(groups, solution);
    correct(solution);
    return std::move(result_);
  }

 private:
  /// Everything up to the first alignment: which fixes there are, of what time, on which level.
  void place_fixes(FixGroups& groups, std::vector<std::optional<Alignment>>& alignments) {
    const std::vector<std::size_t> chosen = finite_fixes();
    if (chosen.empty()) {
      count_fates();
      return;
    }
    origin_m_ = fixes_[chosen.front()].position_m;
    near_.assign(fixes_.begin(), fixes_.end());
    for (Fix& fix : near_) {
      fix.position_m -= origin_m_;
    }
    if (!find_clock(chosen)) {
      refuse(chosen);
      return;
    }
    const OdometryClock clock(odometry_);
    const auto seen = see_fixes(clock, near_, chosen, result_.time_offset_s, config_);
    const auto windows = cut_windows(seen, odometry_, path_m_);
    std::vector<WindowFit> fits;
    fits.reserve(windows.size());
    for (const FixWindow& window : windows) {
      fits.push_back(fit_window(std::span(seen).subspan(window.first, window.count), near_));
    }
    for (std::size_t first = 0; first < windows.size();) {
      first = align_session(first, seen, windows, fits, alignments);
    }
    groups = gather_fixes(odometry_, chain_, near_, seen, windows, fits, sigma_factor(seen, windows, fits), config_);
    result_.bad_attitudes = groups.bad_attitudes;
    for (const std::size_t fix : groups.jumped) {
      fates_[fix] = FixFate::jump;
    }
    keep_local(seen, windows, fits);
    if (groups.jumps > 0) {
      result_.notes.push_back("fixes jump " + std::to_string(groups.jumps) + " times");
    }
  }

  /// Windows whose fixes are not behind a jump, and that know how they are turned.
  void keep_local(std::span<const SeenFix> seen, std::span<const FixWindow> windows, std::span<const WindowFit> fits) {
    for (std::size_t w = 0; w < windows.size(); ++w) {
      const SeenFix& middle = seen[windows[w].first + windows[w].count / 2];
      if (fits[w].has_heading() && fates_[middle.fix] != FixFate::jump) {
        local_.push_back({middle.step, fits[w].T_world_odom});
      }
    }
  }

  /// How the frame of the odometry lies in the world near a step, as the nearest window has it; `anywhere` where there
  /// is none of the same session.
  [[nodiscard]] Pose nearest_local(std::size_t step, const Pose& anywhere) const {
    const auto after = std::lower_bound(local_.begin(), local_.end(), step,
                                        [](const Local& local, std::size_t s) { return local.step < s; });
    const Local* nearest = nullptr;
    double nearest_m = 0.0;
    const auto consider = [&](const Local& local) {
      const double way_m = std::abs(path_m_[local.step] - path_m_[step]);
      if (odometry_[local.step].session == odometry_[step].session && (nearest == nullptr || way_m < nearest_m)) {
        nearest = &local;
        nearest_m = way_m;
      }
    };
    if (after != local_.end()) {
      consider(*after);
    }
    if (after != local_.begin()) {
      consider(*(after - 1));
    }
    return nearest != nullptr ? nearest->T_world_odom : anywhere;
  }

  [[nodiscard]] std::vector<std::size_t> finite_fixes() {
    std::vector<std::size_t> chosen;
    for (std::size_t i = 0; i < fixes_.size(); ++i) {
      if (is_finite(fixes_[i])) {
        chosen.push_back(i);
      } else {
        fates_[i] = FixFate::not_finite;
      }
    }
    std::stable_sort(chosen.begin(), chosen.end(),
                     [&](std::size_t a, std::size_t b) { return fixes_[a].stamp_ns < fixes_[b].stamp_ns; });
    return chosen;
  }

  /// False if there is no clock in which the fixes fit.
  [[nodiscard]] bool find_clock(std::span<const std::size_t> chosen) {
    if (!config_.find_time_offset) {
      return true;
    }
    const TimeOffset found = find_time_offset(odometry_, path_m_, near_, chosen, config_);
    const std::string reach = text(config_.max_time_offset_s, 1) + " s";
    if (found.is_at_border) {
      result_.notes.push_back("fixes refused: their clock is off that of the scans by more than " + reach +
                              ", or they are of another drive");
      return false;
    }
    if (found.residual_m > kStrange_m) {
      result_.notes.push_back("fixes refused: at any offset of their clock up to " + reach +
                              " half of them lie more than " + text(found.residual_m, 1) + " m off the path");
      return false;
    }
    result_.time_offset_s = found.offset_s;
    if (found.offset_s != 0.0) {
      result_.notes.push_back("the clock of the fixes was put forward by " + text(found.offset_s, 3) + " s: they lie " +
                              text(found.residual_m, 2) + " m off the path then, and " + text(found.as_stamped_m, 2) +
                              " m as they are stamped");
    }
    return true;
  }

  void refuse(std::span<const std::size_t> chosen) {
    for (const std::size_t i : chosen) {
      fates_[i] = FixFate::refused;
    }
    count_fates();
  }

  /// By how much fixes scatter more than they say, beyond what the odometry drifts in a window.
  [[nodiscard]] static double sigma_factor(std::span<const SeenFix> seen, std::span<const FixWindow> windows,
                                           std::span<const WindowFit> fits) {
    constexpr double kDrift_m = 0.06;
    // Median distance in space of a normal scatter, in sigmas of one axis.
    constexpr double kMedianOfThree = 1.54;
    std::vector<double> factors;
    for (std::size_t w = 0; w < windows.size(); ++w) {
      const double scatter_m = fits[w].residual_m / kMedianOfThree;
      const double own_m = seen[windows[w].first].sigma_m;
      factors.push_back(std::sqrt(std::max(scatter_m * scatter_m - kDrift_m * kDrift_m, 0.0)) / own_m);
    }
    if (factors.empty()) {
      return 1.0;
    }
    const auto middle = factors.begin() + static_cast<std::ptrdiff_t>(factors.size() / 2);
    std::nth_element(factors.begin(), middle, factors.end());
    return std::max(1.0, *middle);
  }

  /// Windows from `first` on that are of one session. Returns the first that is not.
  std::size_t align_session(std::size_t first, std::span<const SeenFix> seen, std::span<const FixWindow> windows,
                            std::span<const WindowFit> fits, std::vector<std::optional<Alignment>>& alignments) {
    const std::size_t session = odometry_[seen[windows[first].first].step].session;
    std::size_t last = first;
    std::vector<FixWindow> own;
    const std::size_t begin = windows[first].first;
    for (; last < windows.size() && odometry_[seen[windows[last].first].step].session == session; ++last) {
      own.push_back({windows[last].first - begin, windows[last].count});
    }
    const std::size_t end = windows[last - 1].first + windows[last - 1].count;
    if (alignments.size() <= session) {
      alignments.resize(session + 1);
    }
    alignments[session] =
        align_first(seen.subspan(begin, end - begin), own, fits.subspan(first, last - first), path_m_);
    result_.has_heading = result_.has_heading || alignments[session]->has_heading;
    return last;
  }

  /// Sessions without fixes go on from the one before, or lead to the first that has some.
  [[nodiscard]] std::vector<Pose> start_poses(const std::vector<std::optional<Alignment>>& alignments) const {
    std::vector<Pose> poses(chain_.steps.size());
    std::vector<bool> known(poses.size(), false);
    for (std::size_t i = 0; i < poses.size(); ++i) {
      const OdometryStep& step = odometry_[chain_.steps[i]];
      const bool aligned = step.session < alignments.size() && alignments[step.session];
      if (aligned) {
        poses[i] = alignments[step.session]->T_world_odom * step.T_odom_base;
      } else if (i > 0 && known[i - 1]) {
        poses[i] = poses[i - 1] * chain_.links[i - 1].T_a_b;
      }
      known[i] = aligned || (i > 0 && known[i - 1]);
    }
    const auto first = static_cast<std::size_t>(std::find(known.begin(), known.end(), true) - known.begin());
    if (first == known.size()) {
      for (std::size_t i = 0; i < poses.size(); ++i) {
        poses[i] = odometry_[chain_.steps[i]].T_odom_base;
      }
      return poses;
    }
    for (std::size_t i = first; i-- > 0;) {
      poses[i] = poses[i + 1] * chain_.links[i].T_a_b.inverse();
    }
    return poses;
  }

  [[nodiscard]] static double farthest_m(const FixGroups& groups, std::span<const Pose> start) {
    double farthest_m = 0.0;
    for (const FixGroup& group : groups.groups) {
      farthest_m = std::max(farthest_m, (start[group.node] * group.antenna_m - group.position_m).norm());
    }
    return farthest_m;
  }

  /// Lays every part of the path where the fixes near it have it.
  void bend(const std::vector<std::optional<Alignment>>& alignments, std::vector<Pose>& start) const {
    for (std::size_t i = 0; i < start.size(); ++i) {
      const OdometryStep& step = odometry_[chain_.steps[i]];
      if (step.session < alignments.size() && alignments[step.session]) {
        start[i] = nearest_local(chain_.steps[i], alignments[step.session]->T_world_odom) * step.T_odom_base;
      }
    }
  }

  [[nodiscard]] std::size_t node_before(std::size_t step) const {
    const auto after = std::upper_bound(chain_.steps.begin(), chain_.steps.end(), step);
    return static_cast<std::size_t>(after - chain_.steps.begin()) - 1;
  }

  [[nodiscard]] std::vector<NodeClosure> node_closures() const {
    std::vector<NodeClosure> closures;
    for (const Closure& closure : closures_) {
      const std::size_t a = node_before(closure.first);
      const std::size_t b = node_before(closure.second);
      const Pose T_a_first = odometry_[chain_.steps[a]].T_odom_base.inverse() * odometry_[closure.first].T_odom_base;
      const Pose T_b_second = odometry_[chain_.steps[b]].T_odom_base.inverse() * odometry_[closure.second].T_odom_base;
      closures.push_back({a, b, T_a_first * closure.T_first_second * T_b_second.inverse(), closure.covariance});
    }
    return closures;
  }

  void judge(const FixGroups& groups, const GraphSolution& solution) {
    for (std::size_t i = 0; i < groups.groups.size(); ++i) {
      for (const std::size_t fix : groups.groups[i].members) {
        fates_[fix] = solution.is_used[i] ? FixFate::used : FixFate::outvoted;
      }
      if (!solution.is_attitude_used[i]) {
        result_.lost_attitudes += groups.groups[i].attitude.count;
      }
    }
    count_fates();
    for (const bool used : solution.is_closure_used) {
      ++result_.closures[static_cast<std::size_t>(used ? ClosureFate::used : ClosureFate::outvoted)];
    }
  }

  void count_fates() {
    result_.fixes.fill(0);
    for (const FixFate fate : fates_) {
      ++result_.fixes[static_cast<std::size_t>(fate)];
    }
  }

  void keep_odometry() {
    if (result_.fixes == std::array<std::size_t, kFixFates>{}) {
      count_fates();
    }
    result_.trajectory.reserve(odometry_.size());
    for (const OdometryStep& step : odometry_) {
      result_.trajectory.append(step.stamp_ns, step.T_odom_base);
    }
    Matrix6d sum = Matrix6d::Zero();
    for (std::size_t i = 0; i < chain_.steps.size(); ++i) {
      sum += i > 0 ? chain_.links[i - 1].covariance : Matrix6d::Zero();
      result_.nodes.push_back({chain_.steps[i], odometry_[chain_.steps[i]].T_odom_base, sum});
    }
  }

  /// Between nodes the odometry goes on, and what it is off at the next node comes in little by little.
  void correct(const GraphSolution& solution) {
    result_.trajectory.reserve(odometry_.size());
    for (std::size_t i = 0; i < solution.nodes.size(); ++i) {
      const Pose here(solution.nodes[i].rotation(), solution.nodes[i].translation_m() + origin_m_);
      result_.nodes.push_back({chain_.steps[i], here, solution.covariances[i]});
    }
    for (std::size_t i = 0; i + 1 < solution.nodes.size(); ++i) {
      append_between(solution.nodes[i], solution.nodes[i + 1], i);
    }
    result_.trajectory.append(odometry_.back().stamp_ns, result_.nodes.back().T_world_base);
  }

  void append_between(const Pose& from, const Pose& to, std::size_t link) {
    const std::size_t first = chain_.steps[link];
    const std::size_t last = chain_.steps[link + 1];
    const Vector6d off = ((from * chain_.links[link].T_a_b).inverse() * to).log();
    const Pose T_first_odom = odometry_[first].T_odom_base.inverse();
    const double way_m = path_m_[last] - path_m_[first];
    for (std::size_t i = first; i < last; ++i) {
      // By the way where there is one: a machine that stands must not creep.
      const double share = way_m > 0.05 ? (path_m_[i] - path_m_[first]) / way_m
                                        : static_cast<double>(i - first) / static_cast<double>(last - first);
      const Pose pose = from * T_first_odom * odometry_[i].T_odom_base * Pose::exp(share * off);
      result_.trajectory.append(odometry_[i].stamp_ns, Pose(pose.rotation(), pose.translation_m() + origin_m_));
    }
  }

  std::span<const OdometryStep> odometry_;
  std::span<const Fix> fixes_;
  std::span<const Closure> closures_;
  const PoseGraphConfig& config_;
  std::vector<double> path_m_;
  GraphChain chain_;
  std::vector<FixFate> fates_;
  struct Local {
    std::size_t step = 0;
    Pose T_world_odom;
  };
  std::vector<Local> local_;  ///< steps rise
  std::vector<Fix> near_;     ///< fixes, the first of them at the origin
  Eigen::Vector3d origin_m_ = Eigen::Vector3d::Zero();
  PoseGraphResult result_;
};

}  // namespace

std::string_view fate_name(FixFate fate) {
  constexpr std::array<std::string_view, kFixFates> kNames = {"used", "not finite", "no scan",
                                                              "jump", "outvoted",   "refused"};
  return kNames[static_cast<std::size_t>(fate)];
}

std::string_view fate_name(ClosureFate fate) {
  constexpr std::array<std::string_view, kClosureFates> kNames = {"used",    "too little", "misfit",
                                                                  "too far", "alone",      "outvoted"};
  return kNames[static_cast<std::size_t>(fate)];
}

std::vector<Fix> fixes_of(const Trajectory& poses, const PoseGraphConfig& config) {
  // A frame on the ellipsoid tilts by this over 5 km; no machine stands as level as that for a whole drive.
  constexpr double kLevel_rad = 1e-3;
  const auto& all = poses.poses();
  const bool is_level = std::all_of(all.begin(), all.end(), [](const StampedPose& pose) {
    const Eigen::Vector3d up = pose.T_world_base.rotation() * Eigen::Vector3d::UnitZ();
    return up.head<2>().norm() < kLevel_rad;
  });
  std::vector<Fix> fixes;
  fixes.reserve(all.size());
  for (const StampedPose& pose : all) {
    fixes.push_back({.stamp_ns = pose.stamp_ns,
                     .position_m = pose.T_world_base.translation_m(),
                     .sigma_m = Eigen::Vector3d::Constant(config.fix_sigma_m),
                     .R_world_base = pose.T_world_base.rotation(),
                     .tilt_sigma_rad = is_level ? Fix::kUnknown : config.fix_sigma_rad,
                     .heading_sigma_rad = config.fix_sigma_rad});
  }
  return fixes;
}

PoseGraphResult solve_pose_graph(std::span<const OdometryStep> odometry, std::span<const Fix> fixes,
                                 std::span<const Closure> closures, const PoseGraphConfig& config) {
  config.check();
  check_odometry(odometry);
  if (odometry.empty()) {
    return {};
  }
  return PoseGraph(odometry, fixes, closures, config).solve();
}

}  // namespace berm
