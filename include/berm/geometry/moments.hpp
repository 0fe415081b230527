#pragma once

#include <cstddef>
#include <span>

#include <Eigen/Core>

#include "berm/core/point_cloud.hpp"

namespace berm {

/// Weight, mean and scatter of points, one at a time or merged from parts, without keeping the points. The sums are
/// taken about the running mean (Welford 1962, Chan et al. 1979), and that relative to the first point, so that
/// millimetres at a UTM northing of 5e6 m stay exact.
class Moments {
 public:
  /// Adds a point. A point that is not finite and a weight that is not finite and positive are left out.
  void add(const Eigen::Vector3d& point_m, double weight = 1.0);
  /// Adds all that `other` holds: the same as if its points had been added here, up to rounding.
  void merge(const Moments& other);

  /// Points that were added.
  [[nodiscard]] std::size_t count() const { return count_; }
  /// Sum of their weights.
  [[nodiscard]] double weight() const { return weight_; }
  /// Weighted mean; zero without points.
  [[nodiscard]] Eigen::Vector3d mean_m() const { return first_m_ + mean_from_first_m_; }
  /// Weighted covariance (divided by the sum of the weights); zero without points.
  [[nodiscard]] Eigen::Matrix3d covariance_m2() const;

 private:
  std::size_t count_ = 0;
  double weight_ = 0.0;
  Eigen::Vector3d first_m_ = Eigen::Vector3d::Zero();
  Eigen::Vector3d mean_from_first_m_ = Eigen::Vector3d::Zero();
  Eigen::Matrix3d scatter_m2_ = Eigen::Matrix3d::Zero();  ///< weighted sum of (p - mean)(p - mean)^T
};

/// Moments of all points of a cloud. `weights`: one per point, or empty for equal ones.
/// Throws Error(invalid_argument) if they are neither.
[[nodiscard]] Moments moments_of(const PointsView& points, std::span<const double> weights = {});

}  // namespace berm
