#include "berm/pipeline/run.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <numbers>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "berm/core/error.hpp"
#include "berm/core/ordered_parallel.hpp"
#include "berm/io/atomic_file.hpp"
#include "berm/io/label_file.hpp"
#include "berm/io/output_folder.hpp"
#include "berm/io/trajectory_file.hpp"
#include "berm/pipeline/pipeline.hpp"
#include "run_edges.hpp"
#include "run_localize.hpp"
#include "run_odometry.hpp"
#include "run_report.hpp"
#include "run_surface.hpp"
#include "scan_table.hpp"
#include "stage_times.hpp"
#include "times_table.hpp"

namespace berm {
namespace {

/// Rates that differ by more than this share are worth a note.
constexpr double kRateTolerance = 0.1;

/// One scan on its way from the recording to its label file.
struct Job {
  Scan scan;
  std::vector<Label> labels;
  ScanFigures figures;
  std::vector<BoundaryPoint> left;
  std::vector<BoundaryPoint> right;
  std::vector<EdgePoint> edges;
  PlacedScan placed;
  PlacedSurface surface;
  MountCheckResult mount;
  std::optional<std::string> failure;
  StageTime read;
  std::array<std::optional<StageTime>, kStages> stages;
  StageTime map;
  StageTime surface_time;
};

double to_degrees(double angle_rad) {
  return angle_rad * 180.0 / std::numbers::pi;
}

std::size_t selected_count(const Recording& recording, const RunOptions& options) {
  if (options.first >= recording.size() || options.count == std::size_t{0}) {
    throw Error(ErrorCode::invalid_argument,
                fmt::format("no scan is selected: the recording has {}, their indices start at 0", recording.size()));
  }
  const std::size_t rest = recording.size() - options.first;
  return std::min(rest, options.count.value_or(rest));
}

/// Works for one recording, see `run`.
class Run {
 public:
  Run(const Recording& recording, const Machine& machine, const RunOptions& options)
      : recording_(recording),
        machine_(machine),
        options_(options),
        threads_(std::max<std::size_t>(1, options.threads)),
        T_base_sensor_(machine.mount.T_base_sensor()),
        edges_(recording, machine, options, selected_count(recording, options)),
        odometry_(machine),
        localize_(recording, machine, options, edges_.poses() ? &*edges_.poses() : nullptr),
        surface_(machine, options, edges_.poses() ? &*edges_.poses() : nullptr),
        maps_follow_(odometry_.is_on() && !edges_.poses() &&
                     (machine.methods.edge != "none" || machine.mapping.surface)) {
    summary_.counts.selected = selected_count(recording, options);
    summary_.notes = recording.notes();
    summary_.notes.insert(summary_.notes.end(), options.notes.begin(), options.notes.end());
    note_rate();
    for (std::size_t worker = 0; worker < threads_; ++worker) {
      pipelines_.push_back(std::make_unique<Pipeline>(machine));
    }
  }

  RunSummary finish() {
    OutputFolder output(options_.output, options_.force, run_results(), recording_.path());
    output_ = &output;
    const StageClock clock;
    open_tables(output);
    const Tables tables{*this};
    if (surface_.is_on()) {
      surface_.open(output);
    }
    process_scans();
    if (summary_.interrupted) {
      return std::move(summary_);
    }
    if (summary_.counts.labelled == 0) {
      throw Error(ErrorCode::malformed, fmt::format("no scan of {} could be read; the first: {}",
                                                    recording_.path().string(), summary_.skipped.front().reason));
    }
    RunFiles files = {{"labels", "labels"}, {"scans", "scans.csv"}, {"times", "times.csv"}};
    write_odometry(output, files);
    if (maps_follow_) {
      make_maps(output);
      if (summary_.interrupted) {
        return std::move(summary_);
      }
    }
    write_files(output, files);
    summary_.mount = mount_.summarize();
    note_mount();
    times_.wall_s = clock.stop().wall_ms * 1e-3;
    write_file_atomically(output / "run.json",
                          write_run_report(recording_, machine_, options_, summary_, times_, files));
    output.finish();
    return std::move(summary_);
  }

 private:
  /// Takes back tables that were not committed, before the folder is judged to be empty.
  struct Tables {
    Run& self;
    ~Tables() {
      self.scan_table_.reset();
      self.times_table_.reset();
      self.boundary_table_.reset();
      self.edge_table_.reset();
    }
  };

  void open_tables(const OutputFolder& output) {
    scan_table_.emplace(output / "scans.csv");
    times_table_.emplace(output / "times.csv");
    if (machine_.methods.piste != "none") {
      boundary_table_.emplace(output / "boundary.csv");
    }
    if (machine_.methods.edge != "none") {
      edge_table_.emplace(output / "edge_points.csv");
      summary_.edges.emplace();
    }
  }

  void write_odometry(const OutputFolder& output, RunFiles& files) {
    if (odometry_.is_on()) {
      odometry_.write(output, files, summary_);
      const bool has_fixes = edges_.poses() && !edges_.poses()->trajectory.empty();
      odometry_.join(has_fixes ? &*edges_.poses() : nullptr, output, files, summary_);
    }
    if (localize_.is_on()) {
      localize_.write(output, files, summary_);
    }
  }

  /// The rest, but for run.json.
  void write_files(const OutputFolder& output, RunFiles& files) {
    if (!odometry_.is_on() && edges_.poses() && !edges_.poses()->trajectory.empty()) {
      write_tum(output / "trajectory.tum", trajectory_);
      files.emplace_back("trajectory", "trajectory.tum");
      note_missing_poses();
    }
    edges_.finish(output, files, summary_);
    surface_.finish(output, files, summary_);
    scan_table_->commit();
    times_table_->commit();
    if (boundary_table_) {
      boundary_table_->commit();
      files.emplace_back("boundary", "boundary.csv");
    }
    if (edge_table_) {
      edge_table_->commit();
      files.emplace_back("edge_points", "edge_points.csv");
    }
  }

  /// The odometry revises the poses of its start, and a map must not be made of poses that were wrong: so a recording
  /// that brings no poses is read and labelled a second time, once they are known.
  void make_maps(const OutputFolder& output) {
    edges_.use_odometry(recording_, odometry_.trusted(), summary_.counts.selected);
    surface_.use(*edges_.poses());
    if (surface_.is_on()) {
      surface_.open(output);
    }
    OrderedParallel<Job> work(
        summary_.counts.selected, threads_,
        [this](std::size_t worker, std::size_t index, Job& job) { label(*pipelines_[worker], index, job); },
        [this](std::size_t index, Job& job) {
          if (!job.failure) {
            if (const auto time = add_to_map(job)) {
              times_.map.add(*time);
            }
            add_to_surface(job);
          }
          return go_on(summary_.counts.selected + index + 1);
        });
    work.run();
  }

  /// Tells of progress; false if the run is to end early.
  bool go_on(std::size_t done) {
    const std::size_t total = summary_.counts.selected * (maps_follow_ ? 2 : 1);
    if (options_.on_progress) {
      options_.on_progress(done, total);
    }
    summary_.interrupted = done < total && options_.should_stop && options_.should_stop();
    return !summary_.interrupted;
  }

  void process_scans() {
    OrderedParallel<Job> work(
        summary_.counts.selected, threads_,
        [this](std::size_t worker, std::size_t index, Job& job) { label(*pipelines_[worker], index, job); },
        [this](std::size_t index, Job& job) { return keep(index, job); });
    work.run();
  }

  /// Runs on any thread.
  void label(Pipeline& pipeline, std::size_t index, Job& job) const {
    job.failure.reset();
    const StageClock read_clock;
    try {
      recording_.read(options_.first + index, job.scan);
    } catch (const Error& error) {
      job.failure = error.what();
      return;
    }
    job.read = read_clock.stop();
    job.scan.T_base_sensor = T_base_sensor_;
    job.stages.fill(std::nullopt);
    StageClock clock;
    const ScanResult result = pipeline.process(job.scan, [&job, &clock](Stage stage) {
      job.stages[static_cast<std::size_t>(stage)] = clock.stop();
      clock = StageClock();
    });
    job.labels.assign(result.labels.begin(), result.labels.end());
    job.left.assign(result.piste.left.begin(), result.piste.left.end());
    job.right.assign(result.piste.right.begin(), result.piste.right.end());
    job.edges.assign(result.edge.edges.begin(), result.edge.edges.end());
    job.figures = figures_of(result, T_base_sensor_);
    job.mount = result.mount;
    if (edges_.has_map()) {
      const StageClock map_clock;
      edges_.place(job.scan, result.labels, result.edge, job.placed);
      job.map = map_clock.stop();
    }
    if (surface_.is_on()) {
      const StageClock surface_clock;
      surface_.place(job.scan, result.labels, job.surface);
      job.surface_time = surface_clock.stop();
    }
  }

  /// Runs on the calling thread, scan after scan.
  bool keep(std::size_t index, const Job& job) {
    const std::string name = recording_.scan(options_.first + index).name;
    if (job.failure) {
      skip(name, *job.failure);
    } else {
      const StageClock clock;
      write_labels(*output_ / "labels" / (name + ".label"), job.labels);
      scan_table_->add(name, job.scan.stamp_ns, job.figures);
      if (boundary_table_) {
        boundary_table_->add(name, job.left, job.right);
      }
      if (edge_table_) {
        edge_table_->add(name, job.edges, T_base_sensor_);
      }
      const StageTime write = clock.stop();
      add_times(name, job.scan.stamp_ns,
                {.read = job.read,
                 .stages = job.stages,
                 .odometry = follow(name, job),
                 .map = add_to_map(job),
                 .write = write});
      add_to_surface(job);
      count(job);
      mount_.add(job.mount);
      add_pose(job.scan.stamp_ns);
    }
    return go_on(index + 1);
  }

  void skip(const std::string& name, const std::string& reason) {
    ++summary_.counts.skipped;
    if (summary_.skipped.size() < RunSummary::kListedSkips) {
      summary_.skipped.push_back({name, reason});
    }
  }

  void count(const Job& job) {
    RunCounts& counts = summary_.counts;
    const LabelCounts& labels = job.figures.counts;
    ++counts.labelled;
    if (summary_.edges) {
      summary_.edges->points += job.edges.size();
    }
    counts.points += job.labels.size();
    counts.drivable += labels.drivable;
    counts.terrain += labels.terrain;
    counts.obstacle += labels.obstacle;
    counts.falling_snow += labels.falling_snow;
    counts.no_return += labels.no_return;
    counts.invalid += labels.invalid;
    for (std::size_t kind = 0; kind < kDegradations; ++kind) {
      counts.degraded[kind] += job.figures.degraded.has(static_cast<Degradation>(kind)) ? 1U : 0U;
    }
  }

  /// What it cost; nothing without an odometry method.
  std::optional<StageTime> follow(const std::string& name, const Job& job) {
    if (!odometry_.is_on()) {
      return std::nullopt;
    }
    const StageClock clock;
    const OdometryResult result = odometry_.add(name, job.scan, job.labels);
    const StageTime time = clock.stop();
    if (localize_.is_on()) {
      const StageClock localize_clock;
      localize_.add(name, job.scan, job.labels, result);
      times_.localize.add(localize_clock.stop());
    }
    return time;
  }

  /// What it cost; nothing without a map.
  std::optional<StageTime> add_to_map(const Job& job) {
    if (!edges_.has_map()) {
      return std::nullopt;
    }
    const StageClock clock;
    edges_.add(job.placed);
    const StageTime time = clock.stop();
    return StageTime{job.map.wall_ms + time.wall_ms, job.map.cpu_ms + time.cpu_ms};
  }

  void add_to_surface(const Job& job) {
    if (surface_.is_on()) {
      const StageClock clock;
      surface_.add(job.surface);
      const StageTime time = clock.stop();
      times_.surface.add({job.surface_time.wall_ms + time.wall_ms, job.surface_time.cpu_ms + time.cpu_ms});
    }
  }

  void add_times(const std::string& name, Stamp stamp_ns, const ScanTimes& times) {
    times_.read.add(times.read);
    for (std::size_t stage = 0; stage < kStages; ++stage) {
      if (times.stages[stage]) {
        times_.stages[stage].add(*times.stages[stage]);
      }
    }
    if (times.odometry) {
      times_.odometry.add(*times.odometry);
    }
    if (times.map) {
      times_.map.add(*times.map);
    }
    times_.write.add(times.write);
    times_table_->add(name, stamp_ns, times);
  }

  void add_pose(Stamp stamp_ns) {
    if (!edges_.poses() || odometry_.is_on()) {
      return;
    }
    const bool in_order = trajectory_.empty() || stamp_ns > trajectory_.poses().back().stamp_ns;
    const auto pose = edges_.poses()->trajectory.at(stamp_ns);
    if (!pose || !in_order) {
      ++summary_.counts.without_pose;
      return;
    }
    trajectory_.append(stamp_ns, *pose);
  }

  void note_missing_poses() {
    if (summary_.counts.without_pose > 0) {
      summary_.notes.push_back(fmt::format(
          "{} scans have no line in trajectory.tum: {} holds no pose for their stamps, or the stamps run backwards",
          summary_.counts.without_pose, edges_.poses()->file.filename().string()));
    }
  }

  void note_mount() {
    if (summary_.mount.verdict != MountVerdict::implausible) {
      return;
    }
    const MountEstimate& seen = *summary_.mount.estimate;
    summary_.notes.push_back(fmt::format(
        "the mount looks wrong: the ground near the machine lies tilted by {:.1f} deg against it (pitch {:+.1f}, roll "
        "{:+.1f}), {:.2f} m below the sensor; check mount.pitch_deg, mount.roll_deg and mount.height_m",
        to_degrees(seen.tilt_rad), to_degrees(seen.pitch_rad), to_degrees(seen.roll_rad), seen.height_m));
  }

  void note_rate() {
    if (recording_.size() < 2) {
      return;
    }
    const Stamp span_ns = recording_.scan(recording_.size() - 1).stamp_ns - recording_.scan(0).stamp_ns;
    const double rate_hz = static_cast<double>(recording_.size() - 1) / to_seconds(span_ns);
    if (std::abs(rate_hz - machine_.sensor.scan_hz) > kRateTolerance * machine_.sensor.scan_hz) {
      summary_.notes.push_back(
          fmt::format("the recording has {:.2f} scans a second, sensor.scan_hz of the machine is {}", rate_hz,
                      machine_.sensor.scan_hz));
    }
  }

  const Recording& recording_;
  const Machine& machine_;
  const RunOptions& options_;
  std::size_t threads_;
  Pose T_base_sensor_;
  RunEdges edges_;
  RunOdometry odometry_;
  RunLocalize localize_;
  RunSurface surface_;
  const bool maps_follow_;  ///< made with the poses of the odometry, once all are known
  std::vector<std::unique_ptr<Pipeline>> pipelines_;
  OutputFolder* output_ = nullptr;
  std::optional<ScanTable> scan_table_;
  std::optional<TimesTable> times_table_;
  std::optional<BoundaryTable> boundary_table_;
  std::optional<EdgePointTable> edge_table_;
  MountStatistics mount_;
  Trajectory trajectory_;
  RunTimes times_;
  RunSummary summary_;
};

}  // namespace

RunSummary run(const Recording& recording, const Machine& machine, const RunOptions& options) {
  machine.check();
  return Run(recording, machine, options).finish();
}

}  // namespace berm
