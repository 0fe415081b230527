#pragma once

#include <array>
#include <cstddef>

#include "berm/sim/random.hpp"
#include "berm/sim/weather.hpp"

namespace berm::sim {

/// Beams on their way through the air side by side, as `AirBeam`, and what becomes of them, as `AirPath`. Neighbours
/// had better lie close to each other: eight of them look for plumes together.
// NOLINTNEXTLINE(cppcoreguidelines-pro-type-member-init): every lane is written before it is read
struct alignas(64) AirLanes {
  static constexpr std::size_t kMost = 64;
  /// Computed with at once.
  static constexpr std::size_t kPacket = 8;
  template <typename Value>
  using Lanes = std::array<Value, kMost>;

  Lanes<float> x_m;  ///< origin, world frame
  Lanes<float> y_m;
  Lanes<float> z_m;
  Lanes<float> dx;  ///< unit direction
  Lanes<float> dy;
  Lanes<float> dz;
  Lanes<float> end_m;
  Lanes<float> slope;
  Lanes<double> time_s;
  Lanes<Random*> random;  ///< of the beam, where all chance comes from
  double height_m = 1e3;
  std::size_t count = 0;

  Lanes<float> transmission;
  Lanes<bool> has_echo;
  Lanes<AirEcho> echo;  ///< where there is one

  /// The lanes that are computed with: as many packets as it takes.
  [[nodiscard]] std::size_t padded() const { return (count + kPacket - 1) / kPacket * kPacket; }
  /// Makes the last packet whole by repeating the last beam. `count` must not be 0.
  void pad();
};

}  // namespace berm::sim
