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

constexpr double kWidthWave_m = 45.0;
/// Heaps stand this far apart, as a share of the radius of their foot: overlapping, as trucks dump them side by side.
constexpr double kLeastSpacing = 0.55;
constexpr double kGreatestSpacing = 0.95;
/// Between heaps the toe recedes; the edge follows it this far.
constexpr double kMostRecede_m = 0.3;
constexpr double kBlend_m = 5.0;
/// A road that leaves into the drop or the wall lies on a fill or in a cut with slopes that stand.
constexpr double kForkBlend_m = 22.0;

/// A heap by its place along the run and beyond its edge.
struct RowHeap {
  double s_m;
  double beyond_m;
  double radius_m;
  double height_m;
  double slope;
};

/// Lengths along the run where no heap was dumped, in order.
std::vector<std::array<double, 2>> make_gaps(const HaulRoadConfig& config, const std::vector<RoutePoint>& course,
                                             Random random) {
  std::vector<std::array<double, 2>> gaps;
  if (config.gap_every_m <= 0.0) {
    return gaps;
  }
  double s = course.front().s_m + config.gap_every_m * random.exponential();
  while (s < course.back().s_m) {
    const double width = config.gap_m * random.uniform(0.6, 1.4);
    gaps.push_back({s, s + width});
    s += width + config.gap_every_m * (0.2 + 0.8 * random.exponential());
  }
  return gaps;
}

bool in_gap(const std::vector<std::array<double, 2>>& gaps, const RowHeap& heap) {
  return std::any_of(gaps.begin(), gaps.end(), [&](const std::array<double, 2>& gap) {
    return heap.s_m + heap.radius_m > gap[0] && heap.s_m - heap.radius_m < gap[1];
  });
}

std::vector<RowHeap> dump_row(const HaulRoadConfig& config, const std::vector<RoutePoint>& course, const RunSeed& seed,
                              std::uint64_t side) {
  const auto gaps = make_gaps(config, course, random_of(seed, RunRandom::gaps, side));
  Random random = random_of(seed, RunRandom::heaps, side);
  const std::vector<double> slow =
      smooth_random(course.size(), 30.0 / kRouteStep_m, random_of(seed, RunRandom::bank, side));
  std::vector<RowHeap> row;
  double s = course.front().s_m;
  while (s < course.back().s_m) {
    const auto i = static_cast<std::size_t>((s - course.front().s_m) / kRouteStep_m);
    const double share = std::clamp(0.5 + 0.25 * slow[i] + random.uniform(-0.3, 0.3), 0.0, 1.0);
    RowHeap heap{};
    heap.height_m = config.min_berm_m + share * (config.max_berm_m - config.min_berm_m);
    heap.slope = std::tan(random.uniform(config.min_repose_deg, config.max_repose_deg) * kRadPerDeg);
    heap.radius_m = heap.height_m / heap.slope;
    heap.s_m = s;
    heap.beyond_m = heap.radius_m + random.uniform(0.0, 0.15);
    if (!in_gap(gaps, heap)) {
      row.push_back(heap);
    }
    s += heap.radius_m * random.uniform(kLeastSpacing, kGreatestSpacing);
  }
  return row;
}

/// How far the toe of the row lies beyond the line that it was dumped along.
std::vector<double> recede_of(const std::vector<RowHeap>& row, const std::vector<RoutePoint>& course) {
  std::vector<double> recede(course.size(), kMostRecede_m);
  for (const RowHeap& heap : row) {
    const double from = (heap.s_m - heap.radius_m - course.front().s_m) / kRouteStep_m;
    const double to = (heap.s_m + heap.radius_m - course.front().s_m) / kRouteStep_m;
    const auto last = static_cast<std::size_t>(std::clamp(to, 0.0, static_cast<double>(course.size() - 1)));
    for (auto i = static_cast<std::size_t>(std::max(0.0, std::ceil(from))); i <= last; ++i) {
      const double along = course[i].s_m - heap.s_m;
      const double across = std::sqrt(std::max(0.0, heap.radius_m * heap.radius_m - along * along));
      recede[i] = std::clamp(heap.beyond_m - across, 0.0, recede[i]);
    }
  }
  return smoothed(recede, 1.0);
}

}  // namespace

Run make_haul_road(const HaulRoadConfig& config, std::vector<RoutePoint> course, double width_share,
                   const RunSeed& seed) {
  // What the toe recedes adds to the width.
  const double low = std::max(2.0, width_share * config.min_width_m);
  const double high = std::max(low, width_share * config.max_width_m - 2.0 * kMostRecede_m);
  set_widths(course, low, high, kWidthWave_m, seed);
  Run run;
  run.cross_fall = make_cross_fall(course, config.cross_fall_deg, seed);
  const double steepest = std::tan(config.min_repose_deg * kRadPerDeg);
  std::vector<Heap> heaps;
  const std::vector<RoutePoint> dumped = course;
  const Route line(dumped);
  for (std::uint64_t side = 0; side < 2; ++side) {
    const double sign = side == 0 ? 1.0 : -1.0;
    const std::vector<RowHeap> row = dump_row(config, dumped, seed, side);
    for (const RowHeap& heap : row) {
      const RoutePoint at = line.at(heap.s_m);
      const Eigen::Vector2d place = beside(at, sign * ((side == 0 ? at.left_m : at.right_m) + heap.beyond_m));
      heaps.push_back({place.x(), place.y(), heap.radius_m, heap.height_m, heap.slope});
    }
    const std::vector<double> recede = recede_of(row, dumped);
    for (std::size_t i = 0; i < course.size(); ++i) {
      (side == 0 ? course[i].left_m : course[i].right_m) += recede[i];
    }
    run.sides[side].shoulder_m = constant_profile(course, 2.0 * config.max_berm_m / steepest + 0.5);
  }
  run.heaps = Buckets<Heap>(std::move(heaps));
  run.route = Route(std::move(course));
  run.finish(seed.run == 0 ? kBlend_m : kForkBlend_m);
  return run;
}

}  // namespace berm::sim
