#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "berm/geometry/bearing_grid.hpp"

namespace berm {

/// The boundary as the cheapest seam through the bearing grid, one bin per sector: before it what speaks against
/// piste counts as cost, and from sector to sector it may jump, at a price.
class BoundarySeam {
 public:
  /// `jump_cost`: per bin of a jump between neighbouring sectors, up to `max_jump_bins` of it.
  BoundarySeam(double jump_cost, int max_jump_bins);

  /// First bin off the piste for each of the sectors. `cells`: evidence, all bins of a sector together; `arc`: sectors
  /// that hold any. Those outside take their nearest neighbour's. Valid until the next call; kBins everywhere if the
  /// arc is empty.
  [[nodiscard]] std::span<const int> find(std::span<const float> cells, const bearing_grid::Arc& arc);

 private:
  void reach();
  [[nodiscard]] std::size_t best_before(std::size_t place, std::size_t bin) const;

  float jump_cost_;
  std::size_t max_jump_bins_;
  std::vector<float> costs_;    ///< of the best seam up to a sector of the arc that ends in a bin, sector by sector
  std::vector<float> reached_;  ///< of the best seam up to the sector before, with the jump to a bin
  std::vector<float> spare_;
  std::vector<int> bound_;
};

}  // namespace berm
