#pragma once

#include <span>

#include "berm/io/output_folder.hpp"
#include "berm/odometry/pose_graph.hpp"
#include "berm/odometry/pose_graph_places.hpp"
#include "berm/pipeline/run.hpp"
#include "run_poses.hpp"
#include "run_report.hpp"

namespace berm {

/// Joins the odometry of a run with its fixes and the places that it passed again, and writes trajectory_global.tum,
/// T_world_base at the stamp of every step, and trajectory_global.csv, how sure it is of it at its nodes. Nothing is
/// written where there is nothing to join. Completes `files`, and the notes of `summary`: what was used, what was not,
/// and why. `fixes`: null without any.
[[nodiscard]] PoseGraphResult write_global_trajectory(std::span<const OdometryStep> odometry, const PlaceMemory& places,
                                                      const RunPoses* fixes, const PoseGraphConfig& config,
                                                      const OutputFolder& output, RunFiles& files, RunSummary& summary);

}  // namespace berm
