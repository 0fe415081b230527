#pragma once

#include <cstdint>

#include <Eigen/Core>

#include "berm/sim/weather.hpp"

namespace berm::sim {

/// Clouds of flakes that move with the wind: by which factor the density differs from its mean, which is 1.
class Gusts {
 public:
  Gusts(const SnowfallConfig& snowfall, std::uint64_t seed);

  [[nodiscard]] double at(const Eigen::Vector3d& place_m, double time_s) const;

 private:
  double gustiness_;
  double nodes_per_m_;
  double velocity_x_m_per_s_;
  double velocity_y_m_per_s_;
  std::uint64_t seed_;
};

}  // namespace berm::sim
