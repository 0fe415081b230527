#pragma once

#include "berm/snow/snow.hpp"

namespace berm {

/// Whether a point can be worked with: neither a no-return nor NaN nor absurdly far.
[[nodiscard]] bool is_usable(float x_m, float y_m, float z_m);

/// What `points` lack. Intensity is judged by the returns alone: drivers give beams without one a zero.
[[nodiscard]] SnowLimits find_limits(const PointsView& points);

}  // namespace berm
