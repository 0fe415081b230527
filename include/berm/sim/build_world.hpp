#pragma once

#include <cstdint>
#include <functional>
#include <optional>

#include "berm/sim/world.hpp"
#include "berm/sim/world_config.hpp"

namespace berm::sim {

/// An elevation model as the builder sees it.
struct ElevationModel {
  Area area;          ///< in the coordinates of the model
  double cell_m = 0;  ///< distance of its samples
  /// Height at a place of the area; none where the model has no data.
  std::function<std::optional<double>(double x_m, double y_m)> height_m;
};

/// Builds a world. `elevation` replaces the procedural terrain; the route is laid where it has data, within the limits
/// of `plan.route`. The same plan and seed give the same world, to the last bit.
/// Throws ConfigError or Error where the route cannot be laid (outside the model, over NODATA, too steep).
[[nodiscard]] World build_world(const WorldPlan& plan, const std::optional<ElevationModel>& elevation,
                                std::uint64_t seed);

}  // namespace berm::sim
