#include <cmath>
#include <numbers>

#include "run_plans.hpp"
#include "run_widths.hpp"

namespace berm::sim {
namespace {

/// Beyond the berm at least this much of the ground is graded into the natural one.
constexpr double kLeastBlend_m = 1.0;

double tangent(double angle_deg) {
  return std::tan(angle_deg * std::numbers::pi / 180.0);
}

}  // namespace

double greatest_reach_m(const WorldPlan& plan) {
  // A little less than twice the height over the slope: the outer foot of the highest berm may be cut in a bend.
  if (plan.world.kind == "piste") {
    return kMostOneSided * plan.piste.max_width_m + 1.5 * plan.piste.max_bank_m / tangent(plan.piste.bank_slope_deg) +
           kLeastBlend_m;
  }
  if (plan.world.kind == "haul_road") {
    return kMostOneSided * plan.haul_road.max_width_m +
           1.5 * plan.haul_road.max_berm_m / tangent(plan.haul_road.min_repose_deg) + kLeastBlend_m;
  }
  return 0.5 * (plan.world.kind == "car_park" ? plan.paved.park_width_m : plan.paved.road_width_m) + kLeastBlend_m;
}

}  // namespace berm::sim
