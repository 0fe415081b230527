#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "berm/core/pose.hpp"
#include "berm/core/pose_guard.hpp"
#include "berm/core/trajectory.hpp"
#include "berm/io/datum.hpp"
#include "berm/io/pose_log.hpp"
#include "berm/io/recording.hpp"
#include "berm/pipeline/machine.hpp"

namespace berm {

/// The poses of a run, wherever they come from.
struct RunPoses {
  std::filesystem::path file;
  Trajectory trajectory;               ///< T_world_base
  std::optional<Geodetic> datum;       ///< origin of the world frame, where it is known
  std::string world;                   ///< name of the world frame: maps of two worlds are not put together
  std::optional<PoseLogCounts> log;    ///< what became of the records, where `file` is a log
  std::vector<Stamp> poor_fix_stamps;  ///< rising
  std::vector<std::string> notes;
};

/// Where the poses of a run come from.
struct PoseSource {
  std::filesystem::path file;         ///< beats what the recording brings; empty: the latter
  std::optional<Geodetic> old_datum;  ///< of the map that is continued: beats the first fix of a log
};

/// The poses of `source`; none if there are none. Throws FileError for a broken file, Error(invalid_argument) for poses
/// that do not lie within reach of their datum; FileError for a `source.file` that shares no time with the scans,
/// whereas poses of the recording that do not are noted and left out.
[[nodiscard]] std::optional<RunPoses> read_run_poses(const Recording& recording, const Machine& machine,
                                                     const PoseSource& source);

}  // namespace berm
