#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

#include "berm/core/point_cloud.hpp"
#include "berm/geometry/moments.hpp"
#include "berm/geometry/robust_fit.hpp"

namespace berm {

/// 1 for points whose place is plausible beside the others, 0 for such that are not finite or absurdly far from them.
[[nodiscard]] std::vector<double> plausible(const PointsView& points);

/// The loop that `RobustFitConfig` describes, for anything with `distance_m` that `fit` makes of moments.
template <typename Fit>
std::optional<Fit> reweigh(const PointsView& points, const RobustFitConfig& config,
                           std::optional<Fit> (*fit)(const Moments&)) {
  config.check();
  // Zhou, Park and Koltun (2016) divide the square of the scale by 2 in each step.
  constexpr double kShrink = 0.7;
  // At the last scale, steps smaller than this share of it no longer matter.
  constexpr double kSettled = 1e-6;
  const std::vector<double> allowed = plausible(points);
  std::optional<Fit> best = fit(moments_of(points, allowed));
  if (!best) {
    return std::nullopt;
  }
  std::vector<double> squares_m2(points.size());
  std::vector<double> weights(points.size());
  double scale_m = 0.0;
  for (int iteration = 0; iteration < config.max_iterations; ++iteration) {
    double largest_m2 = 0.0;
    for (std::size_t i = 0; i < points.size(); ++i) {
      const double distance_m = best->distance_m({points.x[i], points.y[i], points.z[i]});
      squares_m2[i] = distance_m * distance_m;
      largest_m2 = allowed[i] > 0.0 ? std::max(largest_m2, squares_m2[i]) : largest_m2;
    }
    scale_m = std::max(iteration == 0 ? std::sqrt(largest_m2) : kShrink * scale_m, config.scale_m);
    const double scale_m2 = scale_m * scale_m;
    for (std::size_t i = 0; i < points.size(); ++i) {
      const double share = scale_m2 / (scale_m2 + squares_m2[i]);
      weights[i] = allowed[i] > 0.0 ? share * share : 0.0;
    }
    const std::optional<Fit> next = fit(moments_of(points, weights));
    if (!next) {
      return std::nullopt;
    }
    const double moved_m = std::abs(best->distance_m(next->centroid_m)) + std::abs(best->rms_m - next->rms_m);
    best = next;
    if (scale_m <= config.scale_m && moved_m < kSettled * config.scale_m) {
      break;
    }
  }
  return best;
}

}  // namespace berm
