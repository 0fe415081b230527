#pragma once

#include <cstdint>
#include <vector>

#include "berm/sim/world_config.hpp"
#include "run.hpp"

namespace berm::sim {

/// What is random about a run: seed of the world and number of the run in it.
struct RunSeed {
  std::uint64_t seed = 0;
  std::uint64_t run = 0;
};

/// Each gives a course (see lay_course) the widths, cross-fall and berms of its kind. `width_share`: of the configured
/// widths, less than 1 for what branches off.
[[nodiscard]] Run make_piste(const PisteConfig& config, std::vector<RoutePoint> course, double width_share,
                             const RunSeed& seed);
[[nodiscard]] Run make_haul_road(const HaulRoadConfig& config, std::vector<RoutePoint> course, double width_share,
                                 const RunSeed& seed);
[[nodiscard]] Run make_paved(const PavedConfig& config, std::vector<RoutePoint> course, double width_m);

/// Greatest distance from the line to an edge, and from there to the foot of a berm, that a plan can lead to.
[[nodiscard]] double greatest_reach_m(const WorldPlan& plan);

}  // namespace berm::sim
