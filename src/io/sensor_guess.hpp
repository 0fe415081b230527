#pragma once

#include <optional>

#include "berm/io/recording_info.hpp"
#include "firing_order.hpp"

namespace berm {

/// Compares what a scan shows with the data sheets of common sensors. Never sure: thinned, cropped or moved clouds fit
/// nothing or the wrong one, so that the reasons come along.
[[nodiscard]] SensorGuess guess_sensor(FiringOrder order, const std::optional<RingCount>& rings,
                                       const FieldOfView& view, const BeamMotion& motion);

}  // namespace berm
