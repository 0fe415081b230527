#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "beams.hpp"
#include "berm/io/recording_info.hpp"

namespace berm {

/// How the direction of the beam moves along the list of points.
struct BeamMotion {
  double net_turns = 0.0;        ///< azimuth from the first to the last point, unwrapped
  double travelled_turns = 0.0;  ///< sum of all steps in azimuth
  double stagger_rad = 0.0;      ///< median step in azimuth from one point to the next
  int best_lag = 1;              ///< the number of points on, at which the beam is nearest to where it was
  double best_step_rad = 0.0;    ///< median angle between points `best_lag` apart
  double random_step_rad = 0.0;  ///< median angle between points that have nothing to do with each other
  double elevation_share = 0.0;  ///< extent of a 1/128 of the list over the extent of all, median
  double azimuth_share = 0.0;    ///< the same for azimuth
};

/// None for fewer than 1000 beams.
[[nodiscard]] std::optional<BeamMotion> measure_motion(std::span<const Beam> beams);

[[nodiscard]] FiringOrder classify(const BeamMotion& motion);

/// Number of lasers: distinct values of `ring` where the scan has them, else from how the beams move.
[[nodiscard]] std::optional<RingCount> count_rings(std::span<const std::uint16_t> ring, std::span<const Beam> beams,
                                                   FiringOrder order, const BeamMotion& motion);

}  // namespace berm
