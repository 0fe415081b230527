#pragma once

#include <cstddef>

#include "berm/core/trajectory.hpp"

namespace berm::sim {

/// A leg is no shorter: braking and setting off have to find place in it.
inline constexpr double kShortestLeg_s = 10.0;

/// `samples` poses of a machine that drives the first `leg_s` of `once` there and back again and again: it brakes at
/// the end, turns half round on the spot, always to the left, and sets off. Stamps from 0 in steps of `step_ns`;
/// `once` begins at 0.
[[nodiscard]] Trajectory drive_legs(const Trajectory& once, double leg_s, std::size_t samples, Stamp step_ns);

}  // namespace berm::sim
