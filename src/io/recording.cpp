#include "berm/io/recording.hpp"

#include <utility>

#include "berm/core/error.hpp"
#include "berm/io/pcd.hpp"
#include "berm/io/trajectory_file.hpp"
#include "recording_opener.hpp"
#include "scan_names.hpp"

namespace berm {
namespace {

namespace fs = std::filesystem;

/// Poses of the LiDAR from those of the left camera: T_lidar0_lidar = T_lidar_camera * T_camera0_camera *
/// T_camera_lidar.
Trajectory to_lidar(const std::vector<Pose>& camera_poses, const Pose& T_camera_lidar,
                    const std::vector<std::size_t>& lines, const std::vector<Stamp>& stamps_ns) {
  const Pose T_lidar_camera = T_camera_lidar.inverse();
  Trajectory trajectory;
  trajectory.reserve(stamps_ns.size());
  for (std::size_t i = 0; i < stamps_ns.size(); ++i) {
    trajectory.append(stamps_ns[i], T_lidar_camera * camera_poses[lines[i]] * T_camera_lidar);
  }
  return trajectory;
}

}  // namespace

std::string_view to_string(RecordingLayout layout) {
  switch (layout) {
    case RecordingLayout::sequence:
      return "sequence folder";
    case RecordingLayout::kitti:
      return "KITTI layout";
    case RecordingLayout::pcd_folder:
      return "folder of PCD files";
    case RecordingLayout::bin_folder:
      return "folder of KITTI .bin files";
    case RecordingLayout::single_file:
      break;
  }
  return "single file";
}

std::string_view to_string(StampSource source) {
  switch (source) {
    case StampSource::times_file:
      return "times.txt";
    case StampSource::scan_files:
      return "scan files";
    case StampSource::assumed_rate:
      break;
  }
  return "assumed rate";
}

Recording Recording::open(const fs::path& path) {
  return RecordingOpener(path).open();
}

fs::path Recording::file(std::size_t index) const {
  return scan_folder_ / (names_[index] + extension_);
}

void Recording::check_index(std::size_t index) const {
  if (index >= size()) {
    throw Error(ErrorCode::invalid_argument, path_.string() + ": there is no scan " + std::to_string(index) +
                                                 ", the recording has " + std::to_string(size()));
  }
}

ScanEntry Recording::scan(std::size_t index) const {
  check_index(index);
  ScanEntry entry{.name = names_[index], .file = file(index), .truth_labels = {}, .stamp_ns = stamps_ns_[index]};
  if (has_labels_[index]) {
    entry.truth_labels = path_ / "labels" / (names_[index] + ".label");
  }
  return entry;
}

ScanRecord Recording::read_record(std::size_t index, PointChannels reuse) const {
  check_index(index);
  return extension_ == kPcdExtension ? read_pcd(file(index), std::move(reuse))
                                     : read_kitti_bin(file(index), intensity_scale_, std::move(reuse));
}

void Recording::read(std::size_t index, Scan& scan) const {
  ScanRecord record = read_record(index, std::exchange(scan.cloud, {}).release());
  const bool file_knows = stamp_source_ == StampSource::scan_files && record.start_ns.has_value();
  scan.stamp_ns = file_knows ? *record.start_ns : stamps_ns_[index];
  scan.cloud = PointCloud(std::move(record.channels));
}

std::optional<GivenPoses> Recording::read_given_poses() const {
  if (gnss_file_) {
    return read_tum_poses(*gnss_file_);
  }
  return camera_poses_file_ ? std::optional(read_camera_poses(*camera_poses_file_)) : std::nullopt;
}

GivenPoses Recording::read_tum_poses(const fs::path& file) {
  return {.trajectory = read_tum(file), .of = PoseOf::base, .file = file};
}

GivenPoses Recording::read_camera_poses(const fs::path& file) const {
  if (!calibration_file_) {
    throw FileError(ErrorCode::not_found, file.string(), std::nullopt,
                    "holds poses as KITTI has them, in the frame of the left camera; the recording has no calib.txt "
                    "that leads from there to the LiDAR");
  }
  const std::vector<Pose> poses = read_kitti_poses(file);
  const auto lines = match_lines(names_, poses.size());
  if (!lines) {
    throw FileError(ErrorCode::malformed, file.string(), std::nullopt,
                    describe_line_mismatch(names_, poses.size(), "poses"));
  }
  return {.trajectory = to_lidar(poses, read_kitti_calibration(*calibration_file_), *lines, stamps_ns_),
          .of = PoseOf::sensor,
          .file = file};
}

std::optional<Trajectory> Recording::read_truth_poses() const {
  return truth_poses_file_ ? std::optional(read_tum(*truth_poses_file_)) : std::nullopt;
}

}  // namespace berm
