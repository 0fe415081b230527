#include "run_widths.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

#include "route_course.hpp"

namespace berm::sim {
namespace {

constexpr double kFallWave_m = 60.0;
constexpr double kOneSidedWave_m = 90.0;

/// Stretches what lies on the route to the limits and cuts the rest at them.
void stretch_on_route(const std::vector<RoutePoint>& course, std::vector<double>& values, double low, double high) {
  std::vector<double> on_route;
  for (std::size_t i = 0; i < course.size(); ++i) {
    if (course[i].s_m >= 0.0 && course[i].s_m <= course.back().s_m - kLead_m) {
      on_route.push_back(values[i]);
    }
  }
  if (on_route.empty()) {
    on_route = values;
  }
  const auto [least, greatest] = std::minmax_element(on_route.begin(), on_route.end());
  const double range = std::max(*greatest - *least, 1e-9);
  const double from = *least;
  for (double& value : values) {
    value = std::clamp(low + (value - from) / range * (high - low), low, high);
  }
}

}  // namespace

Random random_of(const RunSeed& seed, RunRandom what, std::uint64_t side) {
  return {seed.seed, Purpose::terrain, 100 + static_cast<std::uint64_t>(what), 2 * seed.run + side};
}

void set_widths(std::vector<RoutePoint>& course, double low_m, double high_m, double wave_m, const RunSeed& seed) {
  std::vector<double> widths = smooth_random(course.size(), wave_m / kRouteStep_m, random_of(seed, RunRandom::width));
  stretch_on_route(course, widths, low_m, high_m);
  const std::vector<double> shifts =
      smooth_random(course.size(), kOneSidedWave_m / kRouteStep_m, random_of(seed, RunRandom::one_sidedness));
  for (std::size_t i = 0; i < course.size(); ++i) {
    const double most = kMostOneSided - 0.5;
    const double share = 0.5 + most * std::tanh(shifts[i]);
    course[i].left_m = widths[i] * share;
    course[i].right_m = widths[i] * (1.0 - share);
  }
}

Profile make_cross_fall(const std::vector<RoutePoint>& course, double limit_deg, const RunSeed& seed) {
  std::vector<double> falls =
      smooth_random(course.size(), kFallWave_m / kRouteStep_m, random_of(seed, RunRandom::cross_fall));
  const double limit = std::tan(limit_deg * std::numbers::pi / 180.0);
  stretch_on_route(course, falls, -limit, limit);
  return {course.front().s_m, kRouteStep_m, std::move(falls)};
}

Profile constant_profile(const std::vector<RoutePoint>& course, double value) {
  // Two values are enough: beyond them the last one holds.
  return {course.front().s_m, course.back().s_m - course.front().s_m, {value, value}};
}

}  // namespace berm::sim
