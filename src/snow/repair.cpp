#include "berm/snow/repair.hpp"

namespace berm {

SeriesView SeriesRepair::process(const PointsView& points, std::span<const std::uint8_t> falling) {
  x_.assign(points.x.begin(), points.x.end());
  y_.assign(points.y.begin(), points.y.end());
  z_.assign(points.z.begin(), points.z.end());
  interpolated_.assign(falling.begin(), falling.end());
  return {.x = x_, .y = y_, .z = z_, .interpolated = interpolated_};
}

}  // namespace berm
