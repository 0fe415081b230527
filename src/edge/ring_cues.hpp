#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "berm/edge/ring_edges.hpp"
#include "ring_grid.hpp"

namespace berm {

/// Edge candidates (E step 3): 1 for every ground cell of `grid` that one of the three cues marks. Reuses the memory of
/// `is_edge`.
void mark_ring_edges(const RingGrid& grid, std::span<const std::uint8_t> is_ground, const RingEdgesConfig& config,
                     std::vector<std::uint8_t>& is_edge);

}  // namespace berm
