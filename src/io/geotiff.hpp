#pragma once

#include <filesystem>
#include <string_view>

#include "berm/io/height_raster.hpp"

namespace berm {

/// Whether a file that starts with `head` is a TIFF.
[[nodiscard]] bool is_tiff(std::string_view head);

/// Reads a GeoTIFF, see `read_height_raster`.
[[nodiscard]] HeightRaster read_geotiff(const std::filesystem::path& path);

}  // namespace berm
