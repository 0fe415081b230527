#pragma once

#include "berm/sim/surface.hpp"

namespace berm::sim {

/// The ground at one place.
struct GroundSample {
  double height_m = 0.0;
  double inside_m = 0.0;  ///< distance to the edge of what is drivable: positive inside, negative outside
  double across_m =
      0.0;  ///< signed distance to the left of the line that was groomed or driven; corduroy lies along it
  Surface surface = Surface::rough_snow;
};

/// The ground of a world as a function of the place. It is the truth: the mesh that beams meet samples it, wheels
/// stand on it, truth grids are written from it. Thread-safe; finite everywhere, also outside of the area.
class Terrain {
 public:
  virtual ~Terrain() = default;
  [[nodiscard]] virtual GroundSample at(double x_m, double y_m) const = 0;
};

}  // namespace berm::sim
