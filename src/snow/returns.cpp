#include "returns.hpp"

#include <cmath>
#include <limits>

#include "berm/core/multiversion.hpp"

namespace berm {
namespace {

/// Without branches, so that the compiler can look at several points at once.
BERM_MULTIVERSION bool has_no_return(const PointsView& points) {
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  int found = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const float x = std::fabs(points.x[i]);
    const float y = std::fabs(points.y[i]);
    const float z = std::fabs(points.z[i]);
    const int zero = (x == 0.0F) & (y == 0.0F) & (z == 0.0F);
    const int infinite = (x == kInfinity) | (y == kInfinity) | (z == kInfinity);
    found |= zero | infinite;
  }
  return found != 0;
}

bool has_point(const PointsView& points) {
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (is_usable(points.x[i], points.y[i], points.z[i])) {
      return true;
    }
  }
  return false;
}

bool has_two_intensities(const PointsView& points) {
  float first = std::nanf("");
  for (std::size_t i = 0; i < points.intensity.size(); ++i) {
    const float intensity = points.intensity[i];
    if (std::isfinite(intensity) && is_usable(points.x[i], points.y[i], points.z[i])) {
      if (std::isnan(first)) {
        first = intensity;
      } else if (intensity != first) {
        return true;
      }
    }
  }
  return false;
}

}  // namespace

SnowLimits find_limits(const PointsView& points) {
  return {.no_intensity = !has_two_intensities(points),
          .no_returns_dropped = !points.empty() && !has_no_return(points),
          .no_points = !has_point(points)};
}

}  // namespace berm
