#pragma once

#include <Eigen/Core>
#include <nlohmann/json_fwd.hpp>

#include "berm/io/height_raster.hpp"

namespace berm {

/// The ground as a picture that is lit from the north-west: `shade` has a byte for each cell in base64, row by row, the
/// northern first; 0: not known, else 1 (dark) to 255. Cells are joined until there are at most about 100,000; `x_m`
/// and `y_m` are the south-western corner, `low_m` and `high_m` the heights, all relative to `origin_m`. Null if the
/// raster knows no height.
[[nodiscard]] nlohmann::ordered_json terrain_part(const HeightRaster& raster, const Eigen::Vector3d& origin_m);

}  // namespace berm
