#include "map_track.hpp"

#include <algorithm>
#include <cmath>

#include <Eigen/Eigenvalues>

namespace berm {
namespace {

/// A point is on a surface if it is nearer to it than so many sigmas.
constexpr double kOnMap = 3.0;
/// With a smaller share of the points, what stands says nothing of the place.
constexpr double kFewStandingShare = 0.05;
/// and fewer points in number say nothing at all.
constexpr std::size_t kTelling = 20;

/// How far odometry and map drift apart from scan to scan.
constexpr double kMapDrift_m = 0.03;
constexpr double kMapDrift_rad = 0.004;
/// Where a start may be off the place that it stands for: half a step between two starts, and a height and an attitude
/// that were told from the ground beside it.
constexpr double kMapStart_m = 0.6;
constexpr double kMapStart_rad = 0.06;
/// Surfaces are looked for so far around at first.
constexpr double kRoughNoise_m = 0.2;
/// As in SurfaceTrack: a speed that nobody knows, and a scan shorter than this still leaves time to change it.
constexpr double kMapUnknownSpeed = 10.0;
/// Less than the odometry's: a wide prior lets a wrong place follow the waves of the ground as long as the right one.
constexpr double kMapAcceleration_mps2 = 3.0;
constexpr std::size_t kMapUnknownScans = 3;
constexpr double kLeastMapScan_s = 0.05;
constexpr double kMapRigid = 1e-6;

/// Squared distance to a surface in shares of the farthest that is on it; 1 for all that are not on it.
double error_of(const SurfaceHit& hit, const Eigen::Vector3d& map_m, double noise_m) {
  if (hit.cell == nullptr) {
    return 1.0;
  }
  const Eigen::Vector3d error_m = map_m - hit.mean_m;
  double sigmas_squared = 0.0;
  if (hit.cell->shape() == SurfaceShape::plane) {
    const double distance_m = hit.cell->normal().cast<double>().dot(error_m);
    sigmas_squared = distance_m * distance_m / (noise_m * noise_m + static_cast<double>(hit.cell->thickness_m2()));
  } else {
    sigmas_squared = error_m.dot(hit.cell->information_per_m2().cast<double>() * error_m);
  }
  return std::min(1.0, sigmas_squared / (kOnMap * kOnMap));
}

double fit_from(double error_sum, std::size_t count) {
  return count == 0 ? 0.0 : 1.0 - error_sum / static_cast<double>(count);
}

/// The share of what is known in the direction in which the scan says least.
double weakest_of(const Matrix6d& covariance, const MotionPrior& prior) {
  const Vector6d before =
      (prior.begin_sigma.cwiseAbs2() + prior.displacement_sigma.cwiseAbs2()).cwiseSqrt().cwiseInverse();
  const Matrix6d left = before.asDiagonal() * covariance * before.asDiagonal();
  const Eigen::SelfAdjointEigenSolver<Matrix6d> axes(left, Eigen::EigenvaluesOnly);
  return std::clamp(1.0 - axes.eigenvalues()[5], 0.0, 1.0);  // 0 for NaN cannot be: `match` is finite
}

}  // namespace

double MapFit::ground_fit() const {
  return fit_from(ground_error, ground);
}

double MapFit::standing_fit() const {
  return fit_from(standing_error, standing);
}

double MapFit::fit() const {
  const double few = kFewStandingShare * static_cast<double>(ground + standing);
  if (static_cast<double>(standing) < few) {
    return ground_fit();
  }
  return static_cast<double>(ground) < few ? standing_fit() : 0.5 * (ground_fit() + standing_fit());
}

bool MapFit::is_at_home(const MapLocalizerConfig& config, double leniency) const {
  const bool has_ground = ground >= kTelling;
  const bool has_standing = standing >= kTelling;
  return (has_ground || has_standing) && (!has_ground || ground_fit() >= leniency * config.least_ground_fit) &&
         (!has_standing || standing_fit() >= leniency * config.least_standing_fit);
}

MapFit fit_of(std::span<const ScanPoint> samples, const Surfaces& map, const ScanPoses& motion, double noise_m) {
  MapFit fit;
  const PoseSteps steps(motion);
  for (const ScanPoint& sample : samples) {
    const Eigen::Vector3d map_m = steps.to_world(sample.base_m, sample.share);
    const double error = error_of(map.find(map_m, sample.is_ground), map_m, noise_m);
    ++(sample.is_ground ? fit.ground : fit.standing);
    (sample.is_ground ? fit.ground_error : fit.standing_error) += error;
  }
  return fit;
}

ScanPoses MapTrack::expect(const MapMotion& motion) const {
  if (motion.is_trusted) {
    const Pose T_map_begin = motion_.T_world_begin * motion.T_before_begin;
    return {T_map_begin, T_map_begin * motion.T_begin_end};
  }
  const Pose T_map_begin = motion_.T_world_end * Pose::exp(motion.gap_s * velocity_);
  return {T_map_begin, T_map_begin * Pose::exp(motion.duration_s * velocity_)};
}

MapSighting MapTrack::match(std::span<const ScanPoint> samples, const Surfaces& map, const MotionPrior& prior) {
  ScanMatcher matcher(matching_);
  const ScanMatch match = matcher.match(samples, map, prior);
  return {.motion = match.motion,
          .fit = fit_of(samples, map, match.motion, matching_.noise_m),
          .covariance = match.covariance,
          .weakest = match.is_sound ? weakest_of(match.covariance, prior) : 0.0,
          .is_sound = match.is_sound};
}

MapSighting MapTrack::begin(std::span<const ScanPoint> samples, const Surfaces& map, const MapMotion& motion) {
  MotionPrior prior;
  prior.expected.T_world_begin = motion_.T_world_begin;
  prior.expected.T_world_end = motion.is_trusted ? motion_.T_world_begin * motion.T_begin_end : motion_.T_world_begin;
  const double changes_s2 = motion.duration_s * (motion.is_trusted ? 1.0 : kMapUnknownSpeed) * motion.duration_s;
  prior.displacement_sigma = motion_sigmas(kMapRigid + kMapAcceleration_mps2 * changes_s2,
                                           kMapRigid + matching_.turn_acceleration_rps2 * changes_s2);
  prior.begin_sigma = motion_sigmas(kMapStart_m, kMapStart_rad);
  SurfaceOdometryConfig rough = matching_;
  rough.noise_m = kRoughNoise_m;
  ScanMatcher matcher(rough);
  prior.expected = matcher.match(samples, map, prior).motion;
  return match(samples, map, prior);
}

MapSighting MapTrack::follow(std::span<const ScanPoint> samples, const Surfaces& map, const MapMotion& motion) {
  MotionPrior prior;
  prior.expected = expect(motion);
  const double unknown = !motion.is_trusted && seen_ < kMapUnknownScans ? kMapUnknownSpeed : 1.0;
  const double acceleration_mps2 = kMapAcceleration_mps2 * unknown;
  const double gap_s2 = motion.is_trusted ? 0.0 : motion.gap_s * motion.gap_s;
  const double changes_s2 = motion.duration_s * std::max(motion.duration_s, kLeastMapScan_s);
  prior.begin_sigma = motion_sigmas(kMapDrift_m + acceleration_mps2 * gap_s2,
                                    kMapDrift_rad + matching_.turn_acceleration_rps2 * gap_s2);
  prior.displacement_sigma = motion_sigmas(kMapRigid + acceleration_mps2 * changes_s2,
                                           kMapRigid + matching_.turn_acceleration_rps2 * changes_s2);
  return match(samples, map, prior);
}

void MapTrack::accept(const MapSighting& sighting, const MapMotion& motion) {
  const double time_s = motion.gap_s + motion.duration_s;
  if (seen_ > 0 && time_s > 0.0) {
    velocity_ = (motion_.T_world_end.inverse() * sighting.motion.T_world_end).log() / time_s;
  } else if (motion.duration_s > 0.0) {
    velocity_ = sighting.motion.displacement() / motion.duration_s;
  }
  motion_ = sighting.motion;
  ++seen_;
}

void MapTrack::drift(const MapMotion& motion) {
  motion_ = expect(motion);
}

}  // namespace berm
