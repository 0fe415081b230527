#include "surface_track.hpp"

#include <algorithm>

#include "berm/core/stamp.hpp"

namespace berm {
namespace {

/// The end of one scan is the begin of the next: what is between them is the error of a screw for the motion within.
constexpr double kSeam_m = 0.01;
constexpr double kSeam_rad = 0.002;
/// What a scan without duration moves by, to keep the equations regular: m and rad.
constexpr double kRigid = 1e-6;
/// A start of any speed: so many times the acceleration, for so many scans.
constexpr double kUnknownSpeed = 10.0;
constexpr double kUnknownTurn = 2.0;
constexpr std::size_t kUnknownScans = 4;
/// A scan shorter than this, of a sensor with 20 Hz, leaves the machine as much time to change its motion: jolts last
/// about so long, and what they change adds up from scan to scan.
constexpr double kLeastDuration_s = 0.095;
/// Below this share of what is known, the motion before decides. On bare slopes nearly all scans bring less, where
/// things stand beside the piste at most 5 % (docs/odometry_table.md).
constexpr double kWeak = 0.33;
/// Of the samples where a full map has a surface, 97 % and more lie on it wherever a drive was followed, 99 % mostly.
/// With fewer than this the machine is elsewhere: so it was found on seven pistes of seven that another was joined to
/// (docs/odometry_long.md).
constexpr double kLeastFitting = 0.85;
/// A lost machine comes back with what is usual. Less may be chance: the ground elsewhere is ground as well, and the
/// longer the lost machine is thought to move on, the less of the map is there to object.
constexpr double kReturnFitting = 0.97;
/// A standing machine fills its map with this many scans, and adds none until it moved.
constexpr std::size_t kFullMap = 30;
constexpr double kMoved_m = 0.05;
constexpr double kTurned_rad = 0.01;
/// So often the first scan is put into the map anew with the motion that the second tells.
constexpr std::size_t kSecondLooks = 4;
/// The map is cut every so many scans.
constexpr std::size_t kCutEvery = 20;

}  // namespace

SurfaceTrack::SurfaceTrack(const SurfaceOdometryConfig& config, const StartGuess& guess, const Pose& T_world_base)
    : config_(config), guess_(guess), map_(config), matcher_(config), T_world_end_(T_world_base) {
  velocity_[0] = guess.speed_mps;
}

MotionPrior SurfaceTrack::expect(double gap_s, double duration_s) const {
  MotionPrior prior;
  prior.expected.T_world_begin = T_world_end_ * Pose::exp(gap_s * velocity_);
  prior.expected.T_world_end = prior.expected.T_world_begin * Pose::exp(duration_s * velocity_);
  const bool is_unsure = !guess_.is_sure && mapped_ < kUnknownScans;
  const double acceleration_mps2 = config_.acceleration_mps2 * (is_unsure ? kUnknownSpeed : 1.0);
  const double turn_acceleration_rps2 = config_.turn_acceleration_rps2 * (is_unsure ? kUnknownTurn : 1.0);
  // Over a gap the velocity changes as it does over a scan, and the place by its integral.
  const double missed_s2 = gap_s * gap_s;
  prior.begin_sigma =
      motion_sigmas(kSeam_m + acceleration_mps2 * missed_s2, kSeam_rad + turn_acceleration_rps2 * missed_s2);
  const double changes_s2 = duration_s * (std::max(duration_s, kLeastDuration_s) + gap_s);
  prior.displacement_sigma =
      motion_sigmas(kRigid + acceleration_mps2 * changes_s2, kRigid + turn_acceleration_rps2 * changes_s2);
  return prior;
}

Vector6d SurfaceTrack::velocity_to(const ScanPoses& motion, double time_s) const {
  return (T_world_end_.inverse() * motion.T_world_end).log() / time_s;
}

ScanMatch SurfaceTrack::match_second(std::span<const ScanPoint> samples, double gap_s, double duration_s) {
  ScanMatch match = matcher_.match(samples, map_, expect(gap_s, duration_s));
  for (std::size_t i = 0; i < kSecondLooks && match.is_sound; ++i) {
    velocity_ = velocity_to(match.motion, gap_s + duration_s);
    T_world_end_ = T_world_first_ * Pose::exp(first_duration_s_ * velocity_);
    map_.clear();
    put_into_map(first_scan_, {T_world_first_, T_world_end_});
    match = matcher_.match(samples, map_, expect(gap_s, duration_s));
  }
  return match;
}

OdometryResult SurfaceTrack::add(std::span<const ScanPoint> samples, std::span<const ScanPoint> for_map,
                                 double duration_s, Stamp stamp_ns) {
  const double gap_s = end_ns_ ? std::max(0.0, to_seconds(stamp_ns - *end_ns_)) : 0.0;
  const MotionPrior prior = expect(gap_s, duration_s);
  OdometryResult result{.duration_s = duration_s, .samples = samples.size()};
  ScanPoses motion = prior.expected;
  if (mapped_ > 0) {
    const bool is_second = !first_scan_.empty() && gap_s + first_duration_s_ > 0.0;
    const ScanMatch match = is_second ? match_second(samples, gap_s, duration_s) : matcher_.match(samples, map_, prior);
    first_scan_ = {};
    result.inliers = match.inliers;
    result.iterations = match.iterations;
    result.weakest = match.weakest;
    result.covariance = match.covariance;
    if (fits(match)) {
      motion = match.motion;
      velocity_ = velocity_to(motion, gap_s + duration_s);
      lost_ = 0;
      result.health = match.weakest < kWeak ? OdometryHealth::weak : OdometryHealth::good;
    } else {
      ++lost_;
      result.health = OdometryHealth::lost;
    }
  }
  result.T_world_begin = motion.T_world_begin;
  result.T_world_end = motion.T_world_end;
  begins_.push_back(motion.T_world_begin);
  T_world_end_ = motion.T_world_end;
  end_ns_ = stamp_ns + from_seconds(duration_s);
  if (mapped_ == 0) {
    first_scan_.assign(for_map.begin(), for_map.end());
    T_world_first_ = motion.T_world_begin;
    first_duration_s_ = duration_s;
  }
  if (result.health != OdometryHealth::lost && is_worth_mapping(motion)) {
    put_into_map(for_map, motion);
    T_world_mapped_ = motion.T_world_end;
    ++mapped_;
    if (mapped_ % kCutEvery == 0) {
      map_.cut(motion.T_world_end.translation_m(), config_.keep_m);
    }
  }
  return result;
}

bool SurfaceTrack::fits(const ScanMatch& match) const {
  const double least = mapped_ < kFullMap ? 0.0 : lost_ == 0 ? kLeastFitting : kReturnFitting;
  return match.is_sound && static_cast<double>(match.inliers) >= least * static_cast<double>(match.met);
}

bool SurfaceTrack::is_worth_mapping(const ScanPoses& motion) const {
  if (mapped_ < kFullMap || !T_world_mapped_) {
    return true;
  }
  const Vector6d way = (T_world_mapped_->inverse() * motion.T_world_end).log();
  return way.head<3>().norm() >= kMoved_m || way.tail<3>().norm() >= kTurned_rad;
}

void SurfaceTrack::put_into_map(std::span<const ScanPoint> points, const ScanPoses& motion) {
  const PoseSteps steps(motion);
  for (const ScanPoint& point : points) {
    map_.add(steps.to_world(point.base_m, point.share), point.is_ground);
  }
}

}  // namespace berm
