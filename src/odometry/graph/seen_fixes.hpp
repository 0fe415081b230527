#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "berm/odometry/pose_graph.hpp"
#include "graph_chain.hpp"

namespace berm {

/// A fix, and where the odometry was at its time.
struct SeenFix {
  std::size_t fix = 0;   ///< index
  std::size_t step = 0;  ///< of the odometry, the last one that is not later
  Stamp stamp_ns = 0;    ///< clock of the scans
  Pose T_odom_base;
  Eigen::Vector3d antenna_odom_m;
  Eigen::Vector3d position_m;  ///< of the antenna, world
  double sigma_m = 0.0;
};

/// Whether position and sigma can be used.
[[nodiscard]] bool is_finite(const Fix& fix);
/// The attitude of a fix, normalised; none where it says none or a broken one.
[[nodiscard]] std::optional<Eigen::Quaterniond> attitude_of(const Fix& fix);

/// Those of `chosen` (indices into `fixes`) that the odometry saw, their clock put forward by `offset_s`.
[[nodiscard]] std::vector<SeenFix> see_fixes(const OdometryClock& clock, std::span<const Fix> fixes,
                                             std::span<const std::size_t> chosen, double offset_s,
                                             const PoseGraphConfig& config);

/// Fixes that follow each other, on a way that is short enough to take the odometry on it for rigid.
struct FixWindow {
  std::size_t first = 0;  ///< of the seen fixes
  std::size_t count = 0;
};
/// Every seen fix is in one window. `path_m`: to every step.
[[nodiscard]] std::vector<FixWindow> cut_windows(std::span<const SeenFix> seen, std::span<const OdometryStep> odometry,
                                                 std::span<const double> path_m);

/// How a window lies in the world.
struct WindowFit {
  Pose T_world_odom;
  double residual_m = 0.0;    ///< median distance of fixes from where the odometry has them
  double mean_m = 0.0;        ///< the mean of them
  double base_m = 0.0;        ///< greatest extent of the fixes, root mean square
  bool has_attitude = false;  ///< fixes say how the machine is turned
  /// Whether the fixes say how the window is turned about the vertical.
  [[nodiscard]] bool has_heading() const;
};
/// Fits robustly. The machine is taken to stand upright, roughly, which decides only where the fixes say nothing.
[[nodiscard]] WindowFit fit_window(std::span<const SeenFix> window, std::span<const Fix> fixes);

}  // namespace berm
