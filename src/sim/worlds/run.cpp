#include "run.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace berm::sim {
namespace {

/// Share of the radius of a bend up to which a run reaches on its inner side: at the centre the nearest place of the
/// line jumps.
constexpr double kShareOfRadius = 0.92;
/// Over which a berm ends before the reach of its run does.
constexpr double kBermFade_m = 1.2;
/// The same at the ends of a run.
constexpr double kEndFade_m = 4.0;

double edge_of(const RoutePoint& p, std::size_t side) {
  return side == 0 ? p.left_m : p.right_m;
}

/// Greatest curvature towards a side around every point.
std::vector<double> inner_curvatures(const std::vector<RoutePoint>& points, std::size_t side) {
  const double sign = side == 0 ? 1.0 : -1.0;
  std::vector<double> curvatures(points.size(), 0.0);
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    const double turn = points[i + 1].heading_rad - points[i].heading_rad;
    curvatures[i] = std::max(0.0, sign * turn / (points[i + 1].s_m - points[i].s_m));
  }
  // Within about a bend's width along the line, so that the reach changes slowly.
  constexpr int kAround = 40;
  const int last = static_cast<int>(points.size()) - 1;
  std::vector<double> greatest(points.size());
  for (int i = 0; i <= last; ++i) {
    double most = 0.0;
    for (int k = std::max(0, i - kAround); k <= std::min(last, i + kAround); ++k) {
      most = std::max(most, curvatures[static_cast<std::size_t>(k)]);
    }
    greatest[static_cast<std::size_t>(i)] = most;
  }
  return greatest;
}

double bank_m(const RunSide& side, double s_m, double beyond_edge_m) {
  if (side.bank_height_m.values().empty()) {
    return 0.0;
  }
  const double height = side.bank_height_m.at(s_m);
  if (height <= 0.01) {
    return 0.0;
  }
  const double slope = side.bank_slope.at(s_m);
  const double base = 2.0 * height / slope + side.bank_top_m.at(s_m);
  if (beyond_edge_m >= base) {
    return 0.0;
  }
  const double flanks = slope * std::min(beyond_edge_m, base - beyond_edge_m);
  return std::max(0.0, smooth_min(flanks, height, 0.35 * height));
}

}  // namespace

Eigen::Vector2d beside(const RoutePoint& at, double left_m) {
  return {at.x_m - left_m * std::sin(at.heading_rad), at.y_m + left_m * std::cos(at.heading_rad)};
}

bool Run::reaches(double x_m, double y_m) const {
  return x_m >= box.min_x_m && x_m <= box.max_x_m && y_m >= box.min_y_m && y_m <= box.max_y_m;
}

RunPlace Run::place(double x_m, double y_m) const {
  RunPlace result;
  result.place = route.nearest(x_m, y_m);
  const double s = result.place.s_m;
  const double left = result.place.left_m;
  result.middle = route.at(s);
  const double to_left = (result.middle.left_m - left) * sides[0].stretch.at(s);
  const double to_right = (result.middle.right_m + left) * sides[1].stretch.at(s);
  result.side = to_left < to_right ? 0 : 1;
  const double across = std::min(to_left, to_right);
  const double first = route.points().front().s_m;
  const double last = route.points().back().s_m;
  const double along = std::min(s - first, last - s) - result.place.beyond_m;
  result.inside_m = across < 0.0 && along < 0.0 ? -std::hypot(across, along) : std::min(across, along);
  result.inside_m = std::max(result.inside_m, -kFarOutside_m);

  const RunSide& side = sides[result.side];
  const double reach = side.reach_m.at(s);
  const double graded = edge_of(result.middle, result.side) + side.shoulder_m.at(s);
  // Beyond the ends as beyond the edges.
  const double distance = std::max(std::abs(left), edge_of(result.middle, result.side) + result.place.beyond_m);
  result.influence = 1.0 - smooth_step(std::min(graded, reach - 0.5), reach, distance);
  return result;
}

double Run::graded_m(const RunPlace& at) const {
  return at.middle.z_m + cross_fall.at(at.place.s_m) * at.place.left_m;
}

double Run::berm_m(const RunPlace& at, double x_m, double y_m) const {
  if (at.inside_m >= 0.0 || at.influence <= 0.0 || at.place.beyond_m > 0.0) {
    return 0.0;
  }
  const double first = route.points().front().s_m;
  const double last = route.points().back().s_m;
  const double to_end = std::min(at.place.s_m - first, last - at.place.s_m);
  const double beyond_edge = -at.inside_m;
  double height = bank_m(sides[at.side], at.place.s_m, beyond_edge);
  heaps.visit_at(x_m, y_m, [&](const Heap& heap) {
    const double distance = std::hypot(x_m - heap.x_m, y_m - heap.y_m);
    // The peak of a heap is blunt.
    const double blunt = 0.12 * heap.height_m;
    height = std::max(height, smooth_min(heap.slope * (heap.reach_m - distance), heap.height_m, 2.0 * blunt));
  });
  // Stones roll as far as the edge, not onto the road.
  height = std::min(height, beyond_edge);
  const double reach = sides[at.side].reach_m.at(at.place.s_m);
  return height * smooth_step(0.0, kEndFade_m, to_end) *
         (1.0 - smooth_step(reach - kBermFade_m, reach, std::abs(at.place.left_m)));
}

void Run::finish(double blend_m) {
  const std::vector<RoutePoint>& points = route.points();
  const double first = points.front().s_m;
  const double step = points[1].s_m - first;
  double widest = 0.0;
  for (std::size_t side = 0; side < 2; ++side) {
    const std::vector<double> curvatures = inner_curvatures(points, side);
    std::vector<double> reach(points.size());
    std::vector<double> stretch(points.size());
    for (std::size_t i = 0; i < points.size(); ++i) {
      const double wanted = edge_of(points[i], side) + sides[side].shoulder_m.at(points[i].s_m) + blend_m;
      reach[i] = std::min(wanted, curvatures[i] > 0.0 ? kShareOfRadius / curvatures[i] : wanted);
      widest = std::max(widest, wanted);
      const std::size_t before = i == 0 ? 0 : i - 1;
      const std::size_t after = std::min(i + 1, points.size() - 1);
      const double slope =
          (edge_of(points[after], side) - edge_of(points[before], side)) / (points[after].s_m - points[before].s_m);
      stretch[i] = 1.0 / std::sqrt(1.0 + slope * slope);
    }
    sides[side].reach_m = Profile(first, step, smoothed(reach, 8.0));
    sides[side].stretch = Profile(first, step, smoothed(stretch, 2.0));
  }
  box = {points[0].x_m, points[0].y_m, points[0].x_m, points[0].y_m};
  for (const RoutePoint& p : points) {
    box = {std::min(box.min_x_m, p.x_m), std::min(box.min_y_m, p.y_m), std::max(box.max_x_m, p.x_m),
           std::max(box.max_y_m, p.y_m)};
  }
  const double around = widest + kFarOutside_m;
  box = {box.min_x_m - around, box.min_y_m - around, box.max_x_m + around, box.max_y_m + around};
}

}  // namespace berm::sim
