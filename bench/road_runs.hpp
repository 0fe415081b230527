#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "support/simulated_run.hpp"

namespace berm::bench {

/// Haul roads of 300 m and more, each with another seed: bends, widths, junctions, holes, parked trucks, sensors. The
/// time of each is what the truck needs for its road.
[[nodiscard]] std::vector<test::RunPlan> road_runs(std::uint64_t seed_offset);
/// Two roads in dust behind another truck, and the same in clear air.
[[nodiscard]] std::vector<test::RunPlan> dust_runs(std::uint64_t seed_offset);

}  // namespace berm::bench
