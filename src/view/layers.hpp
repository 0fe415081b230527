#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "berm/core/trajectory.hpp"
#include "berm/view/shown_run.hpp"

namespace berm {

/// Layers as the front end takes them (docs/view_api.md); positions less `origin_m`.
[[nodiscard]] std::string make_scan_table(std::span<const ShownScan> scans, const Trajectory& trajectory,
                                          const Eigen::Vector3d& origin_m);
[[nodiscard]] std::string make_pose_table(const Trajectory& trajectory, const Eigen::Vector3d& origin_m);

/// From the edges.csv of a run, or the truth of a recording. Throws FileError.
[[nodiscard]] std::string make_edges_json(const std::filesystem::path& file, bool truth,
                                          const Eigen::Vector3d& origin_m);

/// From edges.ot. Throws FileError.
[[nodiscard]] std::string make_octree_payload(const std::filesystem::path& file, const Eigen::Vector3d& origin_m);

}  // namespace berm
