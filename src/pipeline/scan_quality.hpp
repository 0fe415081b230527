#pragma once

#include "berm/core/point_cloud.hpp"
#include "berm/pipeline/scan_result.hpp"
#include "berm/snow/snow.hpp"

namespace berm {

/// What made the scan worse than it should be. Takes counts and verdict from `result`.
[[nodiscard]] Degradations find_degradations(const PointsView& points, const SnowLimits& limits,
                                             const ScanResult& result);

/// Whether neighbours in the list of points are neighbours in the world, possibly by turns of up to 16 lasers. True
/// also if there are too few returns to tell.
[[nodiscard]] bool has_firing_order(const PointsView& points);

}  // namespace berm
