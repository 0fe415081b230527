#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include "berm/core/label.hpp"
#include "berm/core/point_cloud.hpp"
#include "berm/core/pose.hpp"
#include "berm/core/series.hpp"
#include "berm/geometry/height_grid.hpp"

namespace berm {

/// Slope of the ground ahead, relative to base_link. Positive: uphill; a fall to the right is positive cross-fall.
struct SlopeAhead {
  double slope_rad = 0.0;
  double slope_sigma_rad = 0.0;
  std::optional<double> cross_fall_rad;  ///< none: the method does not say, or cannot
  double cross_fall_sigma_rad = 0.0;
};

/// A place on the boundary of the piste, in base_link.
struct BoundaryPoint {
  float x_m = 0.0F;
  float y_m = 0.0F;
  float z_m = 0.0F;
  float confidence = 0.0F;  ///< 0..1
};

/// Part of the firing order that a method took for one obstacle.
struct Envelope {
  std::size_t first = 0;
  std::size_t last = 0;
};

/// What earlier stages know of a scan.
struct PisteInput {
  PointsView points;              ///< frame of the sensor, firing order
  std::span<const Label> labels;  ///< one per point: no_return, falling_snow, unlabeled (invalid), drivable (ground),
                                  ///< obstacle (anything else)
  SeriesView series;              ///< as `points`, gaps closed
  const HeightGrid* surface = nullptr;  ///< the ground
  Pose T_base_sensor;
};

/// Spans are valid until the next call of `process`.
struct PisteResult {
  std::span<const Label> labels;        ///< those of the input, with ground split into drivable and terrain
  std::optional<SlopeAhead> slope;      ///< none: unknown
  std::span<const BoundaryPoint> left;  ///< from near to far; empty: not found
  std::span<const BoundaryPoint> right;
  std::optional<double> obstacle_ahead_m;  ///< along x of base_link to the nearest obstacle in the machine's way
  std::span<const std::uint8_t> steps;     ///< one per point: 1 for a step of the waveform; empty: the method has none
  std::span<const Envelope> envelopes;
};

/// Says where the piste is, scan by scan. Keeps scratch memory between calls and nothing else.
class PisteSegmenter {
 public:
  PisteSegmenter() = default;
  PisteSegmenter(const PisteSegmenter&) = delete;
  PisteSegmenter& operator=(const PisteSegmenter&) = delete;
  virtual ~PisteSegmenter() = default;

  /// Whether `process` looks at `PisteInput::series`.
  [[nodiscard]] virtual bool needs_series() const = 0;
  [[nodiscard]] virtual PisteResult process(const PisteInput& input) = 0;
};

}  // namespace berm
