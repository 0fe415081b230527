#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "berm/odometry/map_localizer.hpp"
#include "map_tiles.hpp"
#include "map_track.hpp"
#include "scan_points.hpp"

namespace berm {

/// Looks for the machine around a pose: starts all around it are tried, a few with each scan, and those at which the
/// scan fits the map are followed until one of them is clearly the best.
class MapSearch {
 public:
  MapSearch(const MapLocalizerConfig& config, const SurfaceOdometryConfig& matching)
      : config_(config), matching_(matching) {}

  /// Begins anew: the machine is within `radius_m` and `turn_rad`.
  void start(double radius_m, double turn_rad);
  /// The next scan; `T_map_base` is where the machine would be at its stamp. The place that was decided on, if one was.
  [[nodiscard]] std::optional<MapTrack> process(std::span<const ScanPoint> samples, const MapTiles& map,
                                                const MapMotion& motion, const Pose& T_map_base);

  /// Places that are followed.
  [[nodiscard]] std::size_t places() const { return places_.size(); }
  /// What the last scan says of the best of them; none without any.
  [[nodiscard]] std::optional<MapSighting> best() const;
  /// Whether the starts were all tried.
  [[nodiscard]] bool is_swept() const { return next_ >= starts_.size(); }

 private:
  /// Where to look, seen from the pose around which the machine is looked for: along the axes of the map.
  struct Start {
    Eigen::Vector2d offset_m;
    double turn_rad = 0.0;
  };
  struct Place {
    MapTrack track;
    MapSighting last;
    std::size_t scans = 0;
    std::size_t misfits = 0;  ///< in a row
    double doubt = 0.0;       ///< sum of how much worse than the best of its scan it fitted
  };

  void follow_places(std::span<const ScanPoint> samples, const MapTiles& map, const MapMotion& motion);
  void try_start(const Start& start, std::span<const ScanPoint> samples, const MapTiles& map, const MapMotion& motion,
                 const Pose& T_map_base);
  /// Leaves out what fits worse than another, scan after scan, and what has become the same place.
  void judge();
  [[nodiscard]] bool is_decided() const;

  MapLocalizerConfig config_;
  SurfaceOdometryConfig matching_;
  std::vector<Start> starts_;  ///< the nearest first
  std::size_t next_ = 0;
  std::vector<Place> places_;  ///< the best first
};

}  // namespace berm
