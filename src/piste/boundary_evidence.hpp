#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "berm/geometry/bearing_grid.hpp"
#include "berm/geometry/level_points.hpp"
#include "berm/piste/boundary_piste.hpp"
#include "piste_surface.hpp"
#include "trace_windows.hpp"

namespace berm {

/// What speaks for and against piste in each cell of the bearing grid: the logarithm of how much likelier the windows
/// and obstacles in it are off the piste than on it. All bins of a sector together.
class BoundaryEvidence {
 public:
  explicit BoundaryEvidence(const BoundaryPisteConfig& config);

  /// Takes the windows in: their cells, and how rough snow as near as the machine's own way is here.
  void set_windows(const TraceWindows& windows, const LevelPoints& level, bool is_radial,
                   const bearing_grid::SectorTable& sectors);
  /// `obstacles`: the points that are some.
  void set_obstacles(std::span<const std::uint32_t> obstacles, const LevelPoints& level,
                     const bearing_grid::SectorTable& sectors);

  /// Fits the surface to the windows nearer than `range_m`.
  void fit_near(const TraceWindows& windows, float range_m, PisteSurface& surface);
  /// Fits it to those before the boundary, the last surface in mind: `bound` has the first bin off the piste for every
  /// sector.
  void fit_inside(const TraceWindows& windows, std::span<const int> bound, PisteSurface& surface);
  /// Weighs the windows against the surface that was fitted last.
  void weigh(const TraceWindows& windows, const PisteSurface& surface);

  [[nodiscard]] std::span<const float> cells() const { return cells_; }
  /// From the first to the last sector that holds a window; cells of others mean nothing.
  [[nodiscard]] const bearing_grid::Arc& arc() const { return arc_; }

 private:
  void adapt(const TraceWindows& windows);
  void weigh_windows(const TraceWindows& windows);

  BoundaryPisteConfig config_;
  PisteSurface::Noise noise_;
  float wander_ = 0.0F;  ///< of the slope of groomed snow, typical
  std::vector<std::uint8_t> sector_;
  std::vector<std::uint8_t> bin_;
  std::vector<std::uint8_t> inside_;
  std::vector<float> expected_m2_;      ///< variance of the heights in a window of groomed snow
  std::vector<float> height_residual_;  ///< of windows, m
  std::vector<float> slope_residual_;
  std::vector<float> scratch_;
  std::vector<float> cells_;
  std::vector<float> obstacles_;
  std::vector<float> weights_;      ///< of windows, log likelihood ratios
  std::vector<std::uint8_t> seen_;  ///< sectors with a window
  bearing_grid::Arc arc_;
};

}  // namespace berm
