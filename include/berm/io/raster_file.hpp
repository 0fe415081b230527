#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "berm/io/datum.hpp"

namespace berm {

/// Where a raster lies: square cells, rows from south to north.
struct RasterFrame {
  double origin_x_m = 0.0;  ///< lower left corner of the lower left cell
  double origin_y_m = 0.0;
  double cell_m = 1.0;
  std::size_t columns = 0;
  std::size_t rows = 0;
  std::optional<Geodetic> datum;  ///< of the world frame that the raster lies in, where it is known
};

/// One value per cell, made a row at a time.
struct RasterBand {
  std::string name;  ///< "height"
  std::string unit;  ///< "m"
  int decimals = 3;  ///< in text
  /// Fills the values of a row, all NaN before; NaN: not known.
  std::function<void(std::size_t row, std::span<float> values)> fill;
};

enum class RasterFormat : std::uint8_t {
  best,     ///< GeoTIFF if this program was built with GDAL, else ESRI ASCII grids
  geotiff,  ///< one file, a band each; with a datum as an azimuthal equidistant map around it
  ascii,    ///< a file per band: STEM.asc for the first, STEM_NAME.asc for the others
};

/// Writes bands to FOLDER/STEM.tif or .asc and returns the names of the files, that of the first band first. NODATA is
/// -9999. A GeoTIFF is made in memory, compressed. Throws Error(invalid_argument) without bands or cells, or for more
/// than `kMaxRasterCells`; FileError(write_failed) as AtomicFile; FileError(unsupported) for a GeoTIFF without GDAL.
std::vector<std::string> write_raster(const std::filesystem::path& folder, const std::string& stem,
                                      const RasterFrame& frame, std::span<const RasterBand> bands,
                                      RasterFormat format = RasterFormat::best);

}  // namespace berm
