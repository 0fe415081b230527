#pragma once

#include <cstddef>
#include <optional>
#include <span>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "berm/core/point_cloud.hpp"
#include "berm/geometry/moments.hpp"
#include "berm/geometry/robust_fit.hpp"

namespace berm {

/// The straight line that is nearest to points in the sense of least squares, and how well they determine it.
struct LineFit {
  Eigen::Vector3d centroid_m;      ///< a point of the line: the weighted mean
  Eigen::Vector3d direction;       ///< unit length; x >= 0, then y >= 0, then z >= 0
  Eigen::Vector3d eigenvalues_m2;  ///< of the covariance, ascending: twice across the line, then along it
  double rms_m = 0.0;              ///< weighted root mean square of the distances
  std::size_t count = 0;           ///< points that were used
  double weight = 0.0;             ///< sum of their weights

  /// Distance of a point.
  [[nodiscard]] double distance_m(const Eigen::Vector3d& point_m) const {
    return direction.cross(point_m - centroid_m).norm();
  }
};

/// Nothing if the points determine no line: fewer than two, all at one place, or as broad as long.
[[nodiscard]] std::optional<LineFit> fit_line(const Moments& moments);

/// As above, of the points of a cloud; those that are not finite are left out. `weights` as for `moments_of`.
[[nodiscard]] std::optional<LineFit> fit_line(const PointsView& points, std::span<const double> weights = {});

/// The line that most points agree on: those farther away than a few `config.scale_m` lose their say.
/// Throws ConfigError as `RobustFitConfig::check`.
[[nodiscard]] std::optional<LineFit> fit_line_robust(const PointsView& points, const RobustFitConfig& config);

}  // namespace berm
