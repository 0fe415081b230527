#include "natural_ground.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

#include "noise.hpp"
#include "route_course.hpp"

namespace berm::sim {
namespace {

/// Knots of the ground along a run.
constexpr double kKnotEvery_m = 6.0;
constexpr double kSideWave_m = 90.0;
/// Cells of the ground; larger ones where the world is large.
constexpr double kLeastCell_m = 5.0;
constexpr double kMostGroundCells = 50000.0;

double cell_for(const Area& area) {
  return std::max(kLeastCell_m,
                  std::sqrt((area.max_x_m - area.min_x_m) * (area.max_y_m - area.min_y_m) / kMostGroundCells));
}

void add_knots(const Run& run, const std::vector<double>& side_slopes, std::vector<GroundKnot>& knots) {
  const auto every = static_cast<std::size_t>(kKnotEvery_m / kRouteStep_m);
  const std::vector<RoutePoint>& points = run.route.points();
  for (std::size_t i = 0; i < points.size(); i += every) {
    const double gradient = run.route.gradient(points[i].s_m);
    const double c = std::cos(points[i].heading_rad);
    const double s = std::sin(points[i].heading_rad);
    knots.push_back({points[i].x_m, points[i].y_m, points[i].z_m, gradient * c - side_slopes[i] * s,
                     gradient * s + side_slopes[i] * c});
  }
}

}  // namespace

Area area_around(const std::vector<Run>& runs, double margin_m) {
  const RoutePoint& start = runs[0].route.points().front();
  Area area{start.x_m, start.y_m, start.x_m, start.y_m};
  for (const Run& run : runs) {
    for (const RoutePoint& p : run.route.points()) {
      area = {std::min(area.min_x_m, p.x_m), std::min(area.min_y_m, p.y_m), std::max(area.max_x_m, p.x_m),
              std::max(area.max_y_m, p.y_m)};
    }
  }
  return {area.min_x_m - margin_m, area.min_y_m - margin_m, area.max_x_m + margin_m, area.max_y_m + margin_m};
}

SmoothRaster make_natural_ground(const WorldConfig& config, const std::vector<Run>& runs, std::uint64_t seed) {
  std::vector<GroundKnot> knots;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    std::vector<double> slopes =
        smooth_random(runs[i].route.points().size(), kSideWave_m / kRouteStep_m, Random(seed, Purpose::terrain, 10, i));
    const double steepest = std::tan(config.side_slope_deg * std::numbers::pi / 180.0);
    stretch_to(slopes, -steepest, steepest);
    if (i > 0) {
      // A run that branches off takes the slopes of the one that it leaves.
      std::fill(slopes.begin(), slopes.end(), 0.0);
    }
    add_knots(runs[i], slopes, knots);
  }
  const Area area = area_around(runs, config.margin_m);
  return {area, cell_for(area), [&](double x, double y) { return ground_between(knots, x, y); }};
}

SmoothRaster make_width_raster(const Run& run, const Area& area, bool left) {
  std::vector<GroundKnot> knots;
  const auto every = static_cast<std::size_t>(kKnotEvery_m / kRouteStep_m);
  const std::vector<RoutePoint>& points = run.route.points();
  for (std::size_t i = 0; i < points.size(); i += every) {
    knots.push_back({points[i].x_m, points[i].y_m, left ? points[i].left_m : points[i].right_m, 0.0, 0.0});
  }
  return {area, cell_for(area), [&](double x, double y) { return ground_between(knots, x, y); }};
}

}  // namespace berm::sim
