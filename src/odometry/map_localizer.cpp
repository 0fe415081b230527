#include "berm/odometry/map_localizer.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <vector>

#include "berm/core/error.hpp"
#include "berm/core/stamp.hpp"
#include "map_search.hpp"
#include "map_tiles.hpp"
#include "map_track.hpp"
#include "scan_points.hpp"

namespace berm {
namespace {

/// Maps end about so far from where the machine drove, and far points are thin.
constexpr double kFarthest_m = 50.0;
/// Samples for places that are looked at by the dozen.
constexpr std::size_t kSearchSamples = 600;
/// Below this share of what is known, the odometry decides: a start that was decided wrongly, 3 m off, had 0.13 to 0.25
/// until it slid to its place. Of scans that are rightly located 0 to 9 % have less (four drives of docs/localize.md).
constexpr double kWeakShare = 0.2;
/// Once the machine is located, a scan may fit by this factor worse.
constexpr double kStay = 0.9;
/// So many scans in a row may not fit before other places are looked at.
constexpr std::size_t kPatience = 5;
/// The odometry since the last scan that fitted is off by such a share of the way, and by this at least.
constexpr double kSearchShare = 0.03;
constexpr double kSearch_m = 1.0;
constexpr double kSearch_rad = 0.09;
/// Farther around, in radii of the start, the machine is not looked for.
constexpr double kMostRadii = 3.0;

SurfaceOdometryConfig near_only(SurfaceOdometryConfig matching) {
  matching.max_range_m = std::min(matching.max_range_m, kFarthest_m);
  return matching;
}

}  // namespace

struct MapLocalizer::State {
  State(const MapLocalizerConfig& settings, const SurfaceOdometryConfig& matching_settings, MapTileSource& source)
      : config(settings),
        matching(near_only(matching_settings)),
        tiles(matching, settings.reach_m, source),
        search(settings, matching),
        here(matching, Pose()) {}

  MapLocalizerConfig config;
  SurfaceOdometryConfig matching;
  ScanThinner scan;
  std::vector<ScanPoint> few;
  MapTiles tiles;
  MapSearch search;
  MapTrack here;  ///< where the machine is, or would be
  bool is_located = false;
  bool is_first_search = true;
  std::size_t lost_scans = 0;
  double lost_way_m = 0.0;  ///< since the last scan that fitted
  std::optional<Pose> T_odom_before;
  Stamp end_ns = 0;  ///< of the scan before

  MapMotion motion_since(const OdometryInput& input, const OdometryResult& odometry) {
    MapMotion motion;
    if (!odometry.revised.empty() && T_odom_before) {
      T_odom_before = odometry.revised.back();
    }
    if (T_odom_before) {
      motion.T_before_begin = T_odom_before->inverse() * odometry.T_world_begin;
      motion.gap_s = std::max(0.0, to_seconds(input.stamp_ns - end_ns));
    }
    motion.T_begin_end = odometry.T_world_begin.inverse() * odometry.T_world_end;
    motion.duration_s = odometry.duration_s;
    motion.is_trusted = odometry.health == OdometryHealth::good || odometry.health == OdometryHealth::weak;
    T_odom_before = odometry.T_world_begin;
    end_ns = input.stamp_ns + from_seconds(odometry.duration_s);
    return motion;
  }

  void look_around() {
    const double most_m = kMostRadii * std::max(config.start_radius_m, kSearch_m);
    const double least_m = is_first_search ? config.start_radius_m : kSearch_m;
    const double turn_rad = is_first_search ? config.start_turn_deg * std::numbers::pi / 180.0 : kSearch_rad;
    search.start(std::min(most_m, least_m + kSearchShare * lost_way_m), turn_rad);
  }

  MapPose pose_of(const ScanPoses& poses) const {
    return {.T_map_begin = poses.T_world_begin, .T_map_end = poses.T_world_end, .tiles = tiles.size()};
  }

  static void tell(const MapSighting& sighting, MapPose& pose) {
    pose.covariance = sighting.covariance;
    pose.weakest = sighting.weakest;
    pose.ground_fit = sighting.fit.ground_fit();
    pose.standing_fit = sighting.fit.standing_fit();
    pose.samples = sighting.fit.ground + sighting.fit.standing;
  }

  MapPose stay(const MapMotion& motion) {
    const MapSighting sighting = here.follow(scan.samples(), tiles, motion);
    const bool fits = sighting.is_sound && sighting.fit.is_at_home(config, kStay);
    if (fits) {
      here.accept(sighting, motion);
      lost_scans = 0;
      lost_way_m = 0.0;
    } else {
      here.drift(motion);
      lost_way_m += motion.T_before_begin.translation_m().norm();
      is_located = ++lost_scans < kPatience;
      if (!is_located) {
        look_around();
      }
    }
    MapPose pose = pose_of(here.poses());
    tell(sighting, pose);
    if (fits) {
      pose.health = sighting.weakest < kWeakShare ? OdometryHealth::weak : OdometryHealth::good;
    }
    return pose;
  }

  MapPose look(const MapMotion& motion) {
    // Nothing better is known of the motion than what the odometry says, even at its start.
    MapMotion believed = motion;
    believed.is_trusted = true;
    here.drift(believed);
    lost_way_m += motion.T_before_begin.translation_m().norm();
    few = scan.samples();
    limit_points(few, kSearchSamples);
    const auto found = search.process(few, tiles, motion, here.poses().T_world_begin);
    MapPose pose = pose_of(here.poses());
    if (const auto best = search.best()) {
      pose = pose_of(best->motion);
      tell(*best, pose);
      pose.health = OdometryHealth::starting;
      pose.places = search.places();
    }
    if (found) {
      here = *found;
      is_located = true;
      is_first_search = false;
      lost_scans = 0;
      lost_way_m = 0.0;
      pose.places = 0;
      pose.health = pose.weakest < kWeakShare ? OdometryHealth::weak : OdometryHealth::good;
    } else if (search.is_swept() && search.places() == 0) {
      look_around();
    }
    return pose;
  }
};

MapLocalizer::MapLocalizer(const MapLocalizerConfig& config, const SurfaceOdometryConfig& matching,
                           MapTileSource& tiles) {
  config.check();
  matching.check();
  state_ = std::make_unique<State>(config, matching, tiles);
}

MapLocalizer::~MapLocalizer() = default;

bool MapLocalizer::start(const Pose& T_map_base) {
  State& state = *state_;
  if (!T_map_base.matrix().allFinite()) {
    return false;
  }
  state.here = MapTrack(state.matching, T_map_base);
  state.is_located = false;
  state.is_first_search = true;
  state.tiles.follow(T_map_base.translation_m());
  state.look_around();
  return state.tiles.ground_at(T_map_base.translation_m().head<2>()).has_value();
}

MapPose MapLocalizer::process(const OdometryInput& input, const OdometryResult& odometry) {
  State& state = *state_;
  if (input.labels.size() != input.points.size()) {
    throw Error(ErrorCode::invalid_argument, "localisation: expected a label for every point");
  }
  const MapMotion motion = state.motion_since(input, odometry);
  state.scan.process(input, state.matching);
  state.tiles.follow(state.here.poses().T_world_end.translation_m());
  return state.is_located ? state.stay(motion) : state.look(motion);
}

}  // namespace berm
