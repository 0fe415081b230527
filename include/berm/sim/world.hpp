#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "berm/core/trajectory.hpp"
#include "berm/sim/route.hpp"
#include "berm/sim/surface.hpp"
#include "berm/sim/terrain.hpp"

namespace berm::sim {

/// Triangles with materials, in a frame that its owner names. Front faces are counter-clockwise.
struct TriangleMesh {
  std::vector<Eigen::Vector3f> vertices_m;
  std::vector<std::array<std::uint32_t, 3>> triangles;
  std::vector<Material> materials;  ///< one a triangle
};

/// Something that moves by itself. `T_world_object` is constant before its first and after its last pose.
struct Mover {
  TriangleMesh mesh;  ///< in the frame of the object: origin on the ground in its middle, x forward
  Trajectory T_world_object;
};

/// A cloud of dust behind a wheel or above a road: density in extinctions per metre, Gaussian around its middle.
struct Plume {
  Eigen::Vector3d center_m = Eigen::Vector3d::Zero();
  Eigen::Vector3d sigma_m = Eigen::Vector3d::Ones();
  double extinction_per_m = 0.1;
};

/// True edge of what is drivable, at the toe of the berm or bank.
struct EdgeLine {
  bool left = true;  ///< as seen by who drives the route
  std::vector<Eigen::Vector3d> vertices_m;
};

struct Area {
  double min_x_m = 0.0;
  double min_y_m = 0.0;
  double max_x_m = 0.0;
  double max_y_m = 0.0;
};

/// A world frame is local: origin where the route begins, x east, y north, z up.
struct World {
  std::shared_ptr<const Terrain> terrain;
  Area area;            ///< what the mesh of the terrain covers
  Route route;          ///< what the machine drives
  TriangleMesh things;  ///< all that stands, world frame
  std::vector<Mover> movers;
  std::vector<Plume> plumes;
  std::vector<EdgeLine> edges;
  Eigen::Vector3d origin_m = Eigen::Vector3d::Zero();  ///< of the world frame in the coordinates of the elevation model
};

}  // namespace berm::sim
