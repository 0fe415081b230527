#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace berm {

/// A scan as a time series without gaps, in firing order and the frame of the sensor: where a beam met nothing or a
/// flake stands a point between its neighbours. Such points carry the waveform only: they are never a feature and
/// never in a map. Valid as long as the owner of the memory.
struct SeriesView {
  std::span<const float> x;                    ///< m
  std::span<const float> y;                    ///< m
  std::span<const float> z;                    ///< m
  std::span<const std::uint8_t> interpolated;  ///< 1: made up from the neighbours

  [[nodiscard]] std::size_t size() const { return x.size(); }
};

}  // namespace berm
