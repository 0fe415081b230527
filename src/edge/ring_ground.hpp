#pragma once

#include <cstdint>
#include <vector>

#include "ring_grid.hpp"

namespace berm {

/// Ground candidates (E step 2): 1 for every cell of `grid` whose heights lie within `t1_m` of each other and within
/// `t2_m` of those beside it on the ring, and for cells that such cells surround. Reuses the memory of `is_ground`.
void find_ring_ground(const RingGrid& grid, double t1_m, double t2_m, std::vector<std::uint8_t>& is_ground);

}  // namespace berm
