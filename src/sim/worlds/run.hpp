#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "berm/sim/route.hpp"
#include "berm/sim/world.hpp"
#include "buckets.hpp"
#include "noise.hpp"

namespace berm::sim {

/// A dumped heap: a cone at its angle of repose.
struct Heap {
  double x_m = 0.0;
  double y_m = 0.0;
  double reach_m = 0.0;  ///< radius of its foot
  double height_m = 0.0;
  double slope = 0.0;  ///< tangent of the angle of repose
};

/// One side of a run, index 0 left, 1 right.
struct RunSide {
  Profile bank_height_m;  ///< of a snow berm along the edge; empty: none
  Profile bank_slope;     ///< tangent of its flanks
  Profile bank_top_m;     ///< width of its top
  Profile shoulder_m;     ///< how far beyond the edge the ground stays graded
  Profile reach_m;        ///< distance from the line where the run has no influence any more
  Profile stretch;        ///< 1 / sqrt(1 + slope of the edge squared): turns a distance across into one to the edge
};

/// Where a place lies relative to a run.
struct RunPlace {
  RoutePlace place;
  RoutePoint middle;
  double inside_m = 0.0;   ///< signed distance to the edge, bounded below by -kFarOutside_m
  std::size_t side = 0;    ///< nearer side: 0 left, 1 right
  double influence = 0.0;  ///< 1 where the ground is graded, 0 where it is natural
};

constexpr double kFarOutside_m = 60.0;

/// A piste or road around a line: its graded surface, edges and berms. Thread-safe.
struct Run {
  Route route;         ///< with its widths; longer than what is driven
  Profile cross_fall;  ///< tangent, positive: the left is higher
  std::array<RunSide, 2> sides;
  Buckets<Heap> heaps;
  Area box;  ///< what it may influence

  [[nodiscard]] RunPlace place(double x_m, double y_m) const;
  /// Height of the graded surface, also beyond the edges.
  [[nodiscard]] double graded_m(const RunPlace& at) const;
  /// Height of the berm above the ground, 0 inside.
  [[nodiscard]] double berm_m(const RunPlace& at, double x_m, double y_m) const;
  /// Whether a place lies in `box`.
  [[nodiscard]] bool reaches(double x_m, double y_m) const;

  /// Fills `box`, `stretch` and `reach_m` from the route and the shoulders. `blend_m`: over which graded turns to
  /// natural where there is room.
  void finish(double blend_m);
};

/// Place beside the line of a run.
[[nodiscard]] Eigen::Vector2d beside(const RoutePoint& at, double left_m);

}  // namespace berm::sim
