#pragma once

#include <cstdint>
#include <memory>

#include "berm/sim/build_world.hpp"
#include "built_terrain.hpp"

namespace berm::sim {

/// The runs of a plan in their terrain. `origin_m` is that of the world in the coordinates of the model.
struct BuiltGround {
  std::shared_ptr<const BuiltTerrain> terrain;
  Area area;
  Eigen::Vector3d origin_m = Eigen::Vector3d::Zero();
};

[[nodiscard]] BuiltGround build_ground(const WorldPlan& plan, const std::optional<HeightRaster>& elevation,
                                       std::uint64_t seed);

}  // namespace berm::sim
