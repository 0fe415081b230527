#pragma once

#include <cstdint>
#include <vector>

#include <Eigen/Core>

#include "berm/sim/weather.hpp"

namespace berm::sim {

/// Clouds of flakes that move with the wind: by which factor the density differs from its mean, which is 1.
class Gusts {
 public:
  Gusts(const SnowfallConfig& snowfall, std::uint64_t seed);

  [[nodiscard]] double at(const Eigen::Vector3d& place_m, double time_s) const;

 private:
  /// The lattice repeats after so many nodes: 770 m at the usual size of a gust.
  static constexpr std::int64_t kNodes = 64;

  [[nodiscard]] double node(std::int64_t column, std::int64_t row) const {
    return nodes_[static_cast<std::size_t>((row & (kNodes - 1)) * kNodes + (column & (kNodes - 1)))];
  }

  double gustiness_;
  double nodes_per_m_;
  double velocity_x_m_per_s_;
  double velocity_y_m_per_s_;
  std::vector<float> nodes_;  ///< row by row
};

}  // namespace berm::sim
