#pragma once

#include <algorithm>
#include <cmath>
#include <span>

#include "berm/core/label.hpp"

namespace berm {

/// What stands still: falling snow, no-returns, moving things and what nobody labelled tell nothing about the motion.
inline bool is_scenery(Label label) {
  return label == Label::drivable || label == Label::terrain || label == Label::obstacle;
}

/// The last of the points' times, 0 if they have none.
inline double last_time_s(std::span<const float> times_s) {
  float last_s = 0.0F;
  for (const float time_s : times_s) {
    last_s = std::max(last_s, time_s);  // false for NaN
  }
  return std::isfinite(last_s) ? static_cast<double>(last_s) : 0.0;
}

}  // namespace berm
