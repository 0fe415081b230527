#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "berm/core/config.hpp"
#include "berm/core/pose.hpp"
#include "berm/core/stamp.hpp"
#include "berm/core/trajectory.hpp"
#include "berm/odometry/odometry.hpp"

namespace berm {

/// What an odometry says of one scan.
struct OdometryStep {
  Stamp stamp_ns = 0;
  Pose T_odom_base;                        ///< at `stamp_ns`
  Matrix6d covariance = Matrix6d::Zero();  ///< as OdometryResult::covariance; zero where it is not known
  OdometryHealth health = OdometryHealth::good;
  std::size_t session = 0;  ///< as OdometryResult::session
};

/// A position of the antenna, and the attitude of the machine where it is known.
struct Fix {
  /// For what a fix does not say.
  static constexpr double kUnknown = std::numeric_limits<double>::infinity();

  Stamp stamp_ns = 0;  ///< clock of the log
  Eigen::Vector3d position_m = Eigen::Vector3d::Zero();
  Eigen::Vector3d sigma_m = Eigen::Vector3d::Constant(0.03);  ///< east, north, up
  std::optional<Eigen::Quaterniond> R_world_base;
  double tilt_sigma_rad = 0.02;     ///< of roll and pitch; kUnknown where they are made up
  double heading_sigma_rad = 0.02;  ///< kUnknown where it is made up
};

/// Settings of the pose graph.
struct PoseGraphConfig {
  // Nodes and what lies between them.
  double keyframe_m = 1.0;
  double keyframe_rad = 0.1;
  double drift_m_per_sqrt_m = 0.02;
  double drift_rad_per_sqrt_m = 0.002;
  // Fixes.
  bool use_fixes = true;
  double fix_sigma_m = 0.03;
  double fix_sigma_rad = 0.02;
  double antenna_x_m = 0.0;
  double antenna_y_m = 0.0;
  double antenna_z_m = 0.0;
  double gate_sigma = 4.0;
  bool find_time_offset = true;
  double max_time_offset_s = 1.0;
  // Loop closures.
  bool use_closures = true;
  double closure_reach_m = 10.0;
  double closure_detour_m = 40.0;
  double closure_overlap = 0.5;
  double closure_residual_m = 0.08;

  static void fields(auto&& field);
  void check() const { check_fields(*this, "pose_graph"); }
};

/// What became of a fix.
enum class FixFate : std::uint8_t {
  used,
  not_finite,  ///< position or sigma is NaN, infinite or not positive
  no_scan,     ///< no scans around it in time
  jump,        ///< on the far side of a step that the odometry contradicts
  outvoted,    ///< contradicts the fixes around it as the odometry links them
  refused,     ///< the fixes as a whole do not fit the odometry: see the notes
};
inline constexpr std::size_t kFixFates = 6;
/// "used", "not finite", "no scan", "jump", "outvoted", "refused".
[[nodiscard]] std::string_view fate_name(FixFate fate);

/// What became of a pair of places that may be the same.
enum class ClosureFate : std::uint8_t {
  used,
  too_little,  ///< points, or the surfaces overlap too little
  misfit,      ///< the surfaces do not lie on each other
  too_far,     ///< they do, but farther off than the odometry can have drifted
  alone,       ///< no other pair nearby says the same
  outvoted,    ///< contradicts all the rest
};
inline constexpr std::size_t kClosureFates = 6;
/// "used", "too little", "misfit", "too far", "alone", "outvoted".
[[nodiscard]] std::string_view fate_name(ClosureFate fate);

/// Two places that are the same: the pose of the machine at the second scan, in its frame at the first.
struct Closure {
  std::size_t first = 0;   ///< index of an OdometryStep
  std::size_t second = 0;  ///< another
  Pose T_first_second;
  /// Translation along the axes of the first, rotation about those of the second; large where the surfaces say
  /// nothing.
  Matrix6d covariance = Matrix6d::Identity();
};

struct GraphNode {
  std::size_t step = 0;  ///< index of its OdometryStep
  Pose T_world_base;
  /// Translation along the axes of the world, rotation about those of the base. Closures are left out of it.
  Matrix6d covariance = Matrix6d::Zero();
};

struct PoseGraphResult {
  Trajectory trajectory;  ///< T_world_base at the stamp of every step
  std::vector<GraphNode> nodes;
  bool is_in_world = false;        ///< the world is that of the fixes; else the frame of the odometry
  bool has_heading = false;        ///< fixes say how the path is turned; else it is turned as the odometry began
  double time_offset_s = 0.0;      ///< added to the stamps of fixes: time of the scans minus time of the log
  std::size_t bad_attitudes = 0;   ///< fixes whose position was used without their attitude, which is broken
  std::size_t lost_attitudes = 0;  ///< attitudes that were outvoted
  std::array<std::size_t, kFixFates> fixes{};         ///< by FixFate
  std::array<std::size_t, kClosureFates> closures{};  ///< by ClosureFate
  std::vector<std::string> notes;                     ///< what was found or refused, in words
};

/// Fixes of a trajectory that gives no sigmas: poses of the base, so that no antenna is to be taken off. Where all are
/// level their tilt is taken to be made up.
[[nodiscard]] std::vector<Fix> fixes_of(const Trajectory& poses, const PoseGraphConfig& config);

/// Joins odometry, fixes and closures into one trajectory, by least squares over all of them at once (Ceres), in which
/// fixes and closures that contradict the rest lose their weight (dynamic covariance scaling, Agarwal et al. 2013; from
/// a wide scale to a narrow one, as graduated non-convexity does, Yang et al. 2020). Without fixes and closures the
/// poses of the odometry come back as they are. One thread, no clock: same input, same result.
///
/// Throws Error(invalid_argument) unless stamps of `odometry` strictly increase, its poses are finite and closures name
/// steps of it; ConfigError as `PoseGraphConfig::check`.
[[nodiscard]] PoseGraphResult solve_pose_graph(std::span<const OdometryStep> odometry, std::span<const Fix> fixes,
                                               std::span<const Closure> closures, const PoseGraphConfig& config);

void PoseGraphConfig::fields(auto&& field) {
  using C = PoseGraphConfig;
  field("keyframe_m", &C::keyframe_m, Range{0.05, 100.0}, "path from one node of the graph to the next");
  field("keyframe_rad", &C::keyframe_rad, Range{0.01, 3.0}, "or the turn from one to the next");
  field("drift_m_per_sqrt_m", &C::drift_m_per_sqrt_m, Range{1e-4, 1.0},
        "error of the odometry after a metre; it grows with the root of the path");
  field("drift_rad_per_sqrt_m", &C::drift_rad_per_sqrt_m, Range{1e-5, 1.0}, "the same of its attitude");
  field("use_fixes", &C::use_fixes, "place the path in the world by GNSS/INS, where there is any");
  field("fix_sigma_m", &C::fix_sigma_m, Range{0.001, 100.0}, "of positions whose log does not say it, one sigma");
  field("fix_sigma_rad", &C::fix_sigma_rad, Range{1e-4, 3.0}, "the same of attitudes");
  field("antenna_x_m", &C::antenna_x_m, Range{-50.0, 50.0}, "place of which fixes tell, forward of base_link");
  field("antenna_y_m", &C::antenna_y_m, Range{-50.0, 50.0}, "the same, to the left");
  field("antenna_z_m", &C::antenna_z_m, Range{-50.0, 50.0}, "the same, above the ground under base_link");
  field("gate_sigma", &C::gate_sigma, Range{1.0, 100.0}, "fixes and closures that are farther off count for nothing");
  field("find_time_offset", &C::find_time_offset, "look for a constant offset between the clocks of fixes and scans");
  field("max_time_offset_s", &C::max_time_offset_s, Range{0.1, 5.0}, "the largest that is corrected");
  field("use_closures", &C::use_closures, "look for places that were passed before");
  field("closure_reach_m", &C::closure_reach_m, Range{1.0, 100.0}, "places so near to each other may be the same");
  field("closure_detour_m", &C::closure_detour_m, Range{5.0, 10000.0}, "path between them, at least");
  field("closure_overlap", &C::closure_overlap, Range{0.1, 1.0}, "share of the points that meet a surface, at least");
  field("closure_residual_m", &C::closure_residual_m, Range{0.005, 1.0},
        "median distance of points from the surfaces they meet, at most");
}

}  // namespace berm
