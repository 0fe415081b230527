#pragma once

#include <optional>
#include <span>
#include <vector>

#include "berm/odometry/pose_graph.hpp"
#include "seen_fixes.hpp"

namespace berm {

/// How the frame of the odometry lies in the world, roughly.
struct Alignment {
  Pose T_world_odom;
  bool has_heading = false;
};

/// The way in which one window lies in the world that agrees with the most fixes of the rest, as far as an odometry may
/// drift from there. `seen`: of one session. None without fixes.
[[nodiscard]] std::optional<Alignment> align_first(std::span<const SeenFix> seen, std::span<const FixWindow> windows,
                                                   std::span<const WindowFit> fits, std::span<const double> path_m);

}  // namespace berm
