#pragma once

#include <cmath>

#include "berm/snow/snow.hpp"

namespace berm {

/// Whether a point can be worked with: neither a no-return nor NaN nor absurdly far (no sensor sees 10 km; coordinates
/// beyond are noise of a broken file). Without branches, so that loops over it can be vectorised.
[[nodiscard]] inline bool is_usable(float x_m, float y_m, float z_m) {
  constexpr float kAbsurd_m = 1e4F;
  const float x = std::fabs(x_m);
  const float y = std::fabs(y_m);
  const float z = std::fabs(z_m);
  const int sane = (x < kAbsurd_m) & (y < kAbsurd_m) & (z < kAbsurd_m);
  const int somewhere = (x > 0.0F) | (y > 0.0F) | (z > 0.0F);
  return (sane & somewhere) != 0;
}

/// What `points` lack. Intensity is judged by the returns alone: drivers give beams without one a zero.
[[nodiscard]] SnowLimits find_limits(const PointsView& points);

}  // namespace berm
