#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include <Eigen/Core>

#include "berm/geometry/grid2d.hpp"

namespace berm::sim {

/// The line that a machine drives and that a piste or road is built around: a dense line with what is there.
struct RoutePoint {
  double s_m = 0.0;  ///< arc length in the plane
  double x_m = 0.0;
  double y_m = 0.0;
  double z_m = 0.0;          ///< height of the graded surface in the middle
  double heading_rad = 0.0;  ///< counter-clockwise from x; goes on beyond pi instead of jumping
  double left_m = 0.0;       ///< drivable width to the left of the line, up to the toe of the bank or berm
  double right_m = 0.0;      ///< the same to the right
};

/// Where a place lies relative to a route.
struct RoutePlace {
  double s_m = 0.0;
  double left_m = 0.0;    ///< signed distance to the left of the line
  double beyond_m = 0.0;  ///< how far the place lies before the first or behind the last point; 0 between
};

/// A smooth curve: cubic between the points, with their headings as tangents. Thread-safe.
class Route {
 public:
  Route() = default;
  /// At least two points, `s_m` strictly increasing, headings along the line. Throws Error(invalid_argument).
  explicit Route(std::vector<RoutePoint> points);

  [[nodiscard]] double length_m() const;
  /// Interpolated; clamped to the ends. Widths and headings linear, the rest cubic.
  [[nodiscard]] RoutePoint at(double s_m) const;
  /// Gradient of the height along the line, dz/ds.
  [[nodiscard]] double gradient(double s_m) const;
  /// The nearest place of the line. Fast: a grid of the pieces near each cell. Continuous wherever the place is nearer
  /// to the line than the radius of its bends.
  [[nodiscard]] RoutePlace nearest(double x_m, double y_m) const;
  [[nodiscard]] const std::vector<RoutePoint>& points() const { return points_; }

 private:
  /// Consecutive segments with a circle around them.
  struct Piece {
    double x_m = 0.0;
    double y_m = 0.0;
    double radius_m = 0.0;
    std::uint32_t first = 0;
    std::uint32_t last = 0;
  };
  struct Candidate {
    double distance_m = std::numeric_limits<double>::infinity();
    double squared_m2 = std::numeric_limits<double>::infinity();
    std::size_t segment = 0;
    double share = 0.0;
  };

  [[nodiscard]] std::size_t segment_at(double s_m) const;
  [[nodiscard]] Candidate nearest_chord(double x_m, double y_m) const;
  void search_piece(const Piece& piece, double x_m, double y_m, Candidate& best) const;
  void make_grid();
  void make_pieces();
  /// Those of `among` that can be nearest to some place of a cell around (x, y).
  [[nodiscard]] std::vector<std::uint32_t> pieces_near(const std::vector<std::uint32_t>& among, double x_m, double y_m,
                                                       double cell_m) const;

  std::vector<RoutePoint> points_;
  std::vector<Eigen::Vector2d> tangents_;  ///< of unit length, per point
  std::vector<double> gradients_;          ///< dz/ds per point
  std::vector<Piece> pieces_;
  Grid2D<std::array<std::uint32_t, 2>> cells_;  ///< range of `near_` with the pieces that can be nearest
  std::vector<std::uint32_t> near_;
};

}  // namespace berm::sim
