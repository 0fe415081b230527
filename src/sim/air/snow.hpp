#pragma once

#include <cstdint>

#include "air_lanes.hpp"
#include "gusts.hpp"
#include "snowfall_table.hpp"

namespace berm::sim {

/// Flakes that fall, and those that blow along the ground: a Poisson process in space.
class Snow {
 public:
  Snow(const SnowfallConfig& snowfall, const OpticsConfig& optics, std::uint64_t seed);

  [[nodiscard]] bool is_empty() const { return snowfall_.flakes_per_m3 <= 0.0 && snowfall_.drift_flakes_per_m3 <= 0.0; }
  /// Expected number of flakes that are found nearer than `range_m`, without gusts and drift.
  [[nodiscard]] double expected(double range_m) const { return snowfall_.flakes_per_m3 * table_.expected(range_m); }
  /// Sets what flakes leave of every beam, and the echo of the nearest that is found.
  void pass(AirLanes& beams) const;

 private:
  /// Flakes per cubic metre along one beam.
  struct Density {
    float gust;
    float most;
  };

  [[nodiscard]] double at(const Density& density, double height_m) const;
  [[nodiscard]] double nearest_m(const AirLanes& beams, std::size_t lane, const Density& density) const;
  void add_flake(AirLanes& beams, std::size_t lane, double range_m) const;

  SnowfallConfig snowfall_;
  OpticsConfig optics_;
  SnowfallTable table_;
  Gusts gusts_;
};

}  // namespace berm::sim
