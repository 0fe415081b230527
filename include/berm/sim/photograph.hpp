#pragma once

#include <cstdint>
#include <vector>

#include <Eigen/Core>

#include "berm/sim/ray_caster.hpp"
#include "berm/sim/world.hpp"

namespace berm::sim {

/// Where a picture of a world is taken from.
struct Camera {
  Eigen::Vector3d eye_m = Eigen::Vector3d::Zero();
  Eigen::Vector3d target_m = Eigen::Vector3d::UnitX();  ///< seen in the middle; not the eye, nor straight above it
  double width_rad = 1.1;                               ///< angle that the picture is wide
  int width_px = 1280;
  int height_px = 720;
  double time_s = 0.0;  ///< places what moves
};

/// Behind and above the place `along_m` of the route of `world`, looking along it.
[[nodiscard]] Camera camera_behind(const World& world, double along_m);

/// A picture, 8 bits red, green and blue, rows from the top.
struct Photograph {
  int width_px = 0;
  int height_px = 0;
  std::vector<std::uint8_t> rgb;
};

/// A clear day's picture of what beams would meet: colours by surface, sun and shade, haze; drivable ground tinted and
/// its edge drawn. Same picture for any number of threads.
[[nodiscard]] Photograph photograph(const RayCaster& caster, const Camera& camera, std::size_t threads);

}  // namespace berm::sim
