#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <vector>

#include <Eigen/Core>

#include "berm/core/surface.hpp"
#include "berm/odometry/map_localizer.hpp"
#include "surface_map.hpp"

namespace berm {

/// The ground at a place of a map.
struct MapGround {
  double height_m = 0.0;
  Eigen::Vector3d normal;  ///< up
};

/// The part of a saved map that is near the machine. Tiles come and go as a whole, so that what is in memory does not
/// depend on the way that led there.
class MapTiles final : public Surfaces {
 public:
  MapTiles(const SurfaceOdometryConfig& matching, double reach_m, MapTileSource& source);

  /// Fetches what is near a place and forgets what is far: the nearer half of the reach at once, of the rest a bounded
  /// number of points with each call.
  void follow(const Eigen::Vector3d& place_m);

  [[nodiscard]] SurfaceHit find(const Eigen::Vector3d& map_m, bool is_ground) const override;
  /// The plane through the ground around a place, from as far as there is enough of it; none where there is not.
  [[nodiscard]] std::optional<MapGround> ground_at(const Eigen::Vector2d& place_m) const;
  /// In memory.
  [[nodiscard]] std::size_t size() const { return tiles_.size(); }

 private:
  /// Of the ground in a square of `kGroundCell_m`.
  struct GroundCell {
    double height_sum_m = 0.0;
    std::uint32_t points = 0;
  };
  struct Tile {
    explicit Tile(const SurfaceOdometryConfig& matching) : map(matching) {}
    SurfaceMap map;
    std::vector<SurfacePoint> rest;  ///< not in `map` yet, the next at the back
    std::vector<GroundCell> ground;  ///< row by row
  };

  [[nodiscard]] TileKey tile_of(double x_m, double y_m) const;
  [[nodiscard]] double distance_m(const TileKey& key, const Eigen::Vector3d& place_m) const;
  [[nodiscard]] std::vector<TileKey> tiles_within(double radius_m, const Eigen::Vector3d& place_m) const;
  [[nodiscard]] const GroundCell* ground_cell(double x_m, double y_m) const;
  void fetch(const TileKey& key);
  void add(Tile& tile, std::size_t count) const;

  SurfaceOdometryConfig matching_;
  double reach_m_;
  MapTileSource& source_;
  double tile_m_;
  std::size_t ground_cells_;  ///< along a side
  Eigen::Vector3d origin_m_;
  std::map<TileKey, Tile> tiles_;
};

}  // namespace berm
