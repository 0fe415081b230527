#include "boundary_seam.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>

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

/// Smallest of kPlaces values. Written with vectors because compilers must not look for the least float of a plain loop
/// in another order.
BERM_MULTIVERSION float least_of(const float* values) {
  constexpr std::size_t kLanes = 8;
  using Lanes = float __attribute__((vector_size(kLanes * sizeof(float))));
  Lanes least;
  std::memcpy(&least, values, sizeof(least));
  for (std::size_t i = kPlaces % kLanes; i < kPlaces; i += kLanes) {
    Lanes next;
    std::memcpy(&next, values + i, sizeof(next));
    least = next < least ? next : least;
  }
  std::array<float, kLanes> lanes;  // NOLINT(cppcoreguidelines-pro-type-member-init): filled below
  std::memcpy(lanes.data(), &least, sizeof(least));
  return *std::min_element(lanes.begin(), lanes.end());
}

/// The first place where `costs` are least; `otherwise` if they are no numbers.
std::size_t cheapest_place(const float* costs, std::size_t otherwise) {
  const float* found = std::find(costs, costs + kPlaces, least_of(costs));
  return found < costs + kPlaces ? static_cast<std::size_t>(found - costs) : otherwise;
}

/// costs[from] = before[from] and the price of the jump from there to `bin`.
BERM_MULTIVERSION void add_jumps(const float* __restrict before, std::int32_t bin, std::int32_t max_jump,
                                 float jump_cost, float* __restrict costs) {
  for (std::int32_t from = 0; from < std::int32_t{kPlaces}; ++from) {
    const std::int32_t jump = from > bin ? from - bin : bin - from;
    costs[from] = before[from] + static_cast<float>(jump < max_jump ? jump : max_jump) * jump_cost;
  }
}

/// What a seam costs that ends in each bin: what it cost to get there, and what speaks for piste beyond or against it
/// before.
void add_evidence(const float* evidence, const float* reached, float* costs) {
  float before = 0.0F;
  for (std::size_t bin = 0; bin < kBins; ++bin) {
    costs[bin] = reached[bin] + before;
    before += evidence[bin];
  }
  costs[kBins] = reached[kBins] + before;
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
  const float any = least_of(costs) + static_cast<float>(max_jump_bins_) * jump_cost_;
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
  std::array<float, kPlaces> costs;  // NOLINT(cppcoreguidelines-pro-type-member-init): filled below
  add_jumps(costs_.data() + (place - 1) * kPlaces, static_cast<std::int32_t>(bin),
            static_cast<std::int32_t>(max_jump_bins_), jump_cost_, costs.data());
  const std::size_t cheapest = cheapest_place(costs.data(), bin);
  return costs[cheapest] < costs[bin] ? cheapest : bin;  // no jump rather than one for nothing
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
    add_evidence(evidence, reached, costs);
    std::copy(costs, costs + kPlaces, reached);
    reach();
    reached = reached_.data() + kPad;
  }
  const auto last = static_cast<std::size_t>(arc.count - 1);
  const float* costs = costs_.data() + last * kPlaces;
  std::size_t bin = cheapest_place(costs, kBins);
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
