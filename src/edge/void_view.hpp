#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "berm/geometry/bearing_grid.hpp"
#include "berm/geometry/traces.hpp"

namespace berm {

/// Where beams met nothing: beyond the lip of a slope that they fly over.
class VoidView {
 public:
  /// What lies `min_drop_m` below the road, or deeper, is not there.
  void process(const Traces& traces, std::span<const float> height_m, float min_drop_m);
  /// Whether a trace that is walked around the sensor from `before` ends at `end` because there is nothing behind: in
  /// the directions that it would go on in, nothing as far or farther is seen; what lies nearer is, at first: the field
  /// of view goes on.
  [[nodiscard]] bool ends_at(const Traces& traces, std::size_t before, std::size_t end) const;

 private:
  static constexpr std::size_t kSectors = bearing_grid::kSectors;

  bearing_grid::SectorTable sectors_;
  std::array<float, kSectors> farthest2_{};  ///< squared range on the map; 0: nothing, 1e12: nobody sees
};

}  // namespace berm
