#include "raster_check.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "berm/core/error.hpp"

namespace berm {
namespace {

/// Below: the cells are degrees (30 m are 0.00028). Above: no terrain to drive on is left.
constexpr double kMinCell_m = 0.01;
constexpr double kMaxCell_m = 10'000.0;

}  // namespace

void check_raster_size(const std::string& name, std::uint64_t columns, std::uint64_t rows) {
  if (columns < 2 || rows < 2) {
    throw FileError(ErrorCode::malformed, name, std::nullopt,
                    fmt::format("{} x {} cells are no terrain, expected at least 2 x 2", columns, rows));
  }
  if (columns > kMaxRasterCells / rows) {
    throw FileError(ErrorCode::unsupported, name, std::nullopt,
                    fmt::format("{} x {} cells are more than the {} that are read; cut a part out with gdal_translate "
                                "-projwin, or coarsen it with gdalwarp -tr",
                                columns, rows, kMaxRasterCells));
  }
}

void check_cell_size(const std::string& name, double cell_m) {
  if (!(cell_m >= kMinCell_m && cell_m <= kMaxCell_m)) {
    throw FileError(ErrorCode::unsupported, name, std::nullopt,
                    fmt::format("cells of {} are no metres, expected {} to {}; if they are degrees, reproject the "
                                "model with gdalwarp -t_srs EPSG:326ZZ (UTM zone ZZ)",
                                cell_m, kMinCell_m, kMaxCell_m));
  }
}

void check_has_heights(const std::string& name, const HeightRaster& raster) {
  const auto known = [](float height_m) { return !std::isnan(height_m); };
  if (std::none_of(raster.heights_m.begin(), raster.heights_m.end(), known)) {
    throw FileError(ErrorCode::malformed, name, std::nullopt,
                    fmt::format("holds no height: all of its {} x {} cells are NODATA", raster.columns, raster.rows));
  }
}

}  // namespace berm
