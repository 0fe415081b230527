#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include <Eigen/Core>

#include "berm/core/config.hpp"
#include "berm/core/surface.hpp"
#include "berm/odometry/odometry.hpp"
#include "berm/odometry/surface_odometry.hpp"

namespace berm {

/// Settings of the localisation in a saved map.
struct MapLocalizerConfig {
  double start_radius_m = 2.0;
  double start_turn_deg = 10.0;
  double reach_m = 60.0;
  double least_ground_fit = 0.8;
  double least_standing_fit = 0.25;

  static void fields(auto&& field);
  void check() const { check_fields(*this, "localize"); }
};

/// A saved map of the surface, a tile at a time.
class MapTileSource {
 public:
  MapTileSource() = default;
  MapTileSource(const MapTileSource&) = delete;
  MapTileSource& operator=(const MapTileSource&) = delete;
  virtual ~MapTileSource() = default;

  [[nodiscard]] virtual double tile_m() const = 0;
  /// Of the coordinates of points and tiles, in the frame of the map.
  [[nodiscard]] virtual Eigen::Vector3d origin_m() const = 0;
  [[nodiscard]] virtual bool has(const TileKey& key) const = 0;
  /// The points of a tile that there is. None where it cannot be read.
  [[nodiscard]] virtual std::vector<SurfacePoint> load(const TileKey& key) = 0;
};

/// Where the machine is in the map, as the scan tells.
struct MapPose {
  Pose T_map_begin;  ///< T_map_base at the stamp of the scan
  Pose T_map_end;    ///< T_map_base at its last point
  /// `starting`: places are followed that may be the one. `lost`: the scan fits nowhere that was looked at: it is
  /// outside of the map, or far from where it was expected, and the pose is that of the odometry since it last fitted.
  /// Poses of both are guesses.
  OdometryHealth health = OdometryHealth::lost;
  Matrix6d covariance = Matrix6d::Zero();  ///< of T_map_end, along the axes of the map, about the base
  double weakest = 0.0;                    ///< share of what is known in the weakest direction that the scan says, 0..1
  double ground_fit = 0.0;    ///< how well the ground of the scan lies on the map: 0 not at all, 1 right on it
  double standing_fit = 0.0;  ///< the same of what stands on the ground; 0 if nothing does
  std::size_t samples = 0;    ///< points that were compared with the map
  std::size_t places = 0;     ///< that are followed; 0 once it is decided
  std::size_t tiles = 0;      ///< of the map that are in memory
};

/// Where the machine is in a saved map, scan by scan: from a rough start, with the motion that an odometry tells.
///
/// Starts all around the rough one are tried, a few with each scan; those at which the scan fits the map are followed,
/// until one is left that fits clearly better than any other, scan after scan. From then on every scan is matched from
/// the pose before and the motion since. When scans no longer fit, the pose is that of the odometry, and places around
/// it are tried anew.
///
/// Bounded work per scan and memory; the same scans and map, the same poses.
class MapLocalizer {
 public:
  /// `matching`: how scans are thinned and matched. `tiles` must outlive this. Throws ConfigError as the `check` of
  /// both configurations.
  MapLocalizer(const MapLocalizerConfig& config, const SurfaceOdometryConfig& matching, MapTileSource& tiles);
  ~MapLocalizer();

  /// Where to look for the machine at the first scan: place and yaw of `T_map_base`. Height, roll and pitch are those
  /// of the ground that the map holds there. False if there is none.
  [[nodiscard]] bool start(const Pose& T_map_base);

  /// The next scan; `odometry` is what an odometry made of it. Throws Error(invalid_argument) unless there is a label
  /// for every point.
  [[nodiscard]] MapPose process(const OdometryInput& input, const OdometryResult& odometry);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

void MapLocalizerConfig::fields(auto&& field) {
  using C = MapLocalizerConfig;
  field("start_radius_m", &C::start_radius_m, Range{0.0, 10.0}, "how far off the rough start may be");
  field("start_turn_deg", &C::start_turn_deg, Range{0.0, 45.0}, "how far its heading may be turned");
  field("reach_m", &C::reach_m, Range{20.0, 500.0}, "tiles of the map nearer than this are in memory");
  field("least_ground_fit", &C::least_ground_fit, Range{0.05, 1.0},
        "how well the ground of a scan must lie on the map, else it is lost: 1 at best");
  field("least_standing_fit", &C::least_standing_fit, Range{0.0, 1.0}, "the same of what stands on it");
}

}  // namespace berm
