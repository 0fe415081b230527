#pragma once

#include <cstdint>
#include <vector>

#include "base_terrain.hpp"
#include "berm/sim/world_config.hpp"
#include "run.hpp"

namespace berm::sim {

/// The rectangle around runs and what lies `margin_m` beyond.
[[nodiscard]] Area area_around(const std::vector<Run>& runs, double margin_m);

/// Procedural ground that the runs lie in as if they had always been there: their heights and gradients, with slopes
/// across that change along the way.
[[nodiscard]] SmoothRaster make_natural_ground(const WorldConfig& config, const std::vector<Run>& runs,
                                               std::uint64_t seed);

/// Half of the width of a run as a surface in the plane, near its edge about that of the nearest place.
[[nodiscard]] SmoothRaster make_width_raster(const Run& run, const Area& area, bool left);

}  // namespace berm::sim
