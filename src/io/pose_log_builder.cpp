#include "pose_log_builder.hpp"

#include <utility>

#include <fmt/format.h>

#include "berm/core/error.hpp"

namespace berm {

bool is_good_fix(int quality, const PoseLogConfig& config) {
  constexpr int kSingle = 1;
  constexpr int kDifferential = 2;
  constexpr int kFixed = 4;
  constexpr int kFloat = 5;
  constexpr int kSatelliteCorrected = 9;  // NovAtel's number of what others call differential
  if (config.fix == "any") {
    return quality >= kSingle;
  }
  if (quality == kFixed || config.fix == "rtk_fixed") {
    return quality == kFixed;
  }
  return quality == kFloat ||
         (config.fix == "differential" && (quality == kDifferential || quality == kSatelliteCorrected));
}

Eigen::Quaterniond attitude_of(double yaw_rad, double pitch_rad, double roll_rad) {
  return Pose::from_yaw_pitch_roll(yaw_rad, pitch_rad, roll_rad, Eigen::Vector3d::Zero()).rotation();
}

PoseLogBuilder::PoseLogBuilder(std::string name, const PoseLogConfig& config, const GnssMountConfig& mount,
                               const DatumConfig& datum)
    : name_(std::move(name)), config_(config), given_(datum.given()) {
  config.check();
  mount.check();
  datum.check();
  T_gnss_base_ = mount.T_base_gnss().inverse();
  offset_ns_ = from_seconds(config.time_offset_s);
  if (given_) {
    frame_.emplace(*given_);
  }
  log_.datum = given_;
}

std::optional<Stamp> PoseLogBuilder::shifted(Stamp stamp_ns) const {
  Stamp result = 0;
  return __builtin_add_overflow(stamp_ns, offset_ns_, &result) ? std::nullopt : std::optional(result);
}

bool PoseLogBuilder::add_geodetic(const LoggedPose& pose) {
  if (!frame_) {
    frame_.emplace(pose.place);
    log_.datum = pose.place;
  }
  const Eigen::Quaterniond R_world_enu(frame_->R_local_enu(pose.place));
  return add(pose.stamp_ns, {R_world_enu * pose.attitude, frame_->to_local_m(pose.place)});
}

bool PoseLogBuilder::add_local(const LoggedPose& pose) {
  return add(pose.stamp_ns, {pose.attitude, pose.position_m});
}

bool PoseLogBuilder::add(Stamp stamp_ns, const Pose& T_world_gnss) {
  const std::optional<Stamp> stamp = shifted(stamp_ns);
  if (!stamp || (!log_.trajectory.empty() && *stamp <= log_.trajectory.poses().back().stamp_ns)) {
    ++log_.counts.not_rising;
    return false;
  }
  log_.trajectory.append(*stamp, T_world_gnss * T_gnss_base_);
  return true;
}

void PoseLogBuilder::add_poor_fix(Stamp stamp_ns) {
  ++log_.counts.poor_fix;
  const std::optional<Stamp> stamp = shifted(stamp_ns);
  if (stamp && (log_.poor_fix_stamps.empty() || *stamp > log_.poor_fix_stamps.back())) {
    log_.poor_fix_stamps.push_back(*stamp);
  }
}

PoseLog PoseLogBuilder::finish() {
  if (log_.trajectory.empty()) {
    const PoseLogCounts& n = log_.counts;
    throw FileError(
        ErrorCode::malformed, name_, std::nullopt,
        fmt::format("holds no pose: {} records, {} with a bad checksum, {} malformed, {} without a position, {} poorer "
                    "than poses.fix: {}, {} without an attitude; {}",
                    n.records, n.bad_checksum, n.malformed, n.no_fix, n.poor_fix, config_.fix, n.no_attitude,
                    n.poor_fix > 0 ? "if such positions will do, set poses.fix to any"
                                   : "a log needs time, position and heading"));
  }
  return std::move(log_);
}

}  // namespace berm
