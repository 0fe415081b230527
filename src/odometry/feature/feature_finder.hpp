#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "berm/odometry/feature_odometry.hpp"
#include "feature.hpp"

namespace berm {

/// Curvature of the middle one of points in firing order, by P eq. 10: length of the sum of the differences to the
/// others, divided by their number and the range. `series_m`: an odd number of points, at least 3, of the sensor's
/// frame.
[[nodiscard]] double curvature_of(std::span<const Eigen::Vector3d> series_m);

/// Finds the features of a scan. Keeps its memory.
class FeatureFinder {
 public:
  /// In firing order, laser by laser. All neighbours of a feature are returns: beside a flake or the sky, any curvature
  /// would come out. Valid until the next call.
  [[nodiscard]] const std::vector<Feature>& process(const OdometryInput& input, const FeatureOdometryConfig& config);

 private:
  void order_by_laser(const PointsView& points);
  void collect(const OdometryInput& input, std::span<const Eigen::Vector3d> series_m, std::size_t middle,
               const FeatureOdometryConfig& config);
  void limit_piste_planes(std::size_t count);

  std::vector<std::uint32_t> order_;
  std::vector<Eigen::Vector3d> series_m_;  ///< usable points in a row, up to the newest
  std::vector<Feature> features_;
  std::vector<double> curvatures_;
};

}  // namespace berm
