#pragma once

#include <span>
#include <vector>

#include "berm/core/road.hpp"
#include "road_crossings.hpp"
#include "road_sightings.hpp"
#include "road_surface_fit.hpp"

namespace berm {

/// Edge and berm on one side of a place, without verdicts. `crossings`: of every place; `slopes`: of this one.
[[nodiscard]] RoadSide measure_side(const RoadSightings& seen, std::span<const RoadCrossings> crossings,
                                    std::size_t place, EdgeSide side, const RoadSlopes& slopes);

}  // namespace berm
