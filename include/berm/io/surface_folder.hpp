#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <Eigen/Core>

#include "berm/core/surface.hpp"
#include "berm/io/file_reader.hpp"

namespace berm {

/// Where the tiles of a map lie, and how large they are.
struct SurfaceFrame {
  double voxel_m = 0.0;
  double tile_m = 0.0;
  /// Of the coordinates in tiles, in the world frame: floats of a UTM grid would be off by half a metre.
  Eigen::Vector3d origin_m = Eigen::Vector3d::Zero();
};

/// A tile of a map: a whole file.
struct SurfaceTileEntry {
  std::string file;
  std::uint64_t points = 0;
};

/// What tiles.json says: tiles that belong together.
struct SurfaceIndex {
  SurfaceFrame frame;
  std::map<TileKey, SurfaceTileEntry> tiles;
};

/// Reads tiles.json from memory; `name` stands for the file in errors. Throws FileError(malformed) for anything else.
[[nodiscard]] SurfaceIndex parse_surface_index(std::string_view text, const std::string& name);

/// Reads the points of a tile from memory: a binary PCD with the fields that SurfaceFolder writes, the bytes of all
/// points and no more. Throws FileError(malformed, truncated).
[[nodiscard]] std::vector<SurfacePoint> parse_surface_tile(std::span<const std::byte> bytes, const std::string& name);

/// Memory for one tile, kept from one to the next: of a large map most of the time would go into asking for it.
struct SurfaceTileBuffer {
  FileBuffer file;
  std::vector<SurfacePoint> points;
};

/// A map of the surface in a folder: a file per tile, and tiles.json that names them. A tile that is saved again gets
/// another name, and its old file goes after the index that no longer names it: at every moment, and so after a kill
/// at any moment, the index names whole files of one state of the map. Files it does not name are leftovers.
class SurfaceFolder {
 public:
  static constexpr const char* kIndex = "tiles.json";

  /// The map in `folder`, which must exist. Throws FileError as `parse_surface_index`.
  [[nodiscard]] static SurfaceFolder open(const std::filesystem::path& folder);
  /// A new map in `folder`, which must exist; nothing is written yet.
  SurfaceFolder(std::filesystem::path folder, const SurfaceFrame& frame);

  [[nodiscard]] const SurfaceIndex& index() const { return index_; }
  [[nodiscard]] std::uint64_t points() const;

  /// Points of a tile as saved last; nothing if there is none. Throws FileError for a file that is broken or holds
  /// another number of points than the index says.
  [[nodiscard]] std::vector<SurfacePoint> load(const TileKey& key) const;
  /// The same into `buffer.points`. Several threads may load at once, each with its own buffer.
  void load(const TileKey& key, SurfaceTileBuffer& buffer) const;
  /// Writes a tile; without points there is none. Throws FileError(write_failed).
  void save(const TileKey& key, std::span<const SurfacePoint> points);
  /// Writes the index, then removes the files that it no longer names.
  void commit();

 private:
  std::filesystem::path folder_;
  SurfaceIndex index_;
  std::map<TileKey, std::uint32_t> revisions_;
  std::vector<std::string> outdated_;
};

/// Writes all points of the map to one binary PCD, tile after tile: x y z intensity label count. x y z are from
/// `SurfaceFrame::origin_m`. Throws as `SurfaceFolder::load`, FileError(write_failed).
void write_surface_cloud(const std::filesystem::path& path, const SurfaceFolder& map);

}  // namespace berm
