#include "ring_cues.hpp"

#include <cmath>

namespace berm {
namespace {

class Cues {
 public:
  Cues(const RingGrid& grid, std::span<const std::uint8_t> is_ground, const RingEdgesConfig& config)
      : grid_(grid), is_ground_(is_ground), config_(config) {}

  /// a: this ring lies nearer to the one before than on flat ground. h cot(theta) is where the beam of a cell would
  /// meet flat ground, and its direction is known from where it did meet the ground.
  [[nodiscard]] bool is_compressed(int sector, int ring) const {
    if (ring == 0 || !ground(sector, ring - 1)) {
      return false;
    }
    const RingGrid::Cell& inner = grid_.cell(sector, ring - 1);
    const RingGrid::Cell& outer = grid_.cell(sector, ring);
    const float h = grid_.sensor_height_m();
    if (!(inner.z_m < h && outer.z_m < h)) {
      return false;  // beams that do not point down never meet flat ground
    }
    const float flat_m = h * (outer.radius_m / (h - outer.z_m) - inner.radius_m / (h - inner.z_m));
    const float gap_m = outer.radius_m - inner.radius_m;
    return gap_m >= static_cast<float>(config_.alpha) * flat_m && gap_m < static_cast<float>(config_.beta) * flat_m;
  }

  /// b: the first ring outward that lies T2 above the one before.
  [[nodiscard]] int first_rise(int sector) const {
    const RingGrid::Cell* before = nullptr;
    for (int ring = 0; ring < grid_.rings(); ++ring) {
      if (ground(sector, ring)) {
        const RingGrid::Cell& cell = grid_.cell(sector, ring);
        if (before != nullptr && cell.z_m - before->z_m >= static_cast<float>(config_.t2_m)) {
          return ring;
        }
        before = &cell;
      }
    }
    return -1;
  }

  /// c: the radius changes along the ring, while to either side it wanders by less than T3 from sector to sector.
  [[nodiscard]] bool turns_away(int sector, int ring) const {
    constexpr int kReach = 3;
    float change_m = 0.0F;
    for (const int side : {-1, 1}) {
      for (int i = 1; i <= kReach; ++i) {
        if (!ground(sector + side * i, ring)) {
          return false;
        }
        const float wander_m = radius(sector + side * i, ring) - radius(sector + side * (i - 1), ring);
        if (!(std::abs(wander_m) < static_cast<float>(config_.t3_m))) {
          return false;
        }
        change_m += wander_m;
      }
    }
    return std::abs(change_m) / static_cast<float>(kReach) >= 0.5F * static_cast<float>(config_.t3_m);
  }

  [[nodiscard]] bool ground(int sector, int ring) const { return is_ground_[grid_.offset(sector, ring)] != 0; }

 private:
  [[nodiscard]] float radius(int sector, int ring) const { return grid_.cell(sector, ring).radius_m; }

  const RingGrid& grid_;
  std::span<const std::uint8_t> is_ground_;
  const RingEdgesConfig& config_;
};

}  // namespace

void mark_ring_edges(const RingGrid& grid, std::span<const std::uint8_t> is_ground, const RingEdgesConfig& config,
                     std::vector<std::uint8_t>& is_edge) {
  const Cues cues(grid, is_ground, config);
  is_edge.assign(grid.cells().size(), 0);
  for (int sector = 0; sector < grid.sectors(); ++sector) {
    const int rise = cues.first_rise(sector);
    for (int ring = 0; ring < grid.rings(); ++ring) {
      const bool marked = cues.ground(sector, ring) &&
                          (ring == rise || cues.is_compressed(sector, ring) || cues.turns_away(sector, ring));
      is_edge[grid.offset(sector, ring)] = marked ? 1 : 0;
    }
  }
}

}  // namespace berm
