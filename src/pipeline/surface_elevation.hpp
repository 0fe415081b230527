#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "berm/io/datum.hpp"
#include "berm/io/surface_folder.hpp"
#include "berm/io/terrain_model.hpp"
#include "berm/map/surface_tiles.hpp"

namespace berm {

/// The elevation raster of a run.
struct ElevationFigures {
  std::vector<std::string> files;
  std::uint64_t cells = 0;        ///< with ground
  std::uint64_t depth_cells = 0;  ///< with ground above a known terrain
  std::optional<double> median_depth_m;
};

/// Writes FOLDER/elevation.tif or .asc from the map: height, slope, sigma, count, and snow depth over `terrain`. None,
/// with the reason in `problem`, for a map without ground or one that is too wide for a raster.
[[nodiscard]] std::optional<ElevationFigures> write_elevation(const std::filesystem::path& folder,
                                                              const SurfaceFolder& map, double cell_m,
                                                              const std::optional<Geodetic>& datum,
                                                              const TerrainModel* terrain, std::string& problem);

}  // namespace berm
