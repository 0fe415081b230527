#include "berm/ground/terrain_ground.hpp"

namespace berm {

TerrainGround::TerrainGround(const TerrainGroundConfig& config) : config_(config) {
  config_.check();
}

GroundResult TerrainGround::process(const PointsView& points, const Pose& /*T_base_sensor*/) {
  classes_.assign(points.size(), GroundClass::not_ground);
  return {.classes = classes_};
}

}  // namespace berm
