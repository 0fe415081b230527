#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "berm/core/point_cloud.hpp"
#include "berm/core/surface.hpp"
#include "berm/io/surface_folder.hpp"

namespace berm {

/// Levels of detail of a map, coarse to fine. They add up: a point is in exactly one.
inline constexpr std::size_t kMapLevels = 3;
/// Distance of the points of each level in voxels of the map: a quarter of the distance is 16 times the points.
inline constexpr double kMapLevelVoxels[kMapLevels] = {16.0, 4.0, 1.0};

/// Which level each point is in: the coarsest whose cell has no point yet. The same points in the same order give the
/// same levels.
[[nodiscard]] std::vector<std::uint8_t> choose_map_levels(std::span<const SurfacePoint> points, double voxel_m);

/// The map of a run in tiles of several levels of detail. The coarsest is kept in memory, joined to large tiles (1/256
/// of the points of a surface, at most `kMaxCoarsePoints`); the others are read from the run's tiles on demand.
class MapLayer {
 public:
  static constexpr std::size_t kMaxCoarsePoints = 4'000'000;

  /// Reads the whole map once, 20 M points in some seconds. Throws FileError, and Error if `stop` becomes true.
  MapLayer(const std::filesystem::path& folder, const Eigen::Vector3d& origin_m, const std::atomic<bool>& stop);

  /// The tiles as JSON, see docs/view_api.md.
  [[nodiscard]] std::string describe() const;
  /// The points of a tile as the front end takes them; none if there is no such tile. Throws FileError.
  [[nodiscard]] std::optional<std::string> read(std::size_t tile) const;

 private:
  struct Tile {
    std::uint8_t level = 0;
    TileKey key;  ///< of the run's tile; of the joined ones for level 0
    std::size_t points = 0;
    Eigen::AlignedBox3f box_m;
  };

  void add_tile(const TileKey& key);
  void add_point(Tile& tile, const SurfacePoint& point) const;

  SurfaceFolder folder_;
  Eigen::Vector3f shift_m_;  ///< from the map's origin to that of the view
  std::vector<Tile> tiles_;
  std::map<TileKey, Tile> coarse_;
  std::map<TileKey, std::vector<SurfacePoint>> coarse_points_;
  std::size_t coarse_count_ = 0;
};

}  // namespace berm
