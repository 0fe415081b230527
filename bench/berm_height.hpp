#pragma once

#include <optional>

#include <Eigen/Core>

#include "berm/io/height_raster.hpp"

namespace berm::bench {

/// Height of the ground between the middles of cells; NaN outside.
[[nodiscard]] double height_at(const HeightRaster& terrain, const Eigen::Vector2d& p);

/// Height of the berm across a true edge, above its toe: up to where it falls again by a tenth of a metre; none on a
/// wall. `along` is a unit vector.
[[nodiscard]] std::optional<double> true_berm_height_m(const HeightRaster& terrain, const Eigen::Vector2d& toe_m,
                                                       const Eigen::Vector2d& along);

}  // namespace berm::bench
