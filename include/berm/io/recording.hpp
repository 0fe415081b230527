#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "berm/core/scan.hpp"
#include "berm/core/stamp.hpp"
#include "berm/core/trajectory.hpp"
#include "berm/io/kitti_bin.hpp"
#include "berm/io/scan_record.hpp"
#include "berm/io/sensor_sheet.hpp"

namespace berm {

/// How the files of a recording lie on disk (docs/formats.md).
enum class RecordingLayout : std::uint8_t {
  sequence,     ///< FOLDER/scans/NNNNNN.pcd
  kitti,        ///< FOLDER/velodyne/NNNNNN.bin
  pcd_folder,   ///< FOLDER/*.pcd
  bin_folder,   ///< FOLDER/*.bin
  single_file,  ///< one .pcd or .bin
};
[[nodiscard]] std::string_view to_string(RecordingLayout layout);

/// Where the stamps of a recording come from.
enum class StampSource : std::uint8_t {
  times_file,    ///< times.txt
  scan_files,    ///< every scan file holds absolute time
  assumed_rate,  ///< nothing says: first scan at 0, `scan_hz` of sequence.json or else 10 Hz
};
[[nodiscard]] std::string_view to_string(StampSource source);

/// One scan of a recording, before it is read.
struct ScanEntry {
  std::string name;  ///< the file's stem, "000123"; no two scans of a recording share one
  std::filesystem::path file;
  std::optional<std::filesystem::path> truth_labels;  ///< labels/NAME.label, where it exists
  /// Start of the scan. With StampSource::scan_files an estimate between the first and the last scan; the true one is
  /// in `Scan::stamp_ns` after reading, since only the file knows it.
  Stamp stamp_ns = 0;
};

/// Whose motion a file of poses describes.
enum class PoseOf : std::uint8_t {
  base,    ///< T_world_base (gnss.tum)
  sensor,  ///< T_world_sensor (poses.txt of KITTI); T_world_base = T_world_sensor * T_base_sensor.inverse()
};

/// Poses that come with a recording; the world frame is that of the file.
struct GivenPoses {
  Trajectory trajectory;
  PoseOf of = PoseOf::base;
  std::filesystem::path file;
};

/// A recording on disk. `open` lists the files and looks into the first scans; scans are read one by one on demand, so
/// that memory does not grow with the recording. All const functions may be called from several threads at once.
class Recording {
 public:
  /// Opens a folder or a single file. Throws FileError: not there, unreadable, no scans in it, a sidecar file that
  /// contradicts the scans (times.txt of another length or running backwards, sequence.json of wrong types).
  [[nodiscard]] static Recording open(const std::filesystem::path& path);

  [[nodiscard]] RecordingLayout layout() const { return layout_; }
  [[nodiscard]] const std::filesystem::path& path() const { return path_; }
  [[nodiscard]] std::size_t size() const { return names_.size(); }

  /// Throws Error(invalid_argument) for an index outside [0, size).
  [[nodiscard]] ScanEntry scan(std::size_t index) const;

  /// Reads one scan into `scan`: sets its stamp and cloud, leaves `T_base_sensor` to the caller and reuses the memory
  /// of the cloud. Throws FileError if the file is missing or broken; `scan` then holds no points. Stamps of
  /// consecutive scans strictly increase unless they come from the scan files, where a broken file can break the order.
  void read(std::size_t index, Scan& scan) const;

  /// The same with what the file says about itself: names of fields, notes, absolute time.
  [[nodiscard]] ScanRecord read_record(std::size_t index, PointChannels reuse = {}) const;

  [[nodiscard]] StampSource stamp_source() const { return stamp_source_; }
  [[nodiscard]] const SensorSheet& sheet() const { return sheet_; }

  /// What was assumed or is odd, one sentence each: "no times.txt: 10 Hz assumed".
  [[nodiscard]] const std::vector<std::string>& notes() const { return notes_; }

  /// Poses that a machine had on board: gnss.tum, else KITTI's poses.txt moved from the left camera to the LiDAR by
  /// calib.txt; none without them, or with a `pose_log`. Reads the file at every call. Throws FileError.
  [[nodiscard]] std::optional<GivenPoses> read_given_poses() const;

  /// A log of poses beside the scans, which is to be used: gnss.csv, else gnss.nmea, where there is no gnss.tum. See
  /// `read_pose_log`.
  [[nodiscard]] const std::optional<std::filesystem::path>& pose_log() const { return pose_log_file_; }

  /// Poses in `file`, wherever it lies, as TUM or KITTI has them: the latter belong to the scans of this recording and
  /// need its calib.txt. Throws FileError.
  [[nodiscard]] static GivenPoses read_tum_poses(const std::filesystem::path& file);
  [[nodiscard]] GivenPoses read_camera_poses(const std::filesystem::path& file) const;

  /// Truth: truth.tum, T_world_base; none without it. Reads the file at every call. Throws FileError.
  [[nodiscard]] std::optional<Trajectory> read_truth_poses() const;

 private:
  Recording() = default;
  friend class RecordingOpener;

  void check_index(std::size_t index) const;
  [[nodiscard]] std::filesystem::path file(std::size_t index) const;

  RecordingLayout layout_ = RecordingLayout::single_file;
  std::filesystem::path path_;
  std::filesystem::path scan_folder_;
  std::string extension_;  ///< of all scans, ".pcd" or ".bin"
  /// All that is kept per scan, since a recording can have 10^5 of them: full paths are put together on demand.
  std::vector<std::string> names_;
  std::vector<Stamp> stamps_ns_;
  std::vector<bool> has_labels_;
  StampSource stamp_source_ = StampSource::assumed_rate;
  IntensityScale intensity_scale_ = IntensityScale::byte;  ///< of .bin files
  std::optional<std::filesystem::path> gnss_file_;
  std::optional<std::filesystem::path> pose_log_file_;
  std::optional<std::filesystem::path> camera_poses_file_;
  std::optional<std::filesystem::path> calibration_file_;
  std::optional<std::filesystem::path> truth_poses_file_;
  SensorSheet sheet_;
  std::vector<std::string> notes_;
};

}  // namespace berm
