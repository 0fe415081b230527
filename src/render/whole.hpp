#pragma once

#include <cmath>

namespace berm {

/// The nearest whole pixel.
inline int whole(double value) {
  return static_cast<int>(std::lround(value));
}

}  // namespace berm
