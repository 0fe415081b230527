#pragma once

#include <cstddef>
#include <vector>

#include <Eigen/Core>

namespace berm::sim {

/// The line that a machine drives and that a piste or road is built around: a dense polyline with what is there.
struct RoutePoint {
  double s_m = 0.0;  ///< arc length in the plane
  double x_m = 0.0;
  double y_m = 0.0;
  double z_m = 0.0;          ///< height of the graded surface in the middle
  double heading_rad = 0.0;  ///< counter-clockwise from x
  double left_m = 0.0;       ///< drivable width to the left of the line, up to the toe of the bank or berm
  double right_m = 0.0;      ///< the same to the right
};

/// Where a place lies relative to a route.
struct RoutePlace {
  double s_m = 0.0;
  double left_m = 0.0;    ///< signed distance to the left of the line
  double beyond_m = 0.0;  ///< how far the place lies before the first or behind the last point; 0 between
};

class Route {
 public:
  Route() = default;
  /// At least two points, `s_m` strictly increasing.
  explicit Route(std::vector<RoutePoint> points);

  [[nodiscard]] double length_m() const;
  /// Interpolated; clamped to the ends.
  [[nodiscard]] RoutePoint at(double s_m) const;
  /// The nearest place of the line. Fast: a grid of the segments near each cell.
  [[nodiscard]] RoutePlace nearest(double x_m, double y_m) const;
  [[nodiscard]] const std::vector<RoutePoint>& points() const { return points_; }

 private:
  std::vector<RoutePoint> points_;
};

}  // namespace berm::sim
