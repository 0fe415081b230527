#pragma once

#include <optional>
#include <span>
#include <vector>

#include "berm/core/road.hpp"
#include "road_crossings.hpp"
#include "road_sightings.hpp"

namespace berm {

/// The surface of the road at a place.
struct RoadSlopes {
  std::optional<Measure> grade;
  std::optional<Measure> cross_fall;
};

/// Slopes at every place. `crossings`: of every place; the road lies between them. `slope_floor`: no sigma is smaller.
[[nodiscard]] std::vector<RoadSlopes> measure_slopes(const RoadSightings& seen,
                                                     std::span<const RoadCrossings> crossings, double slope_floor);

}  // namespace berm
