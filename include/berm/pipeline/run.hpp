#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "berm/core/pose.hpp"
#include "berm/core/pose_guard.hpp"
#include "berm/core/road.hpp"
#include "berm/io/datum.hpp"
#include "berm/io/pose_log.hpp"
#include "berm/io/recording.hpp"
#include "berm/odometry/odometry.hpp"
#include "berm/pipeline/machine.hpp"
#include "berm/pipeline/mount_check.hpp"
#include "berm/pipeline/scan_result.hpp"

namespace berm {

/// Values of PoseTrust.
inline constexpr std::size_t kPoseTrusts = 5;

struct RunOptions {
  std::filesystem::path output;
  bool force = false;                  ///< replace the results of an earlier run in `output`
  std::size_t threads = 1;             ///< scans that are worked on at a time; the results do not depend on it
  std::size_t first = 0;               ///< index of the first scan
  std::optional<std::size_t> count;    ///< number of scans; none: up to the last
  std::filesystem::path machine_file;  ///< for run.json; empty if the machine comes from no file
  std::vector<std::string> notes;      ///< to be kept in run.json beside those of the run
  std::filesystem::path poses;         ///< beats the poses of the recording; see `recognise_pose_file`
  std::filesystem::path map;           ///< edges.ot of an earlier run, which the map of this one continues
  std::filesystem::path terrain;       ///< beats mapping.terrain of the machine
  std::filesystem::path localize;      ///< map of the surface of an earlier run, in which the machine is to be located
  std::optional<Pose> start;           ///< roughly T_map_base at the first scan; none: from the poses

  /// Called on the calling thread after every scan with the number of scans done and their total.
  std::function<void(std::size_t, std::size_t)> on_progress;
  /// Asked after every scan; true ends the run early.
  std::function<bool()> should_stop;
};

/// A scan that gave no labels.
struct SkippedScan {
  std::string name;
  std::string reason;
};

struct RunCounts {
  std::size_t selected = 0;      ///< scans that were asked for
  std::size_t labelled = 0;      ///< scans whose labels were written
  std::size_t skipped = 0;       ///< scans that could not be read
  std::size_t without_pose = 0;  ///< labelled scans without a line in trajectory.tum, where the recording has poses
  std::uint64_t points = 0;
  std::uint64_t drivable = 0;
  std::uint64_t terrain = 0;
  std::uint64_t obstacle = 0;
  std::uint64_t falling_snow = 0;
  std::uint64_t no_return = 0;
  std::uint64_t invalid = 0;                          ///< NaN or absurdly far
  std::array<std::size_t, kDegradations> degraded{};  ///< scans with each kind, by its number
};

/// The poses of a run.
struct PoseFigures {
  std::string file;
  std::size_t poses = 0;
  std::optional<Geodetic> datum;                   ///< origin of the world, where it is known
  std::optional<PoseLogCounts> log;                ///< of the records of a log
  std::size_t jumps = 0;                           ///< steps that no machine drives
  std::array<double, kPoseTrusts> distrusted_s{};  ///< time without trust, by PoseTrust
};

/// What the odometry says of its poses.
struct OdometryCounts {
  std::size_t scans = 0;
  std::array<std::size_t, kOdometryHealths> health{};  ///< scans in each, by OdometryHealth
  std::size_t sessions = 0;                            ///< more than one: it was lost for good and began anew
  double path_m = 0.0;
};

/// Where the machine was in a saved map.
struct LocalizationCounts {
  std::string map;
  std::size_t scans = 0;
  std::size_t located = 0;                             ///< those that are good or weak
  std::array<std::size_t, kOdometryHealths> health{};  ///< scans in each, by OdometryHealth
  std::optional<double> first_s;                       ///< from the first scan to the first that is located
  double mean_ground_fit = 0.0;                        ///< of those that are located
  std::size_t most_tiles = 0;                          ///< in memory at a time
  std::size_t broken_tiles = 0;                        ///< that could not be read, and are left out
};

/// Values of RuleVerdict.
inline constexpr std::size_t kRuleVerdicts = 4;

/// Stations of the road, and at how many of them each rule has which verdict, by RuleVerdict.
struct RoadCounts {
  std::size_t stations = 0;
  std::array<std::size_t, kRuleVerdicts> width{};
  std::array<std::size_t, kRuleVerdicts> grade{};
  std::array<std::size_t, kRuleVerdicts> left_berm{};
  std::array<std::size_t, kRuleVerdicts> right_berm{};
};

/// What became of the edges of the road.
struct EdgeCounts {
  std::uint64_t points = 0;                           ///< that were found, in all labelled scans
  bool has_map = false;                               ///< nothing below without a map
  std::size_t mapped = 0;                             ///< scans that went into the map
  std::array<std::size_t, kPoseTrusts> not_mapped{};  ///< scans that did not, by PoseTrust
  std::uint64_t left_out = 0;                         ///< points of mapped scans without a time, or too far out
  std::string world;                                  ///< name of the map's world
  std::size_t voxels = 0;                             ///< of the map that were seen
  std::array<std::size_t, 2> lines{};                 ///< by EdgeSide
  std::array<double, 2> lines_m{};                    ///< their length
  RoadCounts road;
};

/// The map of the surface.
struct SurfaceCounts {
  std::size_t mapped = 0;                             ///< scans that went into it
  std::array<std::size_t, kPoseTrusts> not_mapped{};  ///< scans that did not, by PoseTrust
  std::uint64_t points = 0;                           ///< that were mapped
  std::uint64_t left_out = 0;                         ///< points without a time, or too far out
  std::uint64_t voxels = 0;                           ///< points of map.pcd
  std::uint64_t moved = 0;                            ///< voxels that were taken out, since they were looked through
  std::size_t tiles = 0;
  std::array<double, 3> origin_m{};      ///< of the coordinates in map and map.pcd, in the world frame
  std::uint64_t elevation_cells = 0;     ///< with ground
  std::uint64_t depth_cells = 0;         ///< with a snow depth
  std::optional<double> median_depth_m;  ///< of the snow
};

struct RunSummary {
  RunCounts counts;
  std::optional<PoseFigures> poses;
  std::optional<OdometryCounts> odometry;  ///< with an odometry method
  std::optional<LocalizationCounts> localization;
  std::optional<EdgeCounts> edges;       ///< with an edge method
  std::optional<SurfaceCounts> surface;  ///< where one was made
  std::vector<SkippedScan> skipped;      ///< the first `kListedSkips`
  std::vector<std::string> notes;
  MountSummary mount;
  bool interrupted = false;  ///< `should_stop` ended it: run.json was not written

  static constexpr std::size_t kListedSkips = 1000;
};

/// Takes a recording through the chain and writes the files of a run (docs/command_line.md): labels, scans.csv,
/// times.csv, boundary.csv with a piste method, the edges of the road and their map with an edge method, the
/// trajectory, and run.json last. A scan that cannot be read is skipped and counted. Same recording and machine, same
/// bytes, but for the times in run.json and times.csv.
///
/// Throws Error: invalid_argument if `first` and `count` select nothing or `map` cannot be continued, exists or
/// write_failed for the output, the first scan's error if no scan at all can be read; ConfigError as `Machine::check`.
[[nodiscard]] RunSummary run(const Recording& recording, const Machine& machine, const RunOptions& options);

}  // namespace berm
