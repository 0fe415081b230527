#pragma once

#include <cstddef>
#include <span>

#include "berm/core/pose.hpp"
#include "berm/odometry/map_localizer.hpp"
#include "berm/odometry/odometry.hpp"
#include "scan_matcher.hpp"
#include "scan_points.hpp"
#include "scan_poses.hpp"
#include "surface_map.hpp"

namespace berm {

/// How well a scan lies on the map: 1 where every point is in the middle of its surface, 0 where none is on any. Any
/// ground fits nearly any other, so that what stands on it is judged by itself, and counts as much.
struct MapFit {
  std::size_t ground = 0;
  std::size_t standing = 0;   ///< points of what stands on the ground
  double ground_error = 0.0;  ///< sum of squared distances, in shares of the farthest that is on the map
  double standing_error = 0.0;

  [[nodiscard]] double ground_fit() const;
  [[nodiscard]] double standing_fit() const;
  /// Of both; where there is next to nothing of one of them, that of the other.
  [[nodiscard]] double fit() const;
  /// Whether this is the place, as far as one scan can tell. `leniency`: 1, or less.
  [[nodiscard]] bool is_at_home(const MapLocalizerConfig& config, double leniency = 1.0) const;
};

[[nodiscard]] MapFit fit_of(std::span<const ScanPoint> samples, const Surfaces& map, const ScanPoses& motion,
                            double noise_m);

/// How the machine moved since the scan before.
struct MapMotion {
  Pose T_before_begin;  ///< the base at the stamp of this scan, seen from that at the stamp of the scan before
  Pose T_begin_end;     ///< seen from the base at the stamp of this scan
  double gap_s = 0.0;   ///< from the last point of the scan before to the stamp of this one
  double duration_s = 0.0;
  bool is_trusted = false;  ///< else how the machine moved in the map before is as good a guess
};

/// What one scan says of a place.
struct MapSighting {
  ScanPoses motion;
  MapFit fit;
  Matrix6d covariance = Matrix6d::Zero();  ///< of T_map_end, see `ScanMatch`
  double weakest = 0.0;                    ///< share of what is known in the weakest direction that the scan says
  bool is_sound = false;
};

/// One place in the map at which the machine may be, followed from scan to scan.
class MapTrack {
 public:
  MapTrack(const SurfaceOdometryConfig& matching, const Pose& T_map_base)
      : matching_(matching), motion_{T_map_base, T_map_base} {}

  /// Matches the first scan, at whose stamp the machine is roughly at `T_map_base`.
  [[nodiscard]] MapSighting begin(std::span<const ScanPoint> samples, const Surfaces& map, const MapMotion& motion);
  /// Matches the next scan.
  [[nodiscard]] MapSighting follow(std::span<const ScanPoint> samples, const Surfaces& map, const MapMotion& motion);
  /// Takes over what a scan says.
  void accept(const MapSighting& sighting, const MapMotion& motion);
  /// Goes on without a scan.
  void drift(const MapMotion& motion);

  /// T_map_base during the last scan.
  [[nodiscard]] const ScanPoses& poses() const { return motion_; }

 private:
  [[nodiscard]] ScanPoses expect(const MapMotion& motion) const;
  [[nodiscard]] MapSighting match(std::span<const ScanPoint> samples, const Surfaces& map, const MotionPrior& prior);

  SurfaceOdometryConfig matching_;
  ScanPoses motion_;
  Vector6d velocity_ = Vector6d::Zero();  ///< per s, frame of the base
  std::size_t seen_ = 0;                  ///< scans that were taken over
};

}  // namespace berm
