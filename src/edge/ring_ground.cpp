#include "ring_ground.hpp"

#include <cmath>

namespace berm {
namespace {

/// E does not say which neighbours; those on the next ring lie metres away, and on a slope decimetres higher.
bool is_level(const RingGrid& grid, int sector, int ring, float t2_m) {
  const RingGrid::Cell& cell = grid.cell(sector, ring);
  for (const int beside : {sector - 1, sector + 1}) {
    const RingGrid::Cell& other = grid.cell(beside, ring);
    if (other.points > 0 && !(std::abs(other.z_m - cell.z_m) < t2_m)) {
      return false;
    }
  }
  return true;
}

/// All that there are of the two cells beside it and the two on the next rings, two of them at least.
bool is_surrounded(const RingGrid& grid, const std::vector<std::uint8_t>& is_ground, int sector, int ring) {
  int around = 0;
  const auto counts = [&](int s, int r) {
    if (r < 0 || r >= grid.rings() || grid.cell(s, r).points == 0) {
      return true;
    }
    ++around;
    return is_ground[grid.offset(s, r)] == 1;
  };
  return counts(sector - 1, ring) && counts(sector + 1, ring) && counts(sector, ring - 1) && counts(sector, ring + 1) &&
         around >= 2;
}

}  // namespace

void find_ring_ground(const RingGrid& grid, double t1_m, double t2_m, std::vector<std::uint8_t>& is_ground) {
  constexpr std::uint8_t kSurrounded = 2;  // apart from 1, so that what is surrounded surrounds nothing itself
  is_ground.assign(grid.cells().size(), 0);
  for (int ring = 0; ring < grid.rings(); ++ring) {
    for (int sector = 0; sector < grid.sectors(); ++sector) {
      const RingGrid::Cell& cell = grid.cell(sector, ring);
      const bool is_flat = cell.points > 0 && cell.highest_m - cell.lowest_m < static_cast<float>(t1_m);
      is_ground[grid.offset(sector, ring)] = is_flat && is_level(grid, sector, ring, static_cast<float>(t2_m)) ? 1 : 0;
    }
  }
  for (int ring = 0; ring < grid.rings(); ++ring) {
    for (int sector = 0; sector < grid.sectors(); ++sector) {
      std::uint8_t& ground = is_ground[grid.offset(sector, ring)];
      if (ground == 0 && grid.cell(sector, ring).points > 0 && is_surrounded(grid, is_ground, sector, ring)) {
        ground = kSurrounded;
      }
    }
  }
  for (std::uint8_t& ground : is_ground) {
    ground = ground != 0 ? 1 : 0;
  }
}

}  // namespace berm
