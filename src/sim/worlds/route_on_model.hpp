#pragma once

#include <cstdint>
#include <vector>

#include "berm/sim/world_config.hpp"
#include "model_ground.hpp"
#include "route_course.hpp"

namespace berm::sim {

/// As lay_course, on an elevation model: begins at (0, 0), follows the slopes so that its gradients stay within the
/// limits, over known ground only as far as `half_width_m` to both sides. Heights are the model's, smoothed.
/// Throws Error(invalid_argument) where there is no such route: the ground is not known, or too steep or too flat.
[[nodiscard]] std::vector<RoutePoint> lay_course_on_model(const RouteConfig& config, const ModelGround& ground,
                                                          double half_width_m, std::uint64_t seed);

}  // namespace berm::sim
