#include "boundary_seam.hpp"

#include <algorithm>
#include <cstddef>

namespace berm {
namespace {

using bearing_grid::kBins;
using bearing_grid::kSectors;

// A seam may also run beyond the last bin.
constexpr std::size_t kPlaces = kBins + 1;

std::size_t wrap(int sector) {
  return static_cast<std::size_t>(sector % kSectors);
}

/// The sectors without the widest gap. A full turn begins and ends straight behind.
BoundarySeam::Arc find_arc(std::span<const std::uint8_t> seen) {
  int gap_begin = 0;
  int gap = 0;
  int run = 0;
  for (int sector = 0; sector < 2 * kSectors; ++sector) {
    run = seen[wrap(sector)] != 0 ? 0 : std::min(run + 1, kSectors);
    if (run > gap) {
      gap = run;
      gap_begin = sector - run + 1;
    }
  }
  return {.first = gap == 0 ? 0 : (gap_begin + gap) % kSectors, .count = kSectors - gap};
}

}  // namespace

BoundarySeam::BoundarySeam(double jump_cost, int max_jump_bins)
    : jump_cost_(static_cast<float>(jump_cost)),
      max_jump_cost_(static_cast<float>(jump_cost * max_jump_bins)),
      cost_(kPlaces),
      reached_(kPlaces),
      from_(std::size_t{kSectors} * kPlaces),
      bound_(kSectors) {}

/// Adds the sector at `place` of the arc: the distance transform of what the seams so far cost, plus the sector's own.
void BoundarySeam::step(std::span<const float> cells, std::size_t place) {
  std::uint8_t* from = from_.data() + place * kPlaces;
  const auto cheapest = std::min_element(cost_.begin(), cost_.end());
  const auto cheapest_bin = static_cast<std::uint8_t>(cheapest - cost_.begin());
  const float jumped = *cheapest + max_jump_cost_;
  for (std::size_t bin = 0; bin < kPlaces; ++bin) {
    const bool jumps = jumped < cost_[bin];
    reached_[bin] = jumps ? jumped : cost_[bin];
    from[bin] = jumps ? cheapest_bin : static_cast<std::uint8_t>(bin);
  }
  for (std::size_t bin = 1; bin < kPlaces; ++bin) {
    if (reached_[bin - 1] + jump_cost_ < reached_[bin]) {
      reached_[bin] = reached_[bin - 1] + jump_cost_;
      from[bin] = from[bin - 1];
    }
  }
  for (std::size_t bin = kPlaces - 1; bin-- > 0;) {
    if (reached_[bin + 1] + jump_cost_ < reached_[bin]) {
      reached_[bin] = reached_[bin + 1] + jump_cost_;
      from[bin] = from[bin + 1];
    }
  }
  float before = 0.0F;
  for (std::size_t bin = 0; bin < kPlaces; ++bin) {
    cost_[bin] = reached_[bin] + before;
    before += bin < kBins ? cells[bin] : 0.0F;
  }
}

std::span<const int> BoundarySeam::find(std::span<const float> cells, std::span<const std::uint8_t> seen) {
  arc_ = find_arc(seen);
  std::fill(bound_.begin(), bound_.end(), kBins);
  if (arc_.count == 0) {
    return bound_;
  }
  std::fill(cost_.begin(), cost_.end(), 0.0F);
  for (int i = 0; i < arc_.count; ++i) {
    step(cells.subspan(wrap(arc_.first + i) * kBins, kBins), static_cast<std::size_t>(i));
  }
  auto bin = static_cast<std::size_t>(std::min_element(cost_.begin(), cost_.end()) - cost_.begin());
  for (int i = arc_.count; i-- > 0;) {
    bound_[wrap(arc_.first + i)] = static_cast<int>(bin);
    bin = from_[static_cast<std::size_t>(i) * kPlaces + bin];
  }
  const int gap = kSectors - arc_.count;
  for (int i = 0; i < gap; ++i) {
    const int last = arc_.first + arc_.count - 1;
    bound_[wrap(last + 1 + i)] = bound_[i < gap / 2 ? wrap(last) : wrap(arc_.first)];
  }
  return bound_;
}

}  // namespace berm
