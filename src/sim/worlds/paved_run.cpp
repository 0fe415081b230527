#include <cmath>
#include <numbers>
#include <utility>

#include "run_plans.hpp"
#include "run_widths.hpp"

namespace berm::sim {

Run make_paved(const PavedConfig& config, std::vector<RoutePoint> course, double width_m) {
  for (RoutePoint& p : course) {
    p.left_m = 0.5 * width_m;
    p.right_m = 0.5 * width_m;
  }
  Run run;
  run.cross_fall = constant_profile(course, -std::tan(config.cross_fall_deg * std::numbers::pi / 180.0));
  for (RunSide& side : run.sides) {
    side.shoulder_m = constant_profile(course, 1.0);
  }
  run.route = Route(std::move(course));
  run.finish(6.0);
  return run;
}

}  // namespace berm::sim
