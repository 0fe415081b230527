#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace berm {

/// An elevation model on square cells: heights at the middles of the cells.
struct HeightRaster {
  double origin_x_m = 0.0;  ///< lower left corner of the lower left cell, in the coordinates of the model
  double origin_y_m = 0.0;
  double cell_m = 1.0;
  std::size_t columns = 0;       ///< to the east
  std::size_t rows = 0;          ///< to the north
  std::vector<float> heights_m;  ///< row by row, the southern first; NaN: not known (NODATA)
  std::string crs;               ///< the coordinate system as WKT, where it is known

  [[nodiscard]] float at(std::size_t column, std::size_t row) const { return heights_m[row * columns + column]; }
};

/// Models of more cells are refused: 400 MB of heights, a square of 10 km at 1 m.
constexpr std::size_t kMaxRasterCells = 100'000'000;

/// Reads an elevation model: GeoTIFF by its first bytes, ESRI ASCII grid otherwise. Throws FileError: as `read_file`;
/// malformed or truncated where the file contradicts itself, holds no height at all, or one beyond +-100 km;
/// unsupported where it has more than `kMaxRasterCells`, cells that are not square, degrees in place of metres, and for
/// every GeoTIFF if this program was built without GDAL.
[[nodiscard]] HeightRaster read_height_raster(const std::filesystem::path& path);

/// Reads an ESRI ASCII grid from memory; `name` stands for the file in errors, which name line and byte.
[[nodiscard]] HeightRaster parse_ascii_grid(std::string_view text, const std::string& name);

/// Writes an ESRI ASCII grid with heights in millimetres and NODATA_value -9999; `crs`, where there is one, goes beside
/// it into NAME.prj. Throws Error(invalid_argument) unless there are columns x rows > 0 heights;
/// FileError(write_failed) as AtomicFile.
void write_ascii_grid(const std::filesystem::path& path, const HeightRaster& raster);

}  // namespace berm
