#include "berm/sim/world_config.hpp"

#include <string>
#include <string_view>

#include "run_plans.hpp"

namespace berm::sim {
namespace {

/// A least value may not be above its greatest.
void check_order(std::string_view section, std::string_view key, double least, double greatest) {
  if (least > greatest) {
    check_problem(section, key,
                  "is " + std::to_string(least) + ", above the greatest, which is " + std::to_string(greatest) +
                      ": expected it to be at most that");
  }
}

}  // namespace

void RouteConfig::check() const {
  check_fields(*this, "route");
  check_order("route", "min_gradient_deg", min_gradient_deg, max_gradient_deg);
}

void PisteConfig::check() const {
  check_fields(*this, "piste");
  check_order("piste", "min_width_m", min_width_m, max_width_m);
  check_order("piste", "min_bank_m", min_bank_m, max_bank_m);
}

void HaulRoadConfig::check() const {
  check_fields(*this, "haul_road");
  check_order("haul_road", "min_width_m", min_width_m, max_width_m);
  check_order("haul_road", "min_berm_m", min_berm_m, max_berm_m);
  check_order("haul_road", "min_repose_deg", min_repose_deg, max_repose_deg);
}

void WorldPlan::check() const {
  world.check();
  route.check();
  piste.check();
  haul_road.check();
  paved.check();
  things.check();
  traffic.check();
  dust.check();
  const double needed = greatest_reach_m(*this);
  if (route.min_radius_m < needed) {
    check_problem("route", "min_radius_m",
                  "is " + std::to_string(route.min_radius_m) + ", but half of the width and the berm need bends of " +
                      std::to_string(needed) + " m: widen the bends, or narrow the " + world.kind);
  }
}

}  // namespace berm::sim
