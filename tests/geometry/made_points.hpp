#pragma once

#include <limits>
#include <random>
#include <vector>

#include <Eigen/Core>

#include "berm/core/point_cloud.hpp"

namespace berm::test {

inline constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
inline constexpr float kInf = std::numeric_limits<float>::infinity();
inline constexpr float kHuge = std::numeric_limits<float>::max();

inline PointCloud cloud_of(const std::vector<Eigen::Vector3d>& points_m) {
  PointChannels channels;
  for (const Eigen::Vector3d& p : points_m) {
    channels.x.push_back(static_cast<float>(p.x()));
    channels.y.push_back(static_cast<float>(p.y()));
    channels.z.push_back(static_cast<float>(p.z()));
  }
  return PointCloud(std::move(channels));
}

/// Numbers that are the same with every standard library, unlike those of its distributions.
class Noise {
 public:
  explicit Noise(unsigned seed) : engine_(seed) {}
  /// Evenly in [-size, size).
  double even(double size) { return size * (static_cast<double>(engine_()) / 2147483648.0 - 1.0); }
  /// Nearly normal: the sum of twelve even numbers has variance sigma^2.
  double normal(double sigma) {
    double sum = 0.0;
    for (int i = 0; i < 12; ++i) {
      sum += even(0.5);
    }
    return sigma * sum;
  }

 private:
  std::mt19937 engine_;
};

}  // namespace berm::test
