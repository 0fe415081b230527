#pragma once

#include <cstddef>
#include <optional>
#include <span>

#include <Eigen/Core>

#include "berm/core/point_cloud.hpp"
#include "berm/geometry/moments.hpp"
#include "berm/geometry/robust_fit.hpp"

namespace berm {

/// The plane that is nearest to points in the sense of least squares, and how well they determine it.
struct PlaneFit {
  Eigen::Vector3d centroid_m;      ///< a point of the plane: the weighted mean
  Eigen::Vector3d normal;          ///< unit length; z >= 0, then y >= 0, then x >= 0
  Eigen::Vector3d eigenvalues_m2;  ///< of the covariance, ascending: across the plane, then along it
  double rms_m = 0.0;              ///< weighted root mean square of the distances
  std::size_t count = 0;           ///< points that were used
  double weight = 0.0;             ///< sum of their weights

  /// Signed distance of a point, positive on the side of the normal.
  [[nodiscard]] double distance_m(const Eigen::Vector3d& point_m) const { return normal.dot(point_m - centroid_m); }
};

/// Nothing if the points determine no plane: fewer than three, on one line, all at one place, or as thick as wide.
[[nodiscard]] std::optional<PlaneFit> fit_plane(const Moments& moments);

/// As above, of the points of a cloud; those that are not finite are left out. `weights` as for `moments_of`.
[[nodiscard]] std::optional<PlaneFit> fit_plane(const PointsView& points, std::span<const double> weights = {});

/// The plane that most points agree on: those farther away than a few `config.scale_m` lose their say.
/// Throws ConfigError as `RobustFitConfig::check`.
[[nodiscard]] std::optional<PlaneFit> fit_plane_robust(const PointsView& points, const RobustFitConfig& config);

}  // namespace berm
