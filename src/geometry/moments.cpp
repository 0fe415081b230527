#include "berm/geometry/moments.hpp"

#include <cmath>
#include <string>

#include "berm/core/error.hpp"

namespace berm {

void Moments::add(const Eigen::Vector3d& point_m, double weight) {
  if (!point_m.allFinite() || !std::isfinite(weight) || weight <= 0.0) {
    return;
  }
  if (count_ == 0) {
    first_m_ = point_m;
  }
  ++count_;
  weight_ += weight;
  const Eigen::Vector3d from_first_m = point_m - first_m_;
  const Eigen::Vector3d from_old_m = from_first_m - mean_from_first_m_;
  mean_from_first_m_ += (weight / weight_) * from_old_m;
  const Eigen::Vector3d from_new_m = from_first_m - mean_from_first_m_;
  scatter_m2_ += weight * from_old_m * from_new_m.transpose();
}

void Moments::merge(const Moments& other) {
  if (other.count_ == 0) {
    return;
  }
  if (count_ == 0) {
    *this = other;
    return;
  }
  const double weight = weight_ + other.weight_;
  const Eigen::Vector3d between_m = (other.first_m_ - first_m_) + (other.mean_from_first_m_ - mean_from_first_m_);
  const double share = other.weight_ / weight;
  scatter_m2_ += other.scatter_m2_ + (weight_ * share) * between_m * between_m.transpose();
  mean_from_first_m_ += share * between_m;
  weight_ = weight;
  count_ += other.count_;
}

Eigen::Matrix3d Moments::covariance_m2() const {
  if (count_ == 0) {
    return Eigen::Matrix3d::Zero();
  }
  // The products of `add` are symmetric up to rounding only.
  return (scatter_m2_ + scatter_m2_.transpose()) / (2.0 * weight_);
}

Moments moments_of(const PointsView& points, std::span<const double> weights) {
  if (!weights.empty() && weights.size() != points.size()) {
    throw Error(ErrorCode::invalid_argument, "moments: " + std::to_string(weights.size()) + " weights for " +
                                                 std::to_string(points.size()) + " points");
  }
  Moments moments;
  for (std::size_t i = 0; i < points.size(); ++i) {
    moments.add({points.x[i], points.y[i], points.z[i]}, weights.empty() ? 1.0 : weights[i]);
  }
  return moments;
}

}  // namespace berm
