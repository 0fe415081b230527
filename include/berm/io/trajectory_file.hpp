#pragma once

#include <filesystem>
#include <istream>
#include <span>
#include <string>
#include <vector>

#include "berm/core/pose.hpp"
#include "berm/core/trajectory.hpp"

namespace berm {

/// Coordinates beyond this are refused as broken: no earth-centred or projected coordinate is as large.
constexpr double kMaxCoordinate_m = 1e9;

/// Reads a trajectory in TUM format, `t x y z qx qy qz qw` a line, s and m. Blank lines and lines that start with '#'
/// are skipped. Throws FileError with the number of the line: not exactly 8 finite numbers, a coordinate beyond
/// `kMaxCoordinate_m`, a quaternion whose norm is off 1 by more than 1e-2 (it is normalised otherwise), a stamp that is
/// not later than the one before; also if the file is not there or unreadable.
[[nodiscard]] Trajectory read_tum(const std::filesystem::path& path);

/// The same from a stream; `name` stands for the file in errors.
[[nodiscard]] Trajectory read_tum(std::istream& input, const std::string& name);

/// Writes `t x y z qx qy qz qw`: 9 decimals for seconds and quaternion, 6 for metres, qw >= 0, one space between, none
/// at the end. Same trajectory, same bytes. Throws FileError(write_failed) as AtomicFile.
void write_tum(const std::filesystem::path& path, const Trajectory& trajectory);

/// Reads poses in KITTI format: 12 numbers a line, the rows of a 3x4 matrix [R t]; no stamps. R has to be a rotation
/// within 1e-3. Throws FileError like `read_tum`.
[[nodiscard]] std::vector<Pose> read_kitti_poses(const std::filesystem::path& path);

/// The same from a stream; `name` stands for the file in errors.
[[nodiscard]] std::vector<Pose> read_kitti_poses(std::istream& input, const std::string& name);

/// Writes poses in KITTI format with 12 decimals. Throws FileError(write_failed) as AtomicFile.
void write_kitti_poses(const std::filesystem::path& path, std::span<const Pose> poses);

/// Reads T_camera_lidar from KITTI's calib.txt: the line `Tr:` (odometry) or `Tr_velo_to_cam:` (object); lines with
/// other keys are skipped. Throws FileError if there is none, two, or one that is no rigid motion.
[[nodiscard]] Pose read_kitti_calibration(const std::filesystem::path& path);

/// The same from a stream; `name` stands for the file in errors.
[[nodiscard]] Pose read_kitti_calibration(std::istream& input, const std::string& name);

}  // namespace berm
