#pragma once

#include "berm/core/pose.hpp"
#include "berm/sim/terrain.hpp"

namespace berm::sim {

/// Where a machine touches the ground: two tracks, or wheels along two lines.
struct ContactArea {
  double length_m = 4.5;
  double width_m = 3.0;
};

/// The pose of a machine whose middle is above (x, y), with this heading, that rests on the plane through its contact
/// points: z along the normal of the plane, x in the plane and above the heading.
[[nodiscard]] Pose stand_on(const Terrain& terrain, const ContactArea& area, double x_m, double y_m,
                            double heading_rad);

}  // namespace berm::sim
