#include "road_details.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

#include "route_course.hpp"

namespace berm::sim {
namespace {

/// Half of the gauge of a haul truck and of the width of its double tyres.
constexpr double kHalfGauge_m = 2.0;
constexpr double kRutHalfWidth_m = 0.55;
/// Puddles keep away from the edge.
constexpr double kEdgeRoom_m = 1.0;
/// A puddle gathers where the road is flattest among this many places.
constexpr int kPuddleTries = 12;
/// Steeper roads hold no water.
constexpr double kMostPuddleGradient = 0.07;

RoadPatch make_pothole(const Run& road, double length_m, Random& random) {
  const RoutePoint at = road.route.at(random.uniform(0.0, length_m));
  const double left = random.uniform(-0.8 * at.right_m, 0.8 * at.left_m);
  const Eigen::Vector2d place = beside(at, left);
  return {place.x(), place.y(), random.uniform(0.25, 0.8), random.uniform(0.04, 0.13), 0.0, false};
}

bool make_puddle(const Run& road, double length_m, Random& random, RoadPatch& patch) {
  double flattest = std::numeric_limits<double>::infinity();
  double where = 0.0;
  for (int i = 0; i < kPuddleTries; ++i) {
    const double s = random.uniform(0.0, length_m);
    if (std::abs(road.route.gradient(s)) < flattest) {
      flattest = std::abs(road.route.gradient(s));
      where = s;
    }
  }
  const RoutePoint at = road.route.at(where);
  const double left = random.uniform(-0.7 * at.right_m, 0.7 * at.left_m);
  const double radius = random.uniform(0.8, 2.2);
  const Eigen::Vector2d place = beside(at, left);
  const RunPlace run_place = road.place(place.x(), place.y());
  patch = {place.x(), place.y(), 1.4 * radius, 0.0, road.graded_m(run_place) - 0.04, true};
  return flattest < kMostPuddleGradient && run_place.inside_m > 0.5 * radius + kEdgeRoom_m;
}

/// Puddles that touch would have one level.
bool touches_puddle(const std::vector<RoadPatch>& patches, const RoadPatch& puddle) {
  return std::any_of(patches.begin(), patches.end(), [&](const RoadPatch& other) {
    return other.is_puddle &&
           std::hypot(other.x_m - puddle.x_m, other.y_m - puddle.y_m) < other.reach_m + puddle.reach_m;
  });
}

double rut_m(double across_m) {
  const double t = across_m / kRutHalfWidth_m;
  // A groove with slightly raised rims.
  return std::exp(-t * t) - 0.25 * std::exp(-(std::abs(t) - 1.7) * (std::abs(t) - 1.7) * 3.0);
}

}  // namespace

RoadDetails::RoadDetails(const HaulRoadConfig& config, const Run& road, std::uint64_t seed) {
  const std::vector<RoutePoint>& points = road.route.points();
  const double first = points.front().s_m;
  const double length = points.back().s_m - kLead_m;
  Random random(seed, Purpose::terrain, 300);
  std::vector<RoadPatch> patches;
  const auto count_of = [&](int per_km) { return static_cast<int>(std::lround(per_km * length / 1000.0)); };
  patches.reserve(static_cast<std::size_t>(count_of(config.potholes_per_km) + count_of(config.puddles_per_km)));
  for (int i = 0; i < count_of(config.potholes_per_km); ++i) {
    patches.push_back(make_pothole(road, length, random));
  }
  for (int i = 0; i < count_of(config.puddles_per_km); ++i) {
    RoadPatch puddle;
    if (make_puddle(road, length, random, puddle) && !touches_puddle(patches, puddle)) {
      patches.push_back(puddle);
    }
  }
  patches_ = Buckets<RoadPatch>(std::move(patches));
  std::vector<double> depths = smooth_random(points.size(), 15.0 / kRouteStep_m, Random(seed, Purpose::terrain, 301));
  stretch_to(depths, 0.0, config.rut_depth_m);
  rut_depth_m_ = Profile(first, kRouteStep_m, std::move(depths));
  std::vector<double> lanes = smooth_random(points.size(), 25.0 / kRouteStep_m, Random(seed, Purpose::terrain, 302));
  for (std::size_t i = 0; i < lanes.size(); ++i) {
    // Two lanes where there is room for two, else both in the middle.
    const double half = 0.5 * (points[i].left_m + points[i].right_m);
    lanes[i] = 0.25 * std::tanh(lanes[i]) + std::max(0.0, 0.5 * half - kHalfGauge_m + 0.6);
  }
  lane_m_ = Profile(first, kRouteStep_m, smoothed(lanes, 10.0));
}

bool RoadDetails::apply(const RunPlace& at, double x_m, double y_m, double fade, double& height_m) const {
  if (fade <= 0.0 || rut_depth_m_.values().empty()) {
    return false;
  }
  const double depth = rut_depth_m_.at(at.place.s_m);
  const double lane = lane_m_.at(at.place.s_m);
  const double middle = 0.5 * (at.middle.left_m - at.middle.right_m);
  double ruts = 0.0;
  for (const double track : {lane + kHalfGauge_m, lane - kHalfGauge_m, -lane + kHalfGauge_m, -lane - kHalfGauge_m}) {
    const double across = at.place.left_m - middle - track;
    if (std::abs(across) < 4.0 * kRutHalfWidth_m) {
      ruts += rut_m(across);
    }
  }
  height_m -= fade * depth * std::min(ruts, 1.2);
  bool water = false;
  patches_.visit_at(x_m, y_m, [&](const RoadPatch& patch) {
    const double share = std::hypot(x_m - patch.x_m, y_m - patch.y_m) / patch.reach_m;
    if (share >= 1.0) {
      return;
    }
    if (patch.is_puddle) {
      // Flat as far as the water reaches, then up to the road.
      height_m += fade * (1.0 - smooth_step(0.7, 1.0, share)) * (patch.water_level_m - height_m);
      water = water || (share < 0.7 && fade >= 1.0);
    } else {
      const double bowl = (1.0 - share * share);
      height_m -= fade * patch.depth_m * bowl * bowl;
    }
  });
  return water;
}

}  // namespace berm::sim
