#include "berm/ground/polar_ground.hpp"

namespace berm {

PolarGround::PolarGround(const PolarGroundConfig& config) : config_(config) {
  config_.check();
}

GroundResult PolarGround::process(const PointsView& points, const Pose& /*T_base_sensor*/) {
  classes_.assign(points.size(), GroundClass::not_ground);
  return {.classes = classes_};
}

}  // namespace berm
