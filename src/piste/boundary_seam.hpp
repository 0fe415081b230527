#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "bearing_grid.hpp"

namespace berm {

/// The boundary as the cheapest seam through the bearing grid, one bin per sector: before it what speaks against
/// piste counts as cost, and from sector to sector it may jump, at a price.
class BoundarySeam {
 public:
  /// `jump_cost`: per bin of a jump between neighbouring sectors, up to `max_jump_bins` of it.
  BoundarySeam(double jump_cost, int max_jump_bins);

  /// First bin off the piste for each of the sectors. `cells`: evidence, all bins of a sector together; `seen`: 1 for
  /// sectors that hold any. Sectors in the widest gap of unseen ones take their nearest neighbour's. Valid until the
  /// next call; kBins everywhere if nothing was seen.
  [[nodiscard]] std::span<const int> find(std::span<const float> cells, std::span<const std::uint8_t> seen);

  /// Sectors of the last call from the first to the last that was seen, in the order of bearing; the first may be
  /// above the last where the gap does not lie behind.
  struct Arc {
    int first = 0;
    int count = 0;
  };
  [[nodiscard]] Arc arc() const { return arc_; }

 private:
  void step(std::span<const float> cells, std::size_t place);

  float jump_cost_;
  float max_jump_cost_;
  Arc arc_;
  std::vector<float> cost_;         ///< of the best seam that ends in a bin
  std::vector<float> reached_;      ///< of reaching a bin from the sector before
  std::vector<std::uint8_t> from_;  ///< bin in the sector before, for each sector of the arc and bin
  std::vector<int> bound_;
};

}  // namespace berm
