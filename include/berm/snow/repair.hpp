#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "berm/core/point_cloud.hpp"
#include "berm/core/series.hpp"

namespace berm {

/// Closes the gaps of a scan's time series (P eq. 1): each run of beams that met a flake or nothing is replaced by
/// points equally spaced on the line between its neighbours; a run at an end repeats the neighbour. Keeps its memory.
class SeriesRepair {
 public:
  /// `falling`: one per point, 1 for a flake. NaN and absurd points are gaps as well. A scan without a single point
  /// to go by comes back as zeros, all interpolated. The result is valid until the next call.
  [[nodiscard]] SeriesView process(const PointsView& points, std::span<const std::uint8_t> falling);

 private:
  std::vector<float> x_;
  std::vector<float> y_;
  std::vector<float> z_;
  std::vector<std::uint8_t> interpolated_;
};

}  // namespace berm
