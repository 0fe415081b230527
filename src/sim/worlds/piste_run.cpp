#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include "berm/core/angle.hpp"
#include "route_course.hpp"
#include "run_plans.hpp"
#include "run_widths.hpp"

namespace berm::sim {
namespace {

constexpr double kPisteWidthWave_m = 55.0;
/// Snow that a blade pushes aside lies in a windrow with this top.
constexpr double kLeastTop_m = 0.2;
constexpr double kGreatestTop_m = 0.9;
constexpr double kPisteBlend_m = 9.0;

/// Where `share` of the values lies above.
double quantile_above(std::vector<double> values, double share) {
  std::sort(values.begin(), values.end());
  const double index = (1.0 - share) * static_cast<double>(values.size() - 1);
  return values[static_cast<std::size_t>(index)];
}

std::vector<double> bank_heights(const PisteConfig& config, std::size_t count, Random& random) {
  const std::vector<double> presence =
      smooth_random(count, 22.0 / kRouteStep_m, Random(random.bits(), Purpose::terrain));
  const std::vector<double> slow = smooth_random(count, 12.0 / kRouteStep_m, Random(random.bits(), Purpose::terrain));
  const std::vector<double> fast = smooth_random(count, 2.5 / kRouteStep_m, Random(random.bits(), Purpose::terrain));
  const double threshold = quantile_above(presence, config.bank_share);
  std::vector<double> heights(count);
  for (std::size_t i = 0; i < count; ++i) {
    const double there = config.bank_share >= 1.0   ? 1.0
                         : config.bank_share <= 0.0 ? 0.0
                                                    : smooth_step(threshold - 0.12, threshold + 0.12, presence[i]);
    const double share = std::clamp(0.5 + 0.32 * slow[i] + 0.18 * fast[i], 0.0, 1.0);
    heights[i] = there * (config.min_bank_m + share * (config.max_bank_m - config.min_bank_m));
  }
  return smoothed(heights, 0.8);
}

RunSide make_side(const PisteConfig& config, const std::vector<RoutePoint>& course, const RunSeed& seed,
                  std::uint64_t index) {
  RunSide side;
  Random random = random_of(seed, RunRandom::bank, index);
  const double first = course.front().s_m;
  side.bank_height_m = Profile(first, kRouteStep_m, bank_heights(config, course.size(), random));
  std::vector<double> slopes =
      smooth_random(course.size(), 6.0 / kRouteStep_m, Random(random.bits(), Purpose::terrain));
  for (double& slope : slopes) {
    slope = std::tan((config.bank_slope_deg + 5.0 * std::tanh(slope)) * kRadPerDeg);
  }
  side.bank_slope = Profile(first, kRouteStep_m, std::move(slopes));
  std::vector<double> tops = smooth_random(course.size(), 9.0 / kRouteStep_m, Random(random.bits(), Purpose::terrain));
  stretch_to(tops, kLeastTop_m, kGreatestTop_m);
  side.bank_top_m = Profile(first, kRouteStep_m, std::move(tops));
  const double flanks = 2.0 * config.max_bank_m / std::tan((config.bank_slope_deg - 5.0) * kRadPerDeg);
  side.shoulder_m = constant_profile(course, flanks + kGreatestTop_m);
  return side;
}

}  // namespace

Run make_piste(const PisteConfig& config, std::vector<RoutePoint> course, double width_share, const RunSeed& seed) {
  set_widths(course, width_share * config.min_width_m, width_share * config.max_width_m, kPisteWidthWave_m, seed);
  Run run;
  run.cross_fall = make_cross_fall(course, config.cross_fall_deg, seed);
  run.sides = {make_side(config, course, seed, 0), make_side(config, course, seed, 1)};
  run.route = Route(std::move(course));
  run.finish(kPisteBlend_m);
  return run;
}

}  // namespace berm::sim
