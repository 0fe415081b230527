#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <map>
#include <span>
#include <string>
#include <vector>

#include <Eigen/Core>
#include <tsl/robin_map.h>

#include "berm/core/config.hpp"
#include "berm/core/label.hpp"
#include "berm/core/surface.hpp"
#include "berm/geometry/voxel_hash.hpp"
#include "berm/map/beam_image.hpp"

namespace berm {

/// Settings of the map of the surface and of what is made of it.
struct SurfaceMapConfig {
  bool surface = false;
  double voxel_m = 0.1;
  double tile_m = 20.0;
  double max_range_m = 50.0;
  double keep_m = 70.0;
  bool remove_moved = true;
  double cell_m = 0.5;
  std::string terrain;
  double terrain_offset_m = 0.0;

  static void fields(auto&& field) {
    field("surface", &SurfaceMapConfig::surface, "whether a map of the surface is made where there are poses");
    field("voxel_m", &SurfaceMapConfig::voxel_m, Range{0.02, 2.0}, "side of a voxel");
    field("tile_m", &SurfaceMapConfig::tile_m, Range{1.0, 500.0}, "side of a tile, a file of the map");
    field("max_range_m", &SurfaceMapConfig::max_range_m, Range{1.0, 300.0},
          "farthest points from the sensor that are mapped");
    field("keep_m", &SurfaceMapConfig::keep_m, Range{1.0, 2000.0},
          "tiles farther from the machine are on the disk only; more than max_range_m");
    field("remove_moved", &SurfaceMapConfig::remove_moved, "whether obstacles that were looked through are taken out");
    field("cell_m", &SurfaceMapConfig::cell_m, Range{0.05, 50.0}, "cell of the elevation raster");
    field("terrain", &SurfaceMapConfig::terrain, TextLimit{1000},
          "elevation model of the ground in summer (GeoTIFF or ESRI ASCII grid), from which snow depth is measured");
    field("terrain_offset_m", &SurfaceMapConfig::terrain_offset_m, Range{-200.0, 200.0},
          "added to the heights of terrain: such as the geoid, where its heights are above the sea");
  }
  /// Throws ConfigError, also unless voxel_m <= cell_m <= tile_m and max_range_m < keep_m.
  void check() const;
};

/// A point that is to be mapped, in the world frame.
struct SurfaceSample {
  Eigen::Vector3d place_m;
  float intensity = 0.0F;
  Label label = Label::unlabeled;  ///< drivable, terrain or obstacle; others are left out
};

/// What one scan brings, in the world frame.
struct SurfaceScan {
  Eigen::Vector3d sensor_m = Eigen::Vector3d::Zero();
  std::vector<SurfaceSample> samples;
  std::vector<BeamImage> beams;  ///< of all returns; several where the sensor moved far during the scan
};

/// Where tiles are kept that are not in memory.
class SurfaceStore {
 public:
  SurfaceStore() = default;
  SurfaceStore(const SurfaceStore&) = delete;
  SurfaceStore& operator=(const SurfaceStore&) = delete;
  virtual ~SurfaceStore() = default;

  /// What was saved of a tile last; nothing if it never was.
  [[nodiscard]] virtual std::vector<SurfacePoint> load(const TileKey& key) = 0;
  /// Replaces a tile. No points: there is none any more.
  virtual void save(const TileKey& key, std::span<const SurfacePoint> points) = 0;
  /// The tiles saved so far belong together.
  virtual void commit() = 0;
};

/// What became of the points.
struct SurfaceTileCounts {
  std::uint64_t points = 0;    ///< mapped
  std::uint64_t left_out = 0;  ///< without a finite place, or too far out to be counted
  std::uint64_t moved = 0;     ///< voxels that were taken out, since they were looked through
  std::uint64_t saved = 0;     ///< tiles written, each time counted
  std::uint64_t loaded = 0;    ///< tiles that the machine came back to
};

/// The map of the surface in voxels, a square tile at a time: place, intensity and label of what was met. Tiles that
/// the machine has left are handed to a store and fetched when it comes back, so that memory depends on the
/// surroundings of the machine and not on the length of the drive.
///
/// What moved is told from what stands by what was looked through. Obstacles are counted in cells of 4 x 4 x 4 voxels:
/// scans that met something there against scans whose beams passed through the middle of what had been met. Both scans
/// before and after count: the last `kHistory` images for cells that are new, all later scans, one in `kStride` each.
/// A cell that was looked through as often as it was hit, or for `kGone` scans on end, holds nothing that stands; nor
/// does one that was hit in few scans and has mostly such cells around it. Terrain in such a cell goes as well.
class SurfaceTiles {
 public:
  /// Scans between two images that are compared.
  static constexpr std::uint16_t kStride = 4;
  /// Images of earlier scans that new obstacles are compared with.
  static constexpr std::size_t kHistory = 20;
  static constexpr std::uint16_t kGone = 80;

  /// Coordinates are counted from `origin_m`. Throws ConfigError as `SurfaceMapConfig::check`.
  SurfaceTiles(const SurfaceMapConfig& config, const Eigen::Vector3d& origin_m, SurfaceStore& store);

  /// In the order of scans. Throws what the store throws.
  void add(const SurfaceScan& scan);
  /// Hands every tile to the store.
  void finish();

  [[nodiscard]] const SurfaceTileCounts& counts() const { return counts_; }
  /// Side of a tile: a whole number of voxels.
  [[nodiscard]] double tile_m() const { return tile_voxels_ * config_.voxel_m; }
  [[nodiscard]] std::size_t tiles_in_memory() const { return tiles_.size(); }
  [[nodiscard]] std::size_t voxels_in_memory() const;

 private:
  struct Voxel {
    float offset_m[3] = {};  ///< of the mean from the lower corner
    float intensity = 0.0F;
    std::uint32_t count = 0;
    std::uint16_t votes[3] = {};  ///< drivable, terrain, obstacle
  };
  /// Evidence for something that stands.
  struct Cell {
    Eigen::Vector3f mean_m = Eigen::Vector3f::Zero();  ///< of obstacle points, from the middle of the cell
    std::uint32_t points = 0;
    std::uint32_t last_hit = 0;  ///< number of the scan
    std::uint16_t hits = 0;
    std::uint16_t passes = 0;
    std::uint16_t since_hit = 0;  ///< passes after the last hit
  };
  struct Tile {
    tsl::robin_map<VoxelKey, Voxel, VoxelKeyHash> voxels;
    tsl::robin_map<VoxelKey, Cell, VoxelKeyHash> cells;
  };

  [[nodiscard]] TileKey tile_of(const VoxelKey& key) const;
  Tile& tile_at(const TileKey& key);
  void add_sample(const SurfaceSample& sample);
  void hit(Tile& tile, const VoxelKey& voxel, const Eigen::Vector3d& from_origin_m);
  void look_back();
  void look_through(const SurfaceScan& scan);
  void remember(const SurfaceScan& scan);
  void give_away(const Eigen::Vector3d& sensor_m);
  void save(const TileKey& key, const Tile& tile);
  void load(const TileKey& key, Tile& tile);
  [[nodiscard]] Eigen::Vector3d place_m(const VoxelKey& cell, const Cell& evidence) const;
  [[nodiscard]] static bool was_looked_through(const Cell& cell);
  /// By itself, or as part of a thing that has: most of its neighbours in the tile were looked through.
  [[nodiscard]] static bool has_moved(const Tile& tile, const VoxelKey& key, const Cell& cell);
  [[nodiscard]] double distance_m(const TileKey& key, const Eigen::Vector3d& sensor_m) const;

  SurfaceMapConfig config_;
  Eigen::Vector3d origin_m_;
  SurfaceStore& store_;
  std::int32_t tile_voxels_;
  double cell_m_;
  std::map<TileKey, Tile> tiles_;
  std::deque<std::vector<BeamImage>> history_;
  std::uint32_t scans_ = 0;
  SurfaceTileCounts counts_;
  // Of the scan at work.
  Tile* tile_ = nullptr;
  TileKey tile_key_;
  struct NewCell {
    TileKey tile;
    VoxelKey cell;
  };
  std::vector<NewCell> new_cells_;
  std::vector<SurfacePoint> points_;
};

}  // namespace berm
