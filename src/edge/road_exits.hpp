#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "berm/geometry/traces.hpp"
#include "road_divide.hpp"
#include "road_view.hpp"

namespace berm {

/// Where the road leaves the view, ahead and behind: there it is seen farthest. Only road that nothing hides counts.
/// Straight ahead or behind where no road is seen.
[[nodiscard]] RoadDivide find_exits(const Traces& traces, std::span<const std::uint8_t> on_road, const RoadView& view);

}  // namespace berm
