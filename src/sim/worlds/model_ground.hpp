#pragma once

#include <optional>
#include <vector>

#include <Eigen/Core>

#include "base_terrain.hpp"
#include "berm/geometry/grid2d.hpp"
#include "berm/io/height_raster.hpp"

namespace berm::sim {

/// The part of an elevation model around a place, which becomes (0, 0, 0). What is not known is filled from the nearest
/// known cells, and is remembered as not known.
class ModelGround {
 public:
  /// `x_m`, `y_m` in the coordinates of the model; `reach_m`: half of the side of what is kept.
  /// Throws Error(invalid_argument) if nothing is known there at all.
  ModelGround(const HeightRaster& model, double x_m, double y_m, double reach_m);

  /// Smoothed by a cubic spline over the cells; in the frame of the world but for its height, which is the model's.
  [[nodiscard]] const SmoothRaster& heights() const { return heights_; }
  /// Adds `by_m` to all heights.
  void raise(double by_m) { heights_.raise(by_m); }
  /// Whether the model knows the ground at a place.
  [[nodiscard]] bool is_known(double x_m, double y_m) const;
  /// Slope (dz/dx, dz/dy) over `base_m`.
  [[nodiscard]] Eigen::Vector2d slope(double x_m, double y_m, double base_m) const;

 private:
  Grid2D<std::uint8_t> known_;
  SmoothRaster heights_;
};

}  // namespace berm::sim
