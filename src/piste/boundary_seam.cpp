#include "boundary_seam.hpp"

#include <algorithm>
#include <cstddef>

#include "berm/core/multiversion.hpp"

namespace berm {
namespace {

using bearing_grid::kBins;
using bearing_grid::kSectors;

// A seam may also run beyond the last bin.
constexpr std::size_t kPlaces = kBins + 1;
// The longest jump that is made in one step, and walls so wide.
constexpr std::size_t kPad = 32;
constexpr float kWall = 1e30F;

/// to[i] = min(from[i], from[i - step] + price, from[i + step] + price); both have walls of kPad places at either end.
BERM_MULTIVERSION void widen(const float* __restrict from, float* __restrict to, std::ptrdiff_t step, float price) {
  for (std::ptrdiff_t i = 0; i < std::ptrdiff_t{kPlaces}; ++i) {
    const float nearer = from[i - step] < from[i + step] ? from[i - step] : from[i + step];
    to[i] = from[i] < nearer + price ? from[i] : nearer + price;
  }
}

}  // namespace

BoundarySeam::BoundarySeam(double jump_cost, int max_jump_bins)
    : jump_cost_(static_cast<float>(jump_cost)),
      max_jump_bins_(static_cast<std::size_t>(max_jump_bins)),
      costs_(std::size_t{kSectors} * kPlaces),
      reached_(kPlaces + 2 * kPad, kWall),
      spare_(kPlaces + 2 * kPad, kWall),
      bound_(kSectors) {}

/// Turns costs of seams that end in a bin into those of reaching a bin from any: jumps of 1, 2, 4 and so on bins make
/// up all of them, and those beyond the longest that is charged cost no more than it.
void BoundarySeam::reach() {
  const float* costs = reached_.data() + kPad;
  const float any = *std::min_element(costs, costs + kPlaces) + static_cast<float>(max_jump_bins_) * jump_cost_;
  for (std::size_t covered = 0; covered < std::min(max_jump_bins_, kPlaces - 1);) {
    const std::size_t step = std::min(covered + 1, kPad);
    widen(reached_.data() + kPad, spare_.data() + kPad, static_cast<std::ptrdiff_t>(step),
          static_cast<float>(step) * jump_cost_);
    reached_.swap(spare_);
    covered += step;
  }
  for (std::size_t i = kPad; i < kPad + kPlaces; ++i) {
    reached_[i] = std::min(reached_[i], any);
  }
}

/// Bin of the sector before that the best seam through `bin` came from.
std::size_t BoundarySeam::best_before(std::size_t place, std::size_t bin) const {
  const float* before = costs_.data() + (place - 1) * kPlaces;
  std::size_t best = bin;
  float least = before[bin];
  for (std::size_t from = 0; from < kPlaces; ++from) {
    const std::size_t jump = std::min(from > bin ? from - bin : bin - from, max_jump_bins_);
    const float cost = before[from] + static_cast<float>(jump) * jump_cost_;
    if (cost < least) {
      least = cost;
      best = from;
    }
  }
  return best;
}

std::span<const int> BoundarySeam::find(std::span<const float> cells, const bearing_grid::Arc& arc) {
  std::fill(bound_.begin(), bound_.end(), kBins);
  if (arc.count == 0) {
    return bound_;
  }
  float* reached = reached_.data() + kPad;
  std::fill_n(reached, kPlaces, 0.0F);
  for (int i = 0; i < arc.count; ++i) {
    float* costs = costs_.data() + static_cast<std::size_t>(i) * kPlaces;
    const float* evidence = cells.data() + arc.sector(i) * kBins;
    float before = 0.0F;
    for (std::size_t bin = 0; bin < kBins; ++bin) {
      costs[bin] = reached[bin] + before;
      before += evidence[bin];
    }
    costs[kBins] = reached[kBins] + before;
    std::copy(costs, costs + kPlaces, reached);
    reach();
    reached = reached_.data() + kPad;
  }
  const auto last = static_cast<std::size_t>(arc.count - 1);
  const float* costs = costs_.data() + last * kPlaces;
  auto bin = static_cast<std::size_t>(std::min_element(costs, costs + kPlaces) - costs);
  for (std::size_t place = last; place > 0; --place) {
    bound_[arc.sector(static_cast<int>(place))] = static_cast<int>(bin);
    bin = best_before(place, bin);
  }
  bound_[arc.sector(0)] = static_cast<int>(bin);
  for (int i = arc.count; i < kSectors; ++i) {
    const bool is_nearer_last = i - arc.count < (kSectors - arc.count) / 2;
    bound_[arc.sector(i)] = bound_[arc.sector(is_nearer_last ? arc.count - 1 : 0)];
  }
  return bound_;
}

}  // namespace berm
