#include "berm/view/shown_run.hpp"

#include <algorithm>
#include <system_error>
#include <utility>

#include "berm/core/angle.hpp"
#include "berm/core/error.hpp"
#include "berm/io/file_reader.hpp"
#include "berm/io/label_file.hpp"
#include "berm/io/pose_log.hpp"
#include "berm/io/trajectory_file.hpp"
#include "run_sheet.hpp"
#include "scan_list.hpp"

namespace berm {
namespace {

namespace fs = std::filesystem;

/// Heads of scan files that are read to list them.
constexpr std::size_t kMostHeads = 1000;

bool is_there(const fs::path& file) {
  std::error_code code;
  return fs::exists(file, code);
}

/// The last name in a path, "." and "out/" too.
std::string name_of(const fs::path& path) {
  std::error_code code;
  const fs::path whole = fs::weakly_canonical(path, code);
  const fs::path name = (code ? path : whole).filename();
  return name.empty() ? path.string() : name.string();
}

Recording open_recording_of(const RunSheet& sheet, const fs::path& folder) {
  const fs::path beside = fs::absolute(folder).lexically_normal().parent_path();
  for (const fs::path& candidate : {sheet.recording, beside / sheet.recording, beside / sheet.recording.filename()}) {
    if (is_there(candidate)) {
      return Recording::open(candidate);
    }
  }
  throw FileError(
      ErrorCode::not_found, sheet.recording.string(), std::nullopt,
      "the recording of the run " + folder.string() +
          " is not there; call berm view from the folder where berm run was called, or put it beside the run");
}

/// The mount as sequence.json has it; on the ground without one.
Pose mount_of(const SensorSheet& sheet) {
  MountConfig mount;
  mount.height_m = sheet.height_m.value_or(0.0);
  mount.pitch_deg = sheet.pitch_rad.value_or(0.0) * kDegPerRad;
  mount.roll_deg = sheet.roll_rad.value_or(0.0) * kDegPerRad;
  mount.yaw_deg = sheet.yaw_rad.value_or(0.0) * kDegPerRad;
  return mount.T_base_sensor();
}

/// Poses that come with a recording, else its truth.
Trajectory poses_of(const Recording& recording, const Pose& T_base_sensor) {
  if (recording.pose_log()) {
    return read_pose_log(*recording.pose_log(), PoseLogConfig(), GnssMountConfig(), DatumConfig()).trajectory;
  }
  const std::optional<GivenPoses> given = recording.read_given_poses();
  if (!given) {
    return recording.read_truth_poses().value_or(Trajectory());
  }
  if (given->of == PoseOf::base) {
    return given->trajectory;
  }
  Trajectory trajectory;
  const Pose T_sensor_base = T_base_sensor.inverse();
  for (const StampedPose& pose : given->trajectory.poses()) {
    trajectory.append(pose.stamp_ns, pose.T_world_base * T_sensor_base);
  }
  return trajectory;
}

}  // namespace

ShownRun ShownRun::open(const fs::path& path) {
  return is_there(path / "run.json") ? open_run(path) : open_recording(path);
}

ShownRun ShownRun::open_run(const fs::path& folder) {
  const RunSheet sheet = read_run_sheet(folder / "run.json");
  ShownRun run(open_recording_of(sheet, folder));
  run.is_run_ = true;
  run.folder_ = folder;
  run.name_ = name_of(folder);
  run.machine_ = sheet.machine;
  run.sensor_ = sheet.sensor;
  run.piste_method_ = sheet.piste_method;
  run.T_base_sensor_ = sheet.mount.T_base_sensor();
  run.first_ = std::min(sheet.first, run.recording_.size());
  run.count_ = std::min(sheet.scans, run.recording_.size() - run.first_);
  if (const auto file = run.find_file("trajectory.tum")) {
    run.trajectory_ = read_tum(*file);
  }
  return run;
}

ShownRun ShownRun::open_recording(const fs::path& path) {
  ShownRun run(Recording::open(path));
  run.folder_ = path;
  run.name_ = name_of(path);
  run.sensor_ = run.recording_.sheet().sensor.value_or("");
  run.T_base_sensor_ = mount_of(run.recording_.sheet());
  run.count_ = run.recording_.size();
  run.trajectory_ = poses_of(run.recording_, run.T_base_sensor_);
  return run;
}

std::vector<ShownScan> ShownRun::list_scans() const {
  FileBuffer buffer;
  std::map<std::string, ScanRow, std::less<>> rows;
  const auto table = is_run_ ? find_file("scans.csv") : std::nullopt;
  if (table) {
    read_file(*table, buffer);
    rows = parse_scan_rows(buffer.text());
  }
  // The head of a file takes the disk a while, and a bar of 1000 is as wide as a screen.
  const std::size_t stride = count_ / kMostHeads + 1;
  std::vector<ShownScan> scans;
  scans.reserve(count_);
  for (std::size_t i = 0; i < count_; ++i) {
    const ScanEntry entry = recording_.scan(recording_index(i));
    ShownScan scan{.name = entry.name, .stamp_ns = entry.stamp_ns};
    if (const auto row = rows.find(entry.name); row != rows.end()) {
      scan.points = row->second.points;
      scan.health = row->second.degraded ? ScanHealth::degraded : ScanHealth::whole;
    } else {
      scan.points = i % stride == 0 ? announced_points(entry.file) : 0;
      scan.health = table ? ScanHealth::skipped : ScanHealth::unknown;
    }
    scans.push_back(std::move(scan));
  }
  return scans;
}

void ShownRun::read(std::size_t index, Scan& scan) const {
  recording_.read(recording_index(index), scan);
  scan.T_base_sensor = T_base_sensor_;
  const ScanEntry entry = recording_.scan(recording_index(index));
  const auto file = is_run_ ? find_file("labels/" + entry.name + ".label") : entry.truth_labels;
  if (!file) {
    return;
  }
  PointChannels channels = std::exchange(scan.cloud, {}).release();
  try {
    const std::vector<std::uint32_t> raw = read_labels(*file, channels.x.size());
    channels.label.resize(raw.size());
    std::transform(raw.begin(), raw.end(), channels.label.begin(), to_label);
  } catch (const FileError&) {
    channels.label.clear();
  }
  scan.cloud = PointCloud(std::move(channels));
}

std::optional<fs::path> ShownRun::find_file(const std::string& name) const {
  fs::path file = folder_ / name;
  return is_there(file) ? std::optional(std::move(file)) : std::nullopt;
}

}  // namespace berm
