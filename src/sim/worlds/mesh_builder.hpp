#pragma once

#include <vector>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "berm/sim/world.hpp"

namespace berm::sim {

/// Puts simple bodies into a mesh, each in a frame of its own. Closed bodies have their front faces outside.
class MeshBuilder {
 public:
  explicit MeshBuilder(TriangleMesh& mesh) : mesh_(mesh) {}

  void set_frame(const Eigen::Isometry3d& T_mesh_body) { T_mesh_body_ = T_mesh_body; }
  void set_material(const Material& material) { material_ = material; }

  void triangle(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c);
  /// Flat or nearly so; counter-clockwise from the front.
  void quad(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c, const Eigen::Vector3d& d);
  void box(const Eigen::Vector3d& low, const Eigen::Vector3d& high);
  /// A convex outline in the x-z plane, counter-clockwise as seen from -y, between two values of y.
  void extrude(const std::vector<Eigen::Vector2d>& outline_xz, double low_y, double high_y);
  /// A closed cylinder (or frustum) from `from` to `to`.
  void rod(const Eigen::Vector3d& from, const Eigen::Vector3d& to, double radius_from, double radius_to, int sides);
  /// A closed cone on its base, upright.
  void cone(const Eigen::Vector3d& base, double radius, double height, int sides, double turn_rad);

 private:
  std::uint32_t add_vertex(const Eigen::Vector3d& p);
  void add_triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c);

  TriangleMesh& mesh_;
  Eigen::Isometry3d T_mesh_body_ = Eigen::Isometry3d::Identity();
  Material material_;
};

/// Frame on the ground at a place, upright, x along `yaw_rad`.
[[nodiscard]] Eigen::Isometry3d upright_frame(const Eigen::Vector3d& origin_m, double yaw_rad);

/// Appends all of `part`, moved by `T_mesh_part`.
void append_mesh(TriangleMesh& mesh, const TriangleMesh& part, const Eigen::Isometry3d& T_mesh_part);

}  // namespace berm::sim
