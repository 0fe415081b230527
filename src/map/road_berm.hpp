#pragma once

#include <cstddef>
#include <optional>

#include "berm/core/road.hpp"
#include "road_sightings.hpp"
#include "road_surface_fit.hpp"

namespace berm {

/// Height of the berm whose toe lies `left_m` of the path, above the road at the toe, from what is raised there. None
/// on a wall, and where nothing of it was seen.
[[nodiscard]] std::optional<Measure> measure_berm_height(const RoadSightings& seen, std::size_t place, double left_m,
                                                         const RoadSlopes& slopes);

}  // namespace berm
