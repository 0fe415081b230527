#include "route_course.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

#include "berm/core/angle.hpp"
#include "noise.hpp"

namespace berm::sim {
namespace {

std::size_t index_of(double s_m) {
  return static_cast<std::size_t>(std::lround((s_m + kLead_m) / kRouteStep_m));
}

/// Adds a bend that begins at `s_m`: curvature rises over a ramp, stays, falls again. Returns its length.
double add_bend(std::vector<double>& curvatures, double s_m, double turn_rad, double radius_m) {
  const double arc = std::abs(turn_rad) * radius_m;
  const double ramp = std::min(12.0, arc);
  // Turn = curvature * (flat + ramp).
  const double flat = arc - ramp;
  const double curvature = turn_rad / arc;
  const double length = flat + 2.0 * ramp;
  for (std::size_t i = index_of(s_m); i < curvatures.size(); ++i) {
    const double along = static_cast<double>(i) * kRouteStep_m - kLead_m - s_m;
    if (along > length) {
      break;
    }
    curvatures[i] += curvature * std::clamp(std::min(along, length - along) / ramp, 0.0, 1.0);
  }
  return length;
}

std::vector<double> random_curvatures(const RouteConfig& config, std::uint64_t seed, double& heading_rad) {
  Random random(seed, Purpose::route, 0);
  const double main_rad = random.uniform(-std::numbers::pi, std::numbers::pi);
  double off_rad = random.uniform(-0.3, 0.3);
  heading_rad = main_rad + off_rad;
  std::vector<double> curvatures(index_of(config.length_m + kLead_m) + 1, 0.0);
  double s = config.bend_every_m * random.uniform(0.15, 0.5);
  for (int bend = 0; s < config.length_m; ++bend) {
    const double side = off_rad > 0.0 ? -1.0 : 1.0;
    const bool sharpest = bend == 1;
    double turn = side * config.bend_deg * kRadPerDeg * (sharpest ? 1.0 : random.uniform(0.25, 0.9));
    turn = std::clamp(turn, -kMaxTurn_rad - off_rad, kMaxTurn_rad - off_rad);
    const double radius = config.min_radius_m * (sharpest ? 1.0 : random.uniform(1.1, 3.0));
    if (std::abs(turn) > 0.01) {
      s += add_bend(curvatures, s, turn, radius);
      off_rad += turn;
    }
    s += config.bend_every_m * (0.2 + 0.8 * random.exponential());
  }
  return curvatures;
}

}  // namespace

std::vector<RoutePoint> follow_curvatures(const std::vector<double>& curvatures_per_m, double first_s_m,
                                          double heading_rad) {
  const auto zero = static_cast<std::size_t>(std::lround(-first_s_m / kRouteStep_m));
  std::vector<RoutePoint> points(curvatures_per_m.size());
  points[zero].heading_rad = heading_rad;
  const auto step = [&](std::size_t from, std::size_t to, double sign) {
    const double turn = 0.5 * kRouteStep_m * (curvatures_per_m[from] + curvatures_per_m[to]);
    points[to].heading_rad = points[from].heading_rad + sign * turn;
    const double middle = 0.5 * (points[from].heading_rad + points[to].heading_rad);
    points[to].x_m = points[from].x_m + sign * kRouteStep_m * std::cos(middle);
    points[to].y_m = points[from].y_m + sign * kRouteStep_m * std::sin(middle);
  };
  for (std::size_t i = zero; i + 1 < points.size(); ++i) {
    step(i, i + 1, 1.0);
  }
  for (std::size_t i = zero; i > 0; --i) {
    step(i, i - 1, -1.0);
  }
  for (std::size_t i = 0; i < points.size(); ++i) {
    points[i].s_m = (static_cast<double>(i) - static_cast<double>(zero)) * kRouteStep_m;
  }
  return points;
}

std::vector<double> make_gradients(const RouteConfig& config, std::size_t count, std::uint64_t seed) {
  const double low = std::tan(config.min_gradient_deg * kRadPerDeg);
  const double high = std::tan(config.max_gradient_deg * kRadPerDeg);
  // The limits are to be reached on the route itself and not on what leads to it.
  const std::size_t lead = index_of(0.0);
  const std::size_t on_route = count - 2 * lead;
  std::vector<double> base =
      smooth_random(on_route, config.gradient_every_m / kRouteStep_m, Random(seed, Purpose::route, 1));
  stretch_to(base, low, high);
  std::vector<double> rollers =
      smooth_random(on_route + 1, 0.5 * config.roller_every_m / kRouteStep_m, Random(seed, Purpose::route, 2));
  std::vector<double> gradients(count);
  for (std::size_t i = 0; i < on_route; ++i) {
    // 0.35: from bottom to top of neighbouring bumps is about 2.9 standard deviations.
    const double roller = 0.35 * config.roller_height_m * (rollers[i + 1] - rollers[i]) / kRouteStep_m;
    // Where the base is at a limit the rollers fade, so that the sum stays within.
    const double room = std::min(base[i] - low, high - base[i]);
    gradients[lead + i] = base[i] + roller * room / (room + std::abs(roller) + 1e-9);
  }
  std::fill(gradients.begin(), gradients.begin() + static_cast<std::ptrdiff_t>(lead), gradients[lead]);
  std::fill(gradients.end() - static_cast<std::ptrdiff_t>(lead), gradients.end(), gradients[lead + on_route - 1]);
  return gradients;
}

std::vector<RoutePoint> lay_course(const RouteConfig& config, std::uint64_t seed) {
  double heading_rad = 0.0;
  const std::vector<double> curvatures = random_curvatures(config, seed, heading_rad);
  std::vector<RoutePoint> points = follow_curvatures(curvatures, -kLead_m, heading_rad);
  const std::vector<double> gradients = make_gradients(config, points.size(), seed);
  const std::size_t zero = index_of(0.0);
  for (std::size_t i = zero; i + 1 < points.size(); ++i) {
    points[i + 1].z_m = points[i].z_m + 0.5 * kRouteStep_m * (gradients[i] + gradients[i + 1]);
  }
  for (std::size_t i = zero; i > 0; --i) {
    points[i - 1].z_m = points[i].z_m - 0.5 * kRouteStep_m * (gradients[i] + gradients[i - 1]);
  }
  return points;
}

std::vector<RoutePoint> lay_fork(const RoutePoint& start, double side, double turn_rad, double radius_m,
                                 double length_m) {
  std::vector<double> curvatures(static_cast<std::size_t>(length_m / kRouteStep_m) + 1, 0.0);
  // add_bend counts from -kLead_m.
  add_bend(curvatures, -kLead_m + 2.0, side * turn_rad, radius_m);
  std::vector<RoutePoint> points = follow_curvatures(curvatures, 0.0, start.heading_rad);
  for (RoutePoint& p : points) {
    p.x_m += start.x_m;
    p.y_m += start.y_m;
  }
  return points;
}

}  // namespace berm::sim
