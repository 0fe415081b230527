#pragma once

#include "base_terrain.hpp"
#include "berm/sim/world_config.hpp"
#include "noise.hpp"

namespace berm::sim {

/// Benches of a mine around its road: rock wall on one side, drop on the other. Added to the natural ground.
struct PitShape {
  double wall_side = 1.0;    ///< +1: wall to the left of the road
  double wall_from_m = 8.0;  ///< where it begins, beyond the edge of the road
  double wall_height_m = 12.0;
  double wall_slope = 2.2;
  double drop_from_m = 7.0;
  double drop_height_m = 12.0;
  double drop_slope = 1.2;
  SmoothRaster left_width_m;
  SmoothRaster right_width_m;

  /// `left_m`: signed distance from the line of the road.
  [[nodiscard]] double height_m(double x_m, double y_m, double left_m, const PlaneNoise& noise) const;
  /// Whether a place is bare rock.
  [[nodiscard]] bool is_rock(double x_m, double y_m, double left_m) const;
};

}  // namespace berm::sim
