#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "berm/sim/build_world.hpp"

namespace berm::sim {

/// Plans that suit each kind of world, short enough for tests.
inline WorldPlan plan_of(const std::string& kind) {
  WorldPlan plan;
  plan.world.kind = kind;
  plan.route.length_m = 300.0;
  if (kind == "haul_road") {
    plan.route.min_gradient_deg = -3.0;
    plan.route.max_gradient_deg = 6.0;
    plan.route.roller_height_m = 0.2;
    plan.things.trees_per_hectare = 0.0;
    plan.things.lift = false;
    plan.things.fence_share = 0.0;
    plan.dust.plumes = 6;
  } else if (kind != "piste") {
    plan.route.min_gradient_deg = -1.0;
    plan.route.max_gradient_deg = 1.0;
    plan.route.min_radius_m = 60.0;
    plan.route.roller_height_m = 0.05;
    plan.world.side_slope_deg = 2.0;
    plan.things.trees_per_hectare = 60.0;
    plan.things.lift = false;
    plan.things.lamp_every_m = 30.0;
    plan.traffic.parked = 30;
  }
  return plan;
}

inline World world_of(const std::string& kind, std::uint64_t seed) {
  return build_world(plan_of(kind), std::nullopt, seed);
}

}  // namespace berm::sim
