#include "route_on_model.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>
#include <string>

#include "berm/core/angle.hpp"
#include "berm/core/error.hpp"
#include "noise.hpp"

namespace berm::sim {
namespace {

constexpr int kAttempts = 96;
/// The way looks this far ahead at the slope of the ground, over this base.
constexpr double kLookAhead_m = 12.0;
constexpr double kSlopeBase_m = 16.0;
/// The curvature changes from nothing to that of the sharpest bend over this distance.
constexpr double kRamp_m = 14.0;
/// Ground flatter than this leads nowhere.
constexpr double kFlat = 0.02;
/// Graders cut and fill no more than this.
constexpr double kMostCut_m = 4.0;
/// Heights are smoothed along the way, standard deviation.
constexpr double kSmooth_m = 9.0;

double wrapped(double angle_rad) {
  return std::remainder(angle_rad, 2.0 * std::numbers::pi);
}

/// Heading in which the ground rises by `gradient` as nearly as it can, the one nearer to `heading_rad`.
double heading_for(const Eigen::Vector2d& slope, double gradient, double heading_rad) {
  const double steepness = slope.norm();
  if (steepness < kFlat) {
    return heading_rad;
  }
  const double uphill = std::atan2(slope.y(), slope.x());
  const double off = std::acos(std::clamp(gradient / steepness, -1.0, 1.0));
  const double a = heading_rad + wrapped(uphill + off - heading_rad);
  const double b = heading_rad + wrapped(uphill - off - heading_rad);
  return std::abs(a - heading_rad) < std::abs(b - heading_rad) ? a : b;
}

/// Curvatures of a way from the origin: one every step, for `count` steps. `gradients` are what it strives for.
std::vector<double> steer(const RouteConfig& config, const ModelGround& ground, double main_heading_rad,
                          const std::vector<double>& gradients) {
  const double most = 1.0 / config.min_radius_m;
  std::vector<double> curvatures(gradients.size(), 0.0);
  double x = 0.0;
  double y = 0.0;
  double heading = main_heading_rad;
  for (std::size_t i = 1; i < gradients.size(); ++i) {
    const Eigen::Vector2d slope =
        ground.slope(x + kLookAhead_m * std::cos(heading), y + kLookAhead_m * std::sin(heading), kSlopeBase_m);
    const double wanted = std::clamp(heading_for(slope, gradients[i], heading), main_heading_rad - kMaxTurn_rad,
                                     main_heading_rad + kMaxTurn_rad);
    const double curvature = std::clamp((wanted - heading) / kLookAhead_m, -0.98 * most, 0.98 * most);
    const double change = most * kRouteStep_m / kRamp_m;
    curvatures[i] = curvatures[i - 1] + std::clamp(curvature - curvatures[i - 1], -change, change);
    heading += kRouteStep_m * curvatures[i];
    x += kRouteStep_m * std::cos(heading);
    y += kRouteStep_m * std::sin(heading);
  }
  return curvatures;
}

/// How far along the route the ground is known, over the width.
double known_until(const std::vector<RoutePoint>& points, const ModelGround& ground, double half_width_m) {
  double from = 0.0;
  double until = points.back().s_m;
  for (const RoutePoint& p : points) {
    for (const double left : {0.0, half_width_m, -half_width_m}) {
      const double x = p.x_m - left * std::sin(p.heading_rad);
      const double y = p.y_m + left * std::cos(p.heading_rad);
      if (!ground.is_known(x, y)) {
        (p.s_m < 0.0 ? from : until) = p.s_m < 0.0 ? -1.0 : std::min(until, p.s_m);
      }
    }
  }
  // Also what leads to the start has to be there.
  return from < 0.0 ? std::min(until, 0.0) : until;
}

/// Gives the points heights within the limits of the gradient; returns the deepest cut or highest fill.
double lay_heights(const RouteConfig& config, const ModelGround& ground, std::vector<RoutePoint>& points) {
  std::vector<double> natural(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    natural[i] = ground.heights().at(points[i].x_m, points[i].y_m);
  }
  const std::vector<double> smooth = smoothed(natural, kSmooth_m / kRouteStep_m);
  const double low = std::tan(config.min_gradient_deg * kRadPerDeg) * kRouteStep_m;
  const double high = std::tan(config.max_gradient_deg * kRadPerDeg) * kRouteStep_m;
  const auto zero = static_cast<std::size_t>(std::lround(kLead_m / kRouteStep_m));
  std::vector<double> limited(points.size(), smooth[zero]);
  const auto step_towards = [&](std::size_t from, std::size_t to, double least, double most) {
    // What was cut off earlier is made up for where there is room.
    limited[to] = limited[from] + std::clamp(smooth[to] - limited[from], least, most);
  };
  for (std::size_t i = zero; i + 1 < points.size(); ++i) {
    step_towards(i, i + 1, low, high);
  }
  for (std::size_t i = zero; i > 0; --i) {
    step_towards(i, i - 1, -high, -low);
  }
  // Smoothing keeps the gradients within the limits, since it averages them.
  limited = smoothed(limited, 0.5 * kSmooth_m / kRouteStep_m);
  double deepest = 0.0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    points[i].z_m = limited[i];
    deepest = std::max(deepest, std::abs(limited[i] - natural[i]));
  }
  return deepest;
}

std::vector<RoutePoint> try_course(const RouteConfig& config, const ModelGround& ground, std::uint64_t seed,
                                   int attempt) {
  Random random(seed, Purpose::route, 20, static_cast<std::uint64_t>(attempt));
  const double heading = random.uniform(-std::numbers::pi, std::numbers::pi);
  const auto lead = static_cast<std::size_t>(std::lround(kLead_m / kRouteStep_m));
  const auto ahead = static_cast<std::size_t>(std::lround((config.length_m + kLead_m) / kRouteStep_m)) + 1;
  // What it strives for stays off the limits: the ground never does quite as told.
  std::vector<double> gradients =
      smooth_random(ahead, config.gradient_every_m / kRouteStep_m, Random(random.bits(), Purpose::route));
  const double low = std::tan(config.min_gradient_deg * kRadPerDeg);
  const double high = std::tan(config.max_gradient_deg * kRadPerDeg);
  stretch_to(gradients, low + 0.12 * (high - low), high - 0.12 * (high - low));
  const std::vector<double> forwards = steer(config, ground, heading, gradients);
  const std::vector<double> backwards =
      steer(config, ground, heading + std::numbers::pi, std::vector<double>(lead + 1, -gradients[0]));
  std::vector<double> curvatures(lead + ahead);
  for (std::size_t i = 1; i <= lead; ++i) {
    curvatures[lead - i] = -backwards[i];
  }
  std::copy(forwards.begin(), forwards.end(), curvatures.begin() + static_cast<std::ptrdiff_t>(lead));
  return follow_curvatures(curvatures, -kLead_m, heading);
}

}  // namespace

std::vector<RoutePoint> lay_course_on_model(const RouteConfig& config, const ModelGround& ground, double half_width_m,
                                            std::uint64_t seed) {
  std::vector<RoutePoint> best;
  double shallowest = std::numeric_limits<double>::infinity();
  double farthest = -1.0;
  for (int attempt = 0; attempt < kAttempts; ++attempt) {
    std::vector<RoutePoint> points = try_course(config, ground, seed, attempt);
    const double known = known_until(points, ground, half_width_m);
    farthest = std::max(farthest, known);
    if (known < points.back().s_m) {
      continue;
    }
    const double cut = lay_heights(config, ground, points);
    if (cut < shallowest) {
      shallowest = cut;
      best = std::move(points);
    }
    if (shallowest < 0.5 * kMostCut_m) {
      break;
    }
  }
  if (best.empty()) {
    throw Error(ErrorCode::invalid_argument,
                "elevation model: no route of " + std::to_string(config.length_m) + " m (and " +
                    std::to_string(kLead_m) +
                    " m before and behind it) stays where heights are known; the best leaves " + "them at " +
                    std::to_string(farthest) +
                    " m: shorten route.length_m, or begin elsewhere (world.elevation_x, world.elevation_y)");
  }
  if (shallowest > kMostCut_m) {
    throw Error(ErrorCode::invalid_argument,
                "elevation model: no route within the gradients of route.min_gradient_deg " +
                    std::to_string(config.min_gradient_deg) + " and route.max_gradient_deg " +
                    std::to_string(config.max_gradient_deg) + "; the best needs cuts of " + std::to_string(shallowest) +
                    " m where " + std::to_string(kMostCut_m) +
                    " m are allowed: widen the gradients, or begin elsewhere (world.elevation_x, world.elevation_y)");
  }
  return best;
}

}  // namespace berm::sim
