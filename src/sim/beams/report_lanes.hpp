#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "beam_random.hpp"
#include "berm/sim/sensor.hpp"
#include "echo.hpp"
#include "surface_lanes.hpp"

namespace berm::sim {

/// Echoes that the sensor takes, one a beam, side by side, and what it reports of them.
// NOLINTNEXTLINE(cppcoreguidelines-pro-type-member-init): every lane is written before it is read
struct alignas(64) ReportLanes {
  static constexpr std::size_t kMost = SurfaceLanes::kBeams;
  template <typename Value>
  using Lanes = std::array<Value, kMost>;

  std::size_t count = 0;
  Lanes<float> range_m;  ///< of the echo, then as reported
  Lanes<float> energy;
  Lanes<float> light;
  Lanes<float> variance_m2;
  Lanes<float> spot_sigma;
  Lanes<float> share;  ///< where noise comes from, as UniformPair
  Lanes<float> turn;
  Lanes<float> reflectivity;  ///< as reported
  Lanes<std::uint32_t> label;
  Lanes<std::uint32_t> beam;

  void add(std::size_t of_beam, const Echo& echo, UniformPair chance);
};

/// Fills in what the sensor reports.
void report_all(const OpticsConfig& optics, ReportLanes& lanes);

}  // namespace berm::sim
