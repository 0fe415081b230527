#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "air_lanes.hpp"

namespace berm::sim {

/// Clouds of flakes that move with the wind: by which factor the density differs from its mean, which is 1.
class Gusts {
 public:
  Gusts(const SnowfallConfig& snowfall, std::uint64_t seed);

  /// For every beam, `range_m` along it or where it ends before. Fills the packets of `factors`.
  void along(const AirLanes& beams, float range_m, std::span<float> factors) const;

 private:
  /// The lattice repeats after so many nodes: 770 m at the usual size of a gust.
  static constexpr std::int32_t kNodes = 64;

  double gustiness_;
  double nodes_per_m_;
  double velocity_x_m_per_s_;
  double velocity_y_m_per_s_;
  std::vector<float> nodes_;  ///< row by row
};

}  // namespace berm::sim
