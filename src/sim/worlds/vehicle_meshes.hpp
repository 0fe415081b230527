#pragma once

#include "berm/sim/world.hpp"

namespace berm::sim {

/// A machine and the room that it takes. Origin on the ground in its middle, x forward.
struct VehicleModel {
  TriangleMesh mesh;
  double length_m = 0.0;
  double width_m = 0.0;
};

/// A snow groomer: tracks, cab, blade in front, tiller behind.
[[nodiscard]] VehicleModel make_groomer(std::uint16_t truth_id);
/// A rigid haul truck of the 100 t class with raised canopy.
[[nodiscard]] VehicleModel make_haul_truck(std::uint16_t truth_id);
/// `scale`: of its size; 1 is a medium car.
[[nodiscard]] VehicleModel make_car(std::uint16_t truth_id, double scale);

}  // namespace berm::sim
