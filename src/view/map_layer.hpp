#pragma once

#include <array>
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

/// Which level each point is in: the coarsest whose cell has no point yet, `kMapLevels` where it cannot be shown. The
/// same points in the same order give the same levels.
void choose_map_levels(std::span<const SurfacePoint> points, double voxel_m, std::vector<std::uint8_t>& levels);

/// The map of a run in tiles of several levels of detail. The coarsest is kept in memory, joined to large tiles (1/256
/// of the points of a surface, at most `kMaxCoarsePoints`); the others are read from the run's tiles on demand.
class MapLayer {
 public:
  static constexpr std::size_t kMaxCoarsePoints = 4'000'000;

  /// Reads the whole map once, with a thread for each processor but eight at most. Throws FileError, and Error if
  /// `stop` becomes true.
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

  /// What is kept of a tile that was read.
  struct TileParts {
    std::array<Tile, kMapLevels> levels;
    std::vector<SurfacePoint> coarse;
  };
  /// Memory of one thread.
  struct Scratch {
    SurfaceTileBuffer tile;
    std::vector<std::uint8_t> levels;
  };

  void read_parts(const TileKey& key, TileParts& parts, Scratch& scratch) const;
  void take_parts(const TileKey& key, const TileParts& parts, std::map<TileKey, Tile>& joined);

  SurfaceFolder folder_;
  Eigen::Vector3f shift_m_;  ///< from the map's origin to that of the view
  std::vector<Tile> tiles_;
  std::map<TileKey, std::vector<SurfacePoint>> coarse_points_;
  std::size_t coarse_count_ = 0;
};

}  // namespace berm
