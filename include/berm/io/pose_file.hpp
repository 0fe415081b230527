#pragma once

#include <cstdint>
#include <filesystem>

namespace berm {

/// What a file of poses holds.
enum class PoseFileKind : std::uint8_t {
  tum,    ///< see `read_tum`
  kitti,  ///< see `read_kitti_poses`
  log,    ///< of a GNSS receiver or an INS, see `read_pose_log`
};

/// By the ending of the name, `.tum`, `.csv` or `.nmea`; else by the first line that is neither blank nor a comment: 8
/// numbers are TUM, 12 are KITTI, anything else is NMEA. Throws FileError if the file is not there, no file or
/// unreadable.
[[nodiscard]] PoseFileKind recognise_pose_file(const std::filesystem::path& path);

}  // namespace berm
