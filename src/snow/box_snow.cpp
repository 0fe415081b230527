#include "berm/snow/box_snow.hpp"

namespace berm {

BoxSnow::BoxSnow(const BoxSnowConfig& config) : config_(config) {
  config_.check();
}

SnowResult BoxSnow::process(const PointsView& points, const Pose& /*T_base_sensor*/) {
  falling_.assign(points.size(), 0);
  return {.falling = falling_, .count = 0, .limits = {}};
}

}  // namespace berm
