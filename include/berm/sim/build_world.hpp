#pragma once

#include <cstdint>
#include <optional>

#include "berm/io/height_raster.hpp"
#include "berm/sim/world.hpp"
#include "berm/sim/world_config.hpp"

namespace berm::sim {

/// Builds a world. `elevation` replaces the procedural terrain; the route is laid where it has data, within the limits
/// of `plan.route`. The same plan and seed give the same world, to the last bit.
/// Throws ConfigError for values outside of their ranges or that contradict each other; Error(invalid_argument) where
/// the route cannot be laid on the model (nothing known there, too short, too steep), or its coordinates are not
/// finite.
[[nodiscard]] World build_world(const WorldPlan& plan, const std::optional<HeightRaster>& elevation,
                                std::uint64_t seed);

}  // namespace berm::sim
