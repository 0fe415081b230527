#pragma once

#include <cmath>
#include <limits>
#include <type_traits>

namespace berm {

/// Nearest float; what is too large for one becomes Inf, as the hardware does it but defined by the language.
template <typename Source>
[[nodiscard]] float to_float(Source value) {
  if constexpr (std::is_same_v<Source, double>) {
    constexpr double kLargest = std::numeric_limits<float>::max();
    if (std::isfinite(value) && std::abs(value) > kLargest) {
      return std::copysign(std::numeric_limits<float>::infinity(), value < 0.0 ? -1.0F : 1.0F);
    }
  }
  return static_cast<float>(value);
}

}  // namespace berm
