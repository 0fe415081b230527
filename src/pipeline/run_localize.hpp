#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "berm/core/label.hpp"
#include "berm/core/scan.hpp"
#include "berm/io/output_folder.hpp"
#include "berm/odometry/map_localizer.hpp"
#include "berm/pipeline/machine.hpp"
#include "berm/pipeline/run.hpp"
#include "run_poses.hpp"
#include "run_report.hpp"

namespace berm {

/// Where the machine of a run is in a map that an earlier run saved.
class RunLocalize {
 public:
  /// Off unless `options.localize` names a map. The machine is looked for around `options.start`, or around the first
  /// of `poses` in the time of the run where there is none. What speaks against it is found out here: throws FileError
  /// for a map that is broken, lacks a tile, or is too coarse to match scans with; Error(invalid_argument) without an
  /// odometry or a start, or where the map has no ground near the start.
  RunLocalize(const Recording& recording, const Machine& machine, const RunOptions& options, const RunPoses* poses);
  RunLocalize(const RunLocalize&) = delete;
  RunLocalize& operator=(const RunLocalize&) = delete;
  ~RunLocalize();

  [[nodiscard]] bool is_on() const { return localizer_ != nullptr; }
  /// For one thread, in the order of scans. Only if it is on, as all below.
  void add(const std::string& name, const Scan& scan, std::span<const Label> labels, const OdometryResult& odometry);
  /// trajectory_map.tum, of the scans that were located, and localization.csv, of all. Completes `files` and `summary`.
  void write(const OutputFolder& output, RunFiles& files, RunSummary& summary) const;

 private:
  class Tiles;
  struct Row {
    std::string name;
    Stamp stamp_ns = 0;
    MapPose pose;
  };

  [[nodiscard]] LocalizationCounts count() const;
  void write_table(const OutputFolder& output) const;

  std::string map_;
  std::unique_ptr<Tiles> tiles_;
  std::unique_ptr<MapLocalizer> localizer_;
  std::vector<Row> rows_;
};

}  // namespace berm
