#pragma once

#include <cstddef>
#include <filesystem>
#include <string>

#include <Eigen/Core>

#include "berm/core/pose.hpp"
#include "berm/core/scan.hpp"
#include "berm/core/stamp.hpp"
#include "berm/core/trajectory.hpp"
#include "berm/io/datum.hpp"
#include "berm/pipeline/machine.hpp"

namespace berm::test {

/// A truck with 16 rings at 4 m that drives along a straight level road between berms, at 8 m/s with 10 scans a second.
struct TruckDrive {
  std::size_t scans = 30;
  Stamp start_ns = 0;                                  ///< stamp of the first scan
  double heading_rad = 0.5;                            ///< of the road, from x of the world to the left
  Eigen::Vector3d origin_m = Eigen::Vector3d::Zero();  ///< where the first scan is taken

  static constexpr double kHalfWidth_m = 8.0;  ///< from the path to the toe of a berm
  static constexpr double kSpeed_mps = 8.0;

  [[nodiscard]] Pose T_world_base(Stamp stamp_ns) const;
  /// 20 poses a second, from the first scan to a little after the last.
  [[nodiscard]] Trajectory poses() const;
  /// To the left of the path. m.
  [[nodiscard]] double offset_m(const Eigen::Vector3d& position_m) const;
  /// Along the path from where it starts. m.
  [[nodiscard]] double chainage_m(const Eigen::Vector3d& position_m) const;
};

/// machines/haul_truck.yaml.
[[nodiscard]] Machine haul_truck();

/// One scan of the drive, firing column by column over 0.1 s; each `index` has noise of its own. All of them see the
/// same road.
[[nodiscard]] Scan truck_scan(std::size_t index);

/// A sequence folder with scans and times.txt, without poses.
void make_truck_recording(const std::filesystem::path& folder, const TruckDrive& drive);

/// The lines of a TUM file, of a pose log in CSV with x, y, z, and of an NMEA log with GGA and HDT.
[[nodiscard]] std::string as_tum(const Trajectory& poses);
[[nodiscard]] std::string as_csv(const Trajectory& poses);
[[nodiscard]] std::string as_nmea(const Trajectory& poses, const Geodetic& datum);

}  // namespace berm::test
