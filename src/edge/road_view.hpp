#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "berm/geometry/bearing_grid.hpp"
#include "berm/geometry/traces.hpp"

namespace berm {

/// How far the road can be seen from the sensor in each direction: up to the first thing that stands on it.
class RoadView {
 public:
  static constexpr std::size_t kSectors = bearing_grid::kSectors;

  void clear();
  /// Whatever is high above the road ends the view.
  void add_high(const Traces& traces, std::span<const float> height_m);
  void add(float x_m, float y_m);
  /// Whether the view ends well before a place.
  [[nodiscard]] bool hides(float x_m, float y_m) const;
  [[nodiscard]] std::size_t sector_of(float x_m, float y_m) const { return sectors_.of(x_m, y_m); }

 private:
  bearing_grid::SectorTable sectors_;
  std::array<float, kSectors> range2_{};
};

}  // namespace berm
