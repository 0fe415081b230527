#include "berm/pipeline/run.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
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
#include "run_report.hpp"
#include "stage_times.hpp"

namespace berm {
namespace {

/// Rates that differ by more than this share are worth a note.
constexpr double kRateTolerance = 0.1;

/// One scan on its way from the recording to its label file.
struct Job {
  Scan scan;
  std::vector<Label> labels;
  GroundCounts ground;
  std::optional<std::string> failure;
  StageTime read;
  StageTime process;
};

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
        T_base_sensor_(machine.mount.T_base_sensor()) {
    summary_.counts.selected = selected_count(recording, options);
    summary_.notes = recording.notes();
    summary_.notes.insert(summary_.notes.end(), options.notes.begin(), options.notes.end());
    note_rate();
    given_poses_ = recording.read_given_poses();
    for (std::size_t worker = 0; worker < threads_; ++worker) {
      pipelines_.push_back(std::make_unique<Pipeline>(machine));
    }
  }

  RunSummary finish() {
    OutputFolder output(options_.output, options_.force, run_results(), recording_.path());
    output_ = &output;
    const StageClock clock;
    process_scans();
    if (summary_.interrupted) {
      return std::move(summary_);
    }
    if (summary_.counts.labelled == 0) {
      throw Error(ErrorCode::malformed, fmt::format("no scan of {} could be read; the first: {}",
                                                    recording_.path().string(), summary_.skipped.front().reason));
    }
    const bool has_trajectory = given_poses_ && !given_poses_->trajectory.empty();
    if (has_trajectory) {
      write_tum(output / "trajectory.tum", trajectory_);
      note_missing_poses();
    }
    times_.wall_s = clock.stop().wall_ms * 1e-3;
    write_file_atomically(output / "run.json",
                          write_run_report(recording_, machine_, options_, summary_, times_, has_trajectory));
    output.finish();
    return std::move(summary_);
  }

 private:
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
    const StageClock process_clock;
    job.scan.T_base_sensor = T_base_sensor_;
    const ScanLabels result = pipeline.process(job.scan);
    job.labels.assign(result.labels.begin(), result.labels.end());
    job.ground = result.ground;
    job.process = process_clock.stop();
  }

  /// Runs on the calling thread, scan after scan.
  bool keep(std::size_t index, const Job& job) {
    const std::string name = recording_.scan(options_.first + index).name;
    if (job.failure) {
      skip(name, *job.failure);
    } else {
      const StageClock clock;
      write_labels(*output_ / "labels" / (name + ".label"), job.labels);
      times_.write.add(clock.stop());
      times_.read.add(job.read);
      times_.ground.add(job.process);
      count(job);
      add_pose(job.scan.stamp_ns);
    }
    if (options_.on_progress) {
      options_.on_progress(index + 1, summary_.counts.selected);
    }
    summary_.interrupted = index + 1 < summary_.counts.selected && options_.should_stop && options_.should_stop();
    return !summary_.interrupted;
  }

  void skip(const std::string& name, const std::string& reason) {
    ++summary_.counts.skipped;
    if (summary_.skipped.size() < RunSummary::kListedSkips) {
      summary_.skipped.push_back({name, reason});
    }
  }

  void count(const Job& job) {
    RunCounts& counts = summary_.counts;
    ++counts.labelled;
    counts.points += job.labels.size();
    counts.drivable += job.ground.ground;
    counts.obstacle += job.ground.not_ground;
    counts.no_return += job.ground.no_return;
    counts.invalid += job.ground.invalid;
  }

  void add_pose(Stamp stamp_ns) {
    if (!given_poses_) {
      return;
    }
    const bool in_order = trajectory_.empty() || stamp_ns > trajectory_.poses().back().stamp_ns;
    const auto pose = given_poses_->trajectory.at(stamp_ns);
    if (!pose || !in_order) {
      ++summary_.counts.without_pose;
      return;
    }
    const bool of_sensor = given_poses_->of == PoseOf::sensor;
    trajectory_.append(stamp_ns, of_sensor ? *pose * T_base_sensor_.inverse() : *pose);
  }

  void note_missing_poses() {
    if (summary_.counts.without_pose > 0) {
      summary_.notes.push_back(fmt::format(
          "{} scans have no line in trajectory.tum: {} holds no pose for their stamps, or the stamps run backwards",
          summary_.counts.without_pose, given_poses_->file.filename().string()));
    }
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
  std::optional<GivenPoses> given_poses_;
  std::vector<std::unique_ptr<Pipeline>> pipelines_;
  OutputFolder* output_ = nullptr;
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
