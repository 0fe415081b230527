#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "bearing_grid.hpp"
#include "berm/core/label.hpp"
#include "berm/piste/boundary_piste.hpp"
#include "level_points.hpp"
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
  /// Marks windows before the boundary: `bound` has the first bin off the piste for every sector.
  [[nodiscard]] std::span<const std::uint8_t> find_inside(std::span<const int> bound);
  /// Marks windows nearer than `range_m`.
  [[nodiscard]] std::span<const std::uint8_t> find_near(const TraceWindows& windows, float range_m);
  /// Weighs windows against the surface. `inside`: as the last call of find_inside or find_near said.
  void weigh(const TraceWindows& windows, const PisteSurface& surface);
  void add_obstacles(std::span<const Label> labels, const LevelPoints& level, const bearing_grid::SectorTable& sectors);

  [[nodiscard]] std::span<const float> cells() const { return cells_; }
  /// 1 for sectors that hold a window.
  [[nodiscard]] std::span<const std::uint8_t> seen() const { return seen_; }
  [[nodiscard]] const PisteSurface::Noise& noise() const { return noise_; }

 private:
  void compare(const TraceWindows& windows, const PisteSurface& surface);
  void adapt(const TraceWindows& windows);
  [[nodiscard]] float weigh_window(const TraceWindows& windows, std::size_t i) const;

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
  std::vector<std::uint8_t> seen_;
};

}  // namespace berm
