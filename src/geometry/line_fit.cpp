#include "berm/geometry/line_fit.hpp"

#include <cmath>

#include "principal_axes.hpp"
#include "reweigh.hpp"

namespace berm {

std::optional<LineFit> fit_line(const Moments& moments) {
  if (moments.count() < 2) {
    return std::nullopt;
  }
  const std::optional<PrincipalAxes> axes = principal_axes(moments);
  if (!axes || !is_longer(axes->eigenvalues_m2[2], axes->eigenvalues_m2[1], axes->smallest_m2)) {
    return std::nullopt;
  }
  const Eigen::Vector3d& values = axes->eigenvalues_m2;
  return LineFit{.centroid_m = moments.mean_m(),
                 .direction = with_sign(axes->axes.col(2), {0, 1, 2}),
                 .eigenvalues_m2 = values,
                 .rms_m = std::sqrt(values[0] + values[1]),
                 .count = moments.count(),
                 .weight = moments.weight()};
}

std::optional<LineFit> fit_line(const PointsView& points, std::span<const double> weights) {
  return fit_line(moments_of(points, weights));
}

std::optional<LineFit> fit_line_robust(const PointsView& points, const RobustFitConfig& config) {
  return reweigh<LineFit>(points, config, &fit_line);
}

}  // namespace berm
