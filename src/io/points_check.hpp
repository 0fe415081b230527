#pragma once

#include "berm/core/point_cloud.hpp"

namespace berm {

/// Throws Error(invalid_argument) unless every channel of `points` has length 0 or `points.size()`, x, y, z the latter.
void check_channels(const PointsView& points);

}  // namespace berm
