#pragma once

#include <cstddef>
#include <filesystem>
#include <istream>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "berm/core/config.hpp"
#include "berm/core/pose.hpp"
#include "berm/core/trajectory.hpp"
#include "berm/io/datum.hpp"

namespace berm {

/// Where antenna and attitude sensor of the pose log sit on the machine.
struct GnssMountConfig {
  double x_m = 0.0;
  double y_m = 0.0;
  double z_m = 0.0;
  double roll_deg = 0.0;
  double pitch_deg = 0.0;
  double yaw_deg = 0.0;

  static void fields(auto&& field) {
    field("x_m", &GnssMountConfig::x_m, Range{-50.0, 50.0}, "place that the log gives, forward of base_link");
    field("y_m", &GnssMountConfig::y_m, Range{-50.0, 50.0}, "the same, to the left");
    field("z_m", &GnssMountConfig::z_m, Range{-50.0, 50.0}, "the same, above the ground under base_link");
    field("roll_deg", &GnssMountConfig::roll_deg, Range{-180.0, 180.0},
          "boresight: how the attitude sensor is turned against base_link; right side down is positive");
    field("pitch_deg", &GnssMountConfig::pitch_deg, Range{-180.0, 180.0}, "nose down is positive");
    field("yaw_deg", &GnssMountConfig::yaw_deg, Range{-180.0, 180.0},
          "turned to the left is positive: 90 for two antennas with the first to the right and the second to the left");
  }
  void check() const { check_fields(*this, "gnss"); }

  /// From the frame of the log, origin at the antenna and axes of the attitude sensor, to base_link.
  [[nodiscard]] Pose T_base_gnss() const;
};

/// What is taken from a pose log.
struct PoseLogConfig {
  std::string fix = "rtk";
  double time_offset_s = 0.0;
  double geoid_separation_m = 0.0;
  double max_attitude_gap_s = 1.0;

  static void fields(auto&& field) {
    field("fix", &PoseLogConfig::fix, Choices{{"any", "differential", "rtk", "rtk_fixed"}},
          "poorest position that is used; rtk is float or fixed");
    field("time_offset_s", &PoseLogConfig::time_offset_s, Range{-4e9, 4e9},
          "added to the time of poses: time of the scans minus time of the log");
    field("geoid_separation_m", &PoseLogConfig::geoid_separation_m, Range{-200.0, 200.0},
          "height of the geoid above the ellipsoid, for NMEA positions that do not say it");
    field("max_attitude_gap_s", &PoseLogConfig::max_attitude_gap_s, Range{0.001, 60.0},
          "the attitude is interpolated over no more than this");
  }
  void check() const { check_fields(*this, "poses"); }
};

/// What became of the records of a log: rows of a CSV, sentences of NMEA.
struct PoseLogCounts {
  std::size_t records = 0;       ///< all that were read
  std::size_t bad_checksum = 0;  ///< sentences whose checksum is missing or contradicts them
  std::size_t malformed = 0;     ///< sentences with the right checksum that hold what no such sentence holds
  std::size_t no_fix = 0;        ///< without a position
  std::size_t poor_fix = 0;      ///< with one poorer than PoseLogConfig::fix
  std::size_t no_attitude = 0;   ///< with a position, but no attitude near it in time
  std::size_t not_rising = 0;    ///< not later than a pose before
};

struct PoseLog {
  Trajectory trajectory;               ///< T_world_base
  std::optional<Geodetic> datum;       ///< origin of the world frame, where it is known
  std::vector<Stamp> poor_fix_stamps;  ///< rising; for PoseGuard
  PoseLogCounts counts;
  std::vector<std::string> notes;  ///< what was assumed or left out, in words
};

/// Reads a log of poses: CSV if the name ends in `.csv`, NMEA 0183 otherwise. The world frame is that of the datum, or
/// that of the file where it holds x, y, z. Throws FileError: not there, unreadable, malformed, or without a single
/// pose, which says what became of the records; ConfigError as the `check` of the configurations.
[[nodiscard]] PoseLog read_pose_log(const std::filesystem::path& path, const PoseLogConfig& config,
                                    const GnssMountConfig& mount, const DatumConfig& datum);

/// Reads a CSV whose header names its columns:
///
///   time      `t` (s) or `t_ns`
///   position  `x`, `y`, `z` (m, world) or `lat_deg`, `lon_deg`, `h_m` (above the ellipsoid)
///   attitude  `qx`, `qy`, `qz`, `qw`, or `yaw_deg` (from east to the left) or `heading_deg` (from north to the right),
///             with `roll_deg` and `pitch_deg` (nose down is positive) or level; `_rad` in place of `_deg` is taken
///   quality   `quality`, optional, the numbers of NMEA's GGA
///
/// Other columns are noted. A row with an empty value, NaN or infinity is one without a fix, and counted. Throws
/// FileError with the number of the line for anything else that is no number, a quaternion whose norm is off 1 by more
/// than 1e-2, stamps that do not rise, a column twice, missing or said in two ways.
[[nodiscard]] PoseLog read_pose_csv(const std::filesystem::path& path, const PoseLogConfig& config,
                                    const GnssMountConfig& mount, const DatumConfig& datum);

/// The same from a stream; `name` stands for the file in errors.
[[nodiscard]] PoseLog read_pose_csv(std::istream& input, const std::string& name, const PoseLogConfig& config,
                                    const GnssMountConfig& mount, const DatumConfig& datum);

/// Reads NMEA 0183 sentences of any talker: GGA (position, quality, a pose for each), PASHR (heading, roll, pitch at
/// its own time), HDT or THS (heading at the time said last) where there is no PASHR, RMC and ZDA (date). What is not
/// NMEA between them is passed over. Stamps are UTC since 1970, or since the first midnight where nothing says the
/// date. Throws FileError only if no pose is left.
[[nodiscard]] PoseLog parse_nmea(std::string_view text, const std::string& name, const PoseLogConfig& config,
                                 const GnssMountConfig& mount, const DatumConfig& datum);

}  // namespace berm
