#pragma once

#include <filesystem>
#include <optional>
#include <span>

#include <Eigen/Core>
#include <nlohmann/json_fwd.hpp>

#include "berm/core/edge.hpp"
#include "berm/core/stamp.hpp"
#include "berm/core/trajectory.hpp"

namespace berm {

/// Positions relative to `origin_m` in cm, times in s since `start_ns`: at most about 2000 poses, each the first of as
/// many; the last is kept. `path_m` is the length of all.
[[nodiscard]] nlohmann::ordered_json trajectory_part(const Trajectory& trajectory, Stamp start_ns,
                                                     const Eigen::Vector3d& origin_m);

/// Lines with at most about 4000 vertices in all; the ends of each line are kept.
[[nodiscard]] nlohmann::ordered_json edges_part(std::span<const EdgeLine> lines, const Eigen::Vector3d& origin_m);

}  // namespace berm
