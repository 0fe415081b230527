#pragma once

#include <optional>
#include <string>

#include <Eigen/Geometry>

#include "berm/io/pose_log.hpp"

namespace berm {

/// Position and attitude at one time, as a log gives them.
struct LoggedPose {
  Stamp stamp_ns = 0;
  Geodetic place;
  Eigen::Vector3d position_m = Eigen::Vector3d::Zero();          ///< in place of `place`
  Eigen::Quaterniond attitude = Eigen::Quaterniond::Identity();  ///< against east, north, up; against the world
};

/// Whether a position of this quality (GGA: 1 single, 2 differential, 4 RTK fixed, 5 RTK float, ...) is used.
[[nodiscard]] bool is_good_fix(int quality, const PoseLogConfig& config);

/// The attitude of a level frame that is turned; angles as in `Pose::from_yaw_pitch_roll`.
[[nodiscard]] Eigen::Quaterniond attitude_of(double yaw_rad, double pitch_rad, double roll_rad);

/// Makes a PoseLog of records in the order of the file: time offset, datum, lever arm, boresight.
class PoseLogBuilder {
 public:
  PoseLogBuilder(std::string name, const PoseLogConfig& config, const GnssMountConfig& mount, const DatumConfig& datum);

  /// Makes room at once: a vector that grows holds its poses twice for a moment.
  void reserve(std::size_t count) { log_.trajectory.reserve(count); }

  /// False, and counted, if it is not later than the one before.
  bool add_geodetic(const LoggedPose& pose);
  bool add_local(const LoggedPose& pose);
  void add_poor_fix(Stamp stamp_ns);
  void note(const std::string& text) { log_.notes.push_back(text); }

  [[nodiscard]] PoseLogCounts& counts() { return log_.counts; }
  [[nodiscard]] const PoseLogConfig& config() const { return config_; }

  /// Throws FileError if there is no pose.
  [[nodiscard]] PoseLog finish();

 private:
  bool add(Stamp stamp_ns, const Pose& T_world_gnss);
  [[nodiscard]] std::optional<Stamp> shifted(Stamp stamp_ns) const;

  std::string name_;
  PoseLogConfig config_;
  Pose T_gnss_base_;
  std::optional<Geodetic> given_;
  Stamp offset_ns_ = 0;
  std::optional<LocalFrame> frame_;
  PoseLog log_;
};

}  // namespace berm
