#pragma once

#include <cstdint>
#include <optional>

#include "berm/io/height_raster.hpp"
#include "berm/sim/scenario.hpp"
#include "berm/sim/world.hpp"

namespace berm::sim {

/// Builds the world of a scenario. `elevation_m` replaces the procedural terrain; the route is laid where it has data.
/// Throws ConfigError or Error where the route cannot be laid (outside the model, over NODATA, too steep).
[[nodiscard]] World build_world(const Scenario& scenario, const std::optional<HeightRaster>& elevation_m,
                                std::uint64_t seed);

}  // namespace berm::sim
