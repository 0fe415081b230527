#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

#include "berm/core/point_cloud.hpp"
#include "berm/core/pose.hpp"

/// Scans of small made worlds with exact truth, for tests and benchmarks. The simulator proper is another matter; this
/// one has no effects but range noise, and no dependency but core.
namespace berm::test {

/// An upright box or, with `round`, an upright cylinder around the same centre; stands on the terrain.
struct Thing {
  double x_m = 0.0;
  double y_m = 0.0;
  double half_length_m = 0.5;  ///< along x; the radius of a cylinder
  double half_width_m = 0.5;   ///< along y
  double height_m = 1.0;
  double clearance_m = 0.0;  ///< gap below it, as under a vehicle
  bool round = false;
};

struct World {
  std::function<double(double x_m, double y_m)> terrain_m = [](double, double) { return 0.0; };
  std::vector<Thing> things;
};

/// Directions of the beams in the frame of the sensor, in firing order.
struct Beams {
  std::vector<Eigen::Vector3d> directions;
  std::vector<std::uint16_t> rings;  ///< empty where the sensor has none
};

/// `rings` lasers spread evenly over the elevations, fired column by column over a full turn.
[[nodiscard]] Beams spinning_beams(int rings, double min_elevation_deg, double max_elevation_deg, int columns);
/// Rosette of two counter-rotating prisms within a circular field of view around +x.
[[nodiscard]] Beams rosette_beams(double field_of_view_deg, int count);

struct MadeScan {
  PointCloud cloud;              ///< in the frame of the sensor; beams that met nothing are (0, 0, 0)
  std::vector<bool> is_terrain;  ///< truth, one per point
};

struct CastOptions {
  double range_noise_m = 0.02;
  double max_range_m = 120.0;
  std::uint32_t seed = 1;
};

/// `T_world_sensor` places the sensor; z up in the world.
[[nodiscard]] MadeScan cast(const World& world, const Beams& beams, const Pose& T_world_sensor,
                            const CastOptions& options = {});

/// A pose `height_m` above the terrain at the origin of `world`, turned by roll and pitch (nose down positive).
[[nodiscard]] Pose standing_at_origin(const World& world, double height_m, double pitch_deg = 0.0,
                                      double roll_deg = 0.0);

/// A street-like plain with cars, walls, poles and low mounds, the same for the same seed.
[[nodiscard]] World made_street(std::uint32_t seed);

}  // namespace berm::test
