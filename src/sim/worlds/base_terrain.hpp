#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "berm/geometry/grid2d.hpp"
#include "berm/sim/world.hpp"

namespace berm::sim {

/// A smooth surface over a raster: uniform bicubic B-spline, clamped outside.
class SmoothRaster {
 public:
  SmoothRaster() = default;
  /// `value(x, y)` is asked at every node of a raster over `area` with `cell_m` between nodes.
  SmoothRaster(const Area& area, double cell_m, const std::function<double(double, double)>& value);

  [[nodiscard]] double at(double x_m, double y_m) const;
  /// Adds `by_m` to all values.
  void raise(double by_m);
  [[nodiscard]] bool empty() const { return values_.empty(); }

 private:
  Area area_;
  double cell_m_ = 1.0;
  int columns_ = 0;
  int rows_ = 0;
  std::vector<float> values_;
};

/// A place that the natural ground passes through, with its slopes there.
struct GroundKnot {
  double x_m = 0.0;
  double y_m = 0.0;
  double z_m = 0.0;
  double slope_x = 0.0;
  double slope_y = 0.0;
};

/// Smooth ground through knots, going on with their slopes away from them (Shepard's method with planes, Franke and
/// Nielson 1980).
[[nodiscard]] double ground_between(const std::vector<GroundKnot>& knots, double x_m, double y_m);

}  // namespace berm::sim
