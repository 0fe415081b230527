#pragma once

#include <cstddef>
#include <vector>

#include "berm/geometry/traces.hpp"

namespace berm {

/// Short pieces of traces, each with the line that fits its heights best. One entry per window.
struct TraceWindows {
  std::vector<float> x;  ///< m, levelled frame, the mean of the points
  std::vector<float> y;
  std::vector<float> z;
  std::vector<float> along_x;  ///< direction of the window on the map, a unit vector
  std::vector<float> along_y;
  std::vector<float> slope;        ///< rise per metre along it
  std::vector<float> variance_m2;  ///< of the heights about the line
  std::vector<float> length_m;     ///< from the first point to the last, on the map
  std::vector<float> nominal_m;    ///< what it should be long at its range
  std::vector<float> range_m;      ///< of the mean, from the origin, on the map

  [[nodiscard]] std::size_t size() const { return x.size(); }
  void resize(std::size_t size);
};

/// Cuts traces into windows of `window_m`, longer in proportion to the range beyond 20 times that, of four points at
/// least. Reuses the memory of `windows`.
void cut_windows(const Traces& traces, double window_m, TraceWindows& windows);

}  // namespace berm
