#pragma once

#include <span>
#include <string>

#include "berm/io/raster_file.hpp"

namespace berm {

/// The bytes of a GeoTIFF, see `write_raster`.
[[nodiscard]] std::string to_geotiff(const RasterFrame& frame, std::span<const RasterBand> bands);

}  // namespace berm
