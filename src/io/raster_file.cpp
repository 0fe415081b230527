#include "berm/io/raster_file.hpp"

#include <cmath>
#include <limits>

#include "berm/core/error.hpp"
#include "berm/io/atomic_file.hpp"
#include "berm/io/height_raster.hpp"
#include "raster_geotiff.hpp"
#include "text_numbers.hpp"

namespace berm {
namespace {

namespace fs = std::filesystem;

void write_ascii_band(const fs::path& path, const RasterFrame& frame, const RasterBand& band) {
  AtomicFile file(path);
  std::string text = "ncols " + std::to_string(frame.columns) + "\nnrows " + std::to_string(frame.rows);
  for (const auto& [key, value] : {std::pair("\nxllcorner ", frame.origin_x_m),
                                   {"\nyllcorner ", frame.origin_y_m},
                                   {"\ncellsize ", frame.cell_m}}) {
    text += key;
    append_shortest(text, value);
  }
  file.write(text + "\nNODATA_value -9999\n");
  std::vector<float> values(frame.columns);
  for (std::size_t row = frame.rows; row-- > 0;) {
    values.assign(frame.columns, std::numeric_limits<float>::quiet_NaN());
    band.fill(row, values);
    text.clear();
    for (const float value : values) {
      text += text.empty() ? "" : " ";
      if (std::isnan(value)) {
        text += "-9999";
      } else {
        append_fixed(text, double{value}, band.decimals);
      }
    }
    file.write(text + "\n");
  }
  file.commit();
}

}  // namespace

#ifndef BERM_WITH_GDAL
std::string to_geotiff(const RasterFrame& /*frame*/, std::span<const RasterBand> /*bands*/) {
  throw Error(ErrorCode::unsupported,
              "a GeoTIFF cannot be written, since this program was built without GDAL; install libgdal-dev and build "
              "again");
}
#endif

std::vector<std::string> write_raster(const fs::path& folder, const std::string& stem, const RasterFrame& frame,
                                      std::span<const RasterBand> bands, RasterFormat format) {
  if (bands.empty() || frame.columns == 0 || frame.rows == 0 || frame.columns > kMaxRasterCells / frame.rows) {
    throw Error(ErrorCode::invalid_argument,
                "a raster of " + std::to_string(frame.columns) + " x " + std::to_string(frame.rows) + " cells and " +
                    std::to_string(bands.size()) + " bands cannot be written, expected 1 to " +
                    std::to_string(kMaxRasterCells) + " cells");
  }
#ifdef BERM_WITH_GDAL
  const bool as_tiff = format != RasterFormat::ascii;
#else
  const bool as_tiff = format == RasterFormat::geotiff;
#endif
  std::vector<std::string> names;
  if (as_tiff) {
    names.push_back(stem + ".tif");
    write_file_atomically(folder / names.back(), to_geotiff(frame, bands));
    return names;
  }
  for (const RasterBand& band : bands) {
    names.push_back(names.empty() ? stem + ".asc" : stem + "_" + band.name + ".asc");
    write_ascii_band(folder / names.back(), frame, band);
  }
  return names;
}

}  // namespace berm
