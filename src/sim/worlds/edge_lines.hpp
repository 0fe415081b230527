#pragma once

#include <vector>

#include "berm/sim/world.hpp"
#include "built_terrain.hpp"

namespace berm::sim {

/// The edges of all runs, at the toe of their berms; interrupted where another run passes through.
[[nodiscard]] std::vector<EdgeLine> find_edges(const BuiltTerrain& terrain);

}  // namespace berm::sim
