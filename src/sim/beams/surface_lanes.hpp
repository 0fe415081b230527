#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "beam_footprint.hpp"
#include "berm/sim/sensor.hpp"
#include "echo.hpp"

namespace berm::sim {

/// Rays that met a surface, side by side: what they met, and the echoes that it gives.
// NOLINTNEXTLINE(cppcoreguidelines-pro-type-member-init): every lane is written before it is read
struct alignas(64) SurfaceLanes {
  static constexpr std::size_t kBeams = 64;
  static constexpr std::size_t kMost = kBeams * kFootprintRays;
  template <typename Value>
  using Lanes = std::array<Value, kMost>;

  std::size_t count = 0;
  Lanes<float> range_m;
  Lanes<float> cosine;  ///< of the angle between ray and normal
  Lanes<float> share;   ///< of the energy of the beam
  Lanes<float> reflectivity;
  Lanes<float> reflectivity_sigma;
  Lanes<float> relief_m;
  Lanes<float> roughness;
  Lanes<float> ridges;  ///< 1 where there is corduroy, else 0
  Lanes<float> across_m;
  Lanes<float> slope_x;
  Lanes<float> slope_y;
  Lanes<float> dx;
  Lanes<float> dy;
  Lanes<std::uint32_t> label;

  // As in `Echo`.
  Lanes<float> echo_m;
  Lanes<float> energy;
  Lanes<float> light;
  Lanes<float> variance_m2;
  Lanes<float> spot_sigma;

  [[nodiscard]] Echo echo(std::size_t lane) const {
    return {echo_m[lane], energy[lane], light[lane], variance_m2[lane], spot_sigma[lane], label[lane], energy[lane]};
  }
};

/// Fills in the echoes, without what the air takes of them.
void shade_all(const OpticsConfig& optics, SurfaceLanes& lanes);

}  // namespace berm::sim
