#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

namespace berm::sim {

/// Light that comes back from one place, or from several that the receiver cannot tell apart.
struct Echo {
  float range_m = 0.0F;
  float energy = 0.0F;       ///< what the sensor reports as reflectivity
  float light = 0.0F;        ///< what it detects, as `received_light`
  float variance_m2 = 0.0F;  ///< of the range, from the surface
  float spot_sigma = 0.0F;   ///< standard deviation of the energy from spot to spot
  std::uint32_t label = 0;
  float label_lead = 0.0F;  ///< energy by which it is ahead of other labels
};

/// Melts echoes that are nearer to the next than `separation_m` into one at the mean of their ranges, weighted by
/// energy. Energy and light are conserved. Returns how many are left, at the front of `echoes`, sorted by range.
std::size_t melt(std::span<Echo> echoes, float separation_m);

/// Which echo of those that are detected a sensor reports.
enum class EchoChoice : std::uint8_t { strongest, first, last };
/// "strongest", "first", "last", as OpticsConfig::check allows.
[[nodiscard]] EchoChoice echo_choice(std::string_view name);

}  // namespace berm::sim
