#include "berm/geometry/plane_fit.hpp"

#include <cmath>

#include "principal_axes.hpp"
#include "reweigh.hpp"

namespace berm {

std::optional<PlaneFit> fit_plane(const Moments& moments) {
  if (moments.count() < 3) {
    return std::nullopt;
  }
  const std::optional<PrincipalAxes> axes = principal_axes(moments);
  if (!axes) {
    return std::nullopt;
  }
  const Eigen::Vector3d& values = axes->eigenvalues_m2;
  // Points on a line in floats leave it by 1e-7 of its length, that is 1e-14 of its variance.
  constexpr double kThinnest = 1e-12;
  const bool on_a_line = values[1] <= axes->smallest_m2 || values[1] <= kThinnest * values[2];
  if (on_a_line || !is_longer(values[1], values[0], axes->smallest_m2)) {
    return std::nullopt;
  }
  return PlaneFit{.centroid_m = moments.mean_m(),
                  .normal = with_sign(axes->axes.col(0), {2, 1, 0}),
                  .eigenvalues_m2 = values,
                  .rms_m = std::sqrt(values[0]),
                  .count = moments.count(),
                  .weight = moments.weight()};
}

std::optional<PlaneFit> fit_plane(const PointsView& points, std::span<const double> weights) {
  return fit_plane(moments_of(points, weights));
}

std::optional<PlaneFit> fit_plane_robust(const PointsView& points, const RobustFitConfig& config) {
  return reweigh<PlaneFit>(points, config, &fit_plane);
}

}  // namespace berm
