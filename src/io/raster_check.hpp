#pragma once

#include <cstdint>
#include <string>

#include "berm/io/height_raster.hpp"

namespace berm {

/// Beyond this no number is a height: nothing on Earth is a tenth as high or as deep.
constexpr double kMaxHeight_m = 1e5;

/// Throws FileError unless a model of these counts and cells can be taken. Nothing may be allocated before.
void check_raster_size(const std::string& name, std::uint64_t columns, std::uint64_t rows);
void check_cell_size(const std::string& name, double cell_m);

/// Throws FileError if `raster` holds no height at all.
void check_has_heights(const std::string& name, const HeightRaster& raster);

}  // namespace berm
