#pragma once

#include <span>

#include <Eigen/Core>

namespace berm {

/// The road around the machine as one quadratic polynomial of the map, z(x, y) in the levelled frame. Near the machine
/// it is well known; far out it only says on which floor the road lies.
class RoadSurface {
 public:
  /// Places that may be road, or not: the surface settles on what most near it agree on, starting from the plane that
  /// the machine stands on.
  void fit(std::span<const float> x, std::span<const float> y, std::span<const float> z);
  /// The level plane.
  void reset() { c_.setZero(); }

  [[nodiscard]] float height_m(float x_m, float y_m) const {
    const float x = x_m * kPerMetre;
    const float y = y_m * kPerMetre;
    return c_[0] + x * (c_[1] + x * c_[3] + y * c_[4]) + y * (c_[2] + y * c_[5]);
  }

 private:
  static constexpr float kPerMetre = 0.05F;

  Eigen::Matrix<float, 6, 1> c_ = Eigen::Matrix<float, 6, 1>::Zero();
};

}  // namespace berm
