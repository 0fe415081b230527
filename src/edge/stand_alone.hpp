#pragma once

#include <cstdint>
#include <span>

#include "road_divide.hpp"

namespace berm {

/// A toe on the map.
struct ToePlace {
  float x_m = 0.0F;
  float y_m = 0.0F;
  bool left = false;
  std::uint16_t supporters = 0;  ///< toes of the same side nearby, on other traces
  float along_x = 0.0F;          ///< direction to the nearest of these, a unit vector; 0: there is none
  float along_y = 0.0F;
};

/// Fills in the supporters.
void find_supporters(std::span<ToePlace> toes);

/// Whether a toe without supporters stands on the road alone, and the edge runs behind it: a stone, the wheel of a
/// truck, a heap.
[[nodiscard]] bool stands_alone(const ToePlace& toe, std::span<const ToePlace> toes, float min_radius_m);

}  // namespace berm
