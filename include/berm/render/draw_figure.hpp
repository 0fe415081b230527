#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "berm/core/label.hpp"
#include "berm/core/point_cloud.hpp"
#include "berm/core/series.hpp"
#include "berm/render/color.hpp"
#include "berm/render/draw_scan.hpp"
#include "berm/render/image.hpp"

namespace berm {

/// How often which intensity (0..255) comes back, on a logarithmic scale: of all returns, and of those that are not
/// `Label::falling_snow`. Of `options` count size, background and title.
/// Throws Error(invalid_argument) without intensities or if `labels` has another length (it may be empty), ConfigError
/// as `DrawOptions::check`.
[[nodiscard]] Image draw_histogram(const PointsView& points, std::span<const Label> labels, const DrawOptions& options);

/// From one point to another in firing order, both included.
struct PointRange {
  std::size_t first = 0;
  std::size_t last = 0;
};

/// A scan over its firing order; all spans have the length of `points` or are empty.
struct Waveform {
  PointsView points;
  std::span<const Label> labels;
  SeriesView series;                      ///< the points, gaps closed
  std::span<const std::uint8_t> steps;    ///< 1 for a step
  std::span<const PointRange> envelopes;  ///< stretches that were taken for obstacles
  std::size_t first = 0;                  ///< the stretch that is shown
  std::size_t count = 0;                  ///< 0: all from `first` on
};

/// x and z of the waveform, levelled by `options.T_base_sensor`: the points by their labels, the series without gaps,
/// steps and envelopes. Of `options` count size, background and title beside it.
/// Throws Error(invalid_argument) if lengths differ or nothing is selected, ConfigError as `DrawOptions::check`.
[[nodiscard]] Image draw_waveform(const Waveform& waveform, const DrawOptions& options);

/// One line of a chart.
struct Curve {
  std::string name;  ///< for the legend
  Rgb color;
  std::vector<Eigen::Vector2d> points;  ///< across and up; one that is not finite interrupts the line
};

/// Titles of the axes, with their units.
struct CurveAxes {
  std::string across;
  std::string up;
};

/// Values of at least 0, such as times per scan along a run: later curves lie on earlier ones. Of `options` count size,
/// background and title.
/// Throws Error(invalid_argument) if no point is finite, ConfigError as `DrawOptions::check`.
[[nodiscard]] Image draw_curves(std::span<const Curve> curves, const CurveAxes& axes, const DrawOptions& options);

}  // namespace berm
