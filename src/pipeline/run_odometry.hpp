#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "berm/core/label.hpp"
#include "berm/core/scan.hpp"
#include "berm/core/trajectory.hpp"
#include "berm/io/output_folder.hpp"
#include "berm/odometry/odometry.hpp"
#include "berm/odometry/pose_graph.hpp"
#include "berm/odometry/pose_graph_places.hpp"
#include "berm/pipeline/machine.hpp"
#include "berm/pipeline/run.hpp"
#include "run_poses.hpp"
#include "run_report.hpp"

namespace berm {

/// The method that `machine.methods` names, with its configuration; null for "none".
[[nodiscard]] std::unique_ptr<Odometry> make_odometry(const Machine& machine);

/// The odometry of a run: where the machine was, scan by scan, and how far that may be believed.
class RunOdometry {
 public:
  /// Throws ConfigError as the configuration of the method.
  explicit RunOdometry(const Machine& machine);

  [[nodiscard]] bool is_on() const { return odometry_ != nullptr; }
  /// For one thread, in the order of scans. Only if it is on. What it returns is valid until the next call. Throws as
  /// `Odometry::process`.
  OdometryResult add(const std::string& name, const Scan& scan, std::span<const Label> labels);

  /// T_world_base at the stamps of all scans. The world begins at the first.
  [[nodiscard]] Trajectory trajectory() const;
  /// That of the session with most scans up to the end of its last, without those that were lost: what a map may be
  /// made of. Where `join` found places that were passed again, so that it fits together there.
  [[nodiscard]] Trajectory trusted() const;

  /// Joins the odometry with fixes, null without any, and with places that were passed again, and writes what comes of
  /// it, see `write_global_trajectory`. To be called once, after the last scan.
  void join(const RunPoses* fixes, const OutputFolder& output, RunFiles& files, RunSummary& summary);

  /// trajectory.tum and odometry.csv. Completes `files` and `summary`.
  void write(const OutputFolder& output, RunFiles& files, RunSummary& summary) const;

 private:
  /// Beside the step of a scan.
  struct Quality {
    std::string name;
    Pose T_odom_end;
    double duration_s = 0.0;
    double weakest = 0.0;
    std::size_t samples = 0;
    std::size_t inliers = 0;
    std::size_t iterations = 0;
  };

  [[nodiscard]] std::size_t longest_session() const;
  void write_table(const OutputFolder& output) const;
  [[nodiscard]] OdometryCounts count() const;

  const Machine& machine_;
  std::unique_ptr<Odometry> odometry_;
  PlaceMemory places_;
  std::optional<Trajectory> joined_;  ///< one pose per step
  std::vector<OdometryStep> steps_;
  std::vector<Quality> qualities_;  ///< one per step
};

}  // namespace berm
