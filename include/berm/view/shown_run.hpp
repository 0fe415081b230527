#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "berm/core/scan.hpp"
#include "berm/core/trajectory.hpp"
#include "berm/io/recording.hpp"

namespace berm {

/// What is known of how a scan was processed.
enum class ScanHealth : std::uint8_t { unknown, whole, degraded, skipped };

/// What a run's table says of a scan, or its file.
struct ShownScan {
  std::string name;
  Stamp stamp_ns = 0;
  std::uint32_t points = 0;  ///< no-returns included; 0: not known before it is read, as most of a long recording
  ScanHealth health = ScanHealth::unknown;
};

/// One argument of `berm view`: a run folder with the recording that it names, or a recording alone. Nothing of it is
/// kept in memory but names and poses. All const functions may be called from several threads at once.
class ShownRun {
 public:
  /// Opens either. A folder with a run.json is a run; its recording is looked for where run.json says, then beside the
  /// run. Throws FileError: not there, no recording, run.json is no such file, a trajectory that is broken.
  [[nodiscard]] static ShownRun open(const std::filesystem::path& path);

  [[nodiscard]] const std::string& name() const { return name_; }
  [[nodiscard]] bool is_run() const { return is_run_; }
  [[nodiscard]] const std::filesystem::path& folder() const { return folder_; }
  [[nodiscard]] const std::string& machine() const { return machine_; }
  [[nodiscard]] const std::string& sensor() const { return sensor_; }
  /// "none" for a recording.
  [[nodiscard]] const std::string& piste_method() const { return piste_method_; }
  [[nodiscard]] const Pose& T_base_sensor() const { return T_base_sensor_; }
  [[nodiscard]] const Recording& recording() const { return recording_; }
  /// T_world_base; empty where it is not known.
  [[nodiscard]] const Trajectory& trajectory() const { return trajectory_; }

  /// Scans that are shown: those of the run, or all of the recording.
  [[nodiscard]] std::size_t size() const { return count_; }
  /// Index in the recording of scan `index`, which must be below `size()`.
  [[nodiscard]] std::size_t recording_index(std::size_t index) const { return first_ + index; }
  /// All scans, as the run's table or the heads of the files have them. Reads them at every call.
  [[nodiscard]] std::vector<ShownScan> list_scans() const;

  /// Reads a scan with its labels: those of the run, else the truth of the recording, else those of the scan file. A
  /// label file that is missing or does not fit leaves the scan without labels. Throws FileError as `Recording::read`.
  void read(std::size_t index, Scan& scan) const;

  /// A file of the run, or of the recording where this is one; none if it is not there.
  [[nodiscard]] std::optional<std::filesystem::path> find_file(const std::string& name) const;

 private:
  explicit ShownRun(Recording recording) : recording_(std::move(recording)) {}
  static ShownRun open_run(const std::filesystem::path& folder);
  static ShownRun open_recording(const std::filesystem::path& path);

  Recording recording_;
  std::string name_;
  bool is_run_ = false;
  std::filesystem::path folder_;
  std::string machine_;
  std::string sensor_;
  std::string piste_method_ = "none";
  Pose T_base_sensor_;
  Trajectory trajectory_;
  std::size_t first_ = 0;
  std::size_t count_ = 0;
};

}  // namespace berm
