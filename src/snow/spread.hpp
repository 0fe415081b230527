#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "near_points.hpp"

namespace berm {

/// How evenly marks are spread over the directions that a sensor sees: snow falls everywhere, while the points that a
/// clear scan shows alone (edges, twigs, the machine's own parts) come in heaps.
class Spread {
 public:
  explicit Spread(const NearPoints& near);

  void add(std::uint32_t sector) { ++marks_[sector]; }
  /// 1: as even as chance among the sectors that returns come from; towards 0: heaped. Less than two marks are even.
  [[nodiscard]] double evenness() const;

 private:
  std::array<std::uint32_t, NearPoints::kSectors> marks_{};
  double seen_;
};

}  // namespace berm
