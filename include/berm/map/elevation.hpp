#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "berm/core/surface.hpp"

namespace berm {

/// The ground in one cell of an elevation raster.
struct ElevationCell {
  std::int32_t column = 0;          ///< floor(x / cell), from the origin of the map
  std::int32_t row = 0;             ///< floor(y / cell)
  double height_m = 0.0;            ///< at the middle of the cell
  std::optional<double> slope_rad;  ///< of the ground around it; none where it has too few neighbours
  double sigma_m = 0.0;             ///< of the points about the ground, robust
  std::uint64_t points = 0;
};

/// Heights of the ground from a map of the surface: per cell the weighted median of what is drivable or terrain, taken
/// along the slope of the ground in the cell, so that neither stalks and stones nor a slope shift it.
class ElevationBuilder {
 public:
  /// `cell_m` is shortened so that a tile of `tile_m` holds a whole number of cells.
  ElevationBuilder(double tile_m, double cell_m);

  [[nodiscard]] double cell_m() const { return cell_m_; }

  /// Each tile once.
  void add_tile(std::span<const SurfacePoint> points);

  /// The cells with ground, by row and column.
  [[nodiscard]] std::vector<ElevationCell> finish();

 private:
  /// What a cell knows by itself.
  struct Ground {
    ElevationCell cell;
    double centroid_x_m = 0.0;  ///< of its points, from the origin of the map
    double centroid_y_m = 0.0;
    bool is_level = true;  ///< no slope was found in the cell: `height_m` is that at the centroid
  };
  struct Sample {
    double x_m = 0.0;
    double y_m = 0.0;
    double z_m = 0.0;
    double weight = 0.0;
    double residual_m = 0.0;
  };

  void add_cell(std::int32_t column, std::int32_t row);

  double cell_m_;
  std::vector<Ground> ground_;
  // Scratch.
  std::vector<Sample> samples_;
};

}  // namespace berm
