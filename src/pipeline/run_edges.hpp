#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "berm/core/scan.hpp"
#include "berm/edge/edge.hpp"
#include "berm/io/output_folder.hpp"
#include "berm/io/recording.hpp"
#include "berm/pipeline/machine.hpp"
#include "berm/pipeline/run.hpp"
#include "road_mapper.hpp"
#include "run_poses.hpp"
#include "run_report.hpp"

namespace berm {

/// Poses, road edges and their map in a run: what is there, what can be done with it, and what is written at its end.
class RunEdges {
 public:
  /// Reads poses and the map that is to be continued. `selected`: number of scans from `options.first` on. Throws as
  /// `read_run_poses`; FileError for a map that is none, has other voxels or lies in another world;
  /// Error(invalid_argument) for a map without an edge method or poses, or one that the results would replace.
  RunEdges(const Recording& recording, const Machine& machine, const RunOptions& options, std::size_t selected);

  RunEdges(const RunEdges&) = delete;
  RunEdges& operator=(const RunEdges&) = delete;
  ~RunEdges() = default;

  [[nodiscard]] const std::optional<RunPoses>& poses() const { return poses_; }
  /// For a recording without poses, after all its scans: from now on there is a map if there is an edge method.
  void use_odometry(const Recording& recording, const Trajectory& T_world_base, std::size_t selected);
  [[nodiscard]] bool has_map() const { return mapper_.has_value(); }

  /// As `RoadMapper::place`. Only with a map.
  void place(const Scan& scan, std::span<const Label> labels, const EdgeResult& found, PlacedScan& placed) const {
    mapper_->place(scan, labels, found, placed);
  }
  /// For one thread, in the order of scans. Only with a map.
  void add(const PlacedScan& placed) { mapper_->add(placed); }

  /// Writes the map and what follows from it, and completes `summary` with figures of poses and edges, and notes.
  void finish(const OutputFolder& output, RunFiles& files, RunSummary& summary) const;

 private:
  void start_map(const Recording& recording, std::optional<EdgeMap> old, std::size_t selected);
  void write_map(const OutputFolder& output, RunFiles& files, RunSummary& summary) const;

  const Machine& machine_;
  const RunOptions& options_;
  std::optional<RunPoses> poses_;
  std::optional<RoadMapper> mapper_;
  std::vector<std::string> notes_;
};

}  // namespace berm
