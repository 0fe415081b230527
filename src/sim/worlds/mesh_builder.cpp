#include "mesh_builder.hpp"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>

namespace berm::sim {

using Eigen::Vector2d;
using Eigen::Vector3d;

std::uint32_t MeshBuilder::add_vertex(const Vector3d& p) {
  mesh_.vertices_m.emplace_back((T_mesh_body_ * p).cast<float>());
  return static_cast<std::uint32_t>(mesh_.vertices_m.size() - 1);
}

void MeshBuilder::add_triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
  mesh_.triangles.push_back({a, b, c});
  mesh_.materials.push_back(material_);
}

void MeshBuilder::triangle(const Vector3d& a, const Vector3d& b, const Vector3d& c) {
  const std::uint32_t first = add_vertex(a);
  add_vertex(b);
  add_vertex(c);
  add_triangle(first, first + 1, first + 2);
}

void MeshBuilder::quad(const Vector3d& a, const Vector3d& b, const Vector3d& c, const Vector3d& d) {
  const std::uint32_t first = add_vertex(a);
  add_vertex(b);
  add_vertex(c);
  add_vertex(d);
  add_triangle(first, first + 1, first + 2);
  add_triangle(first, first + 2, first + 3);
}

void MeshBuilder::box(const Vector3d& low, const Vector3d& high) {
  extrude({{low.x(), low.z()}, {high.x(), low.z()}, {high.x(), high.z()}, {low.x(), high.z()}}, low.y(), high.y());
}

void MeshBuilder::extrude(const std::vector<Vector2d>& outline_xz, double low_y, double high_y) {
  const auto count = static_cast<std::uint32_t>(outline_xz.size());
  const auto first = static_cast<std::uint32_t>(mesh_.vertices_m.size());
  for (const double y : {low_y, high_y}) {
    for (const Vector2d& p : outline_xz) {
      add_vertex({p.x(), y, p.y()});
    }
  }
  for (std::uint32_t i = 1; i + 1 < count; ++i) {
    add_triangle(first, first + i, first + i + 1);
    add_triangle(first + count, first + count + i + 1, first + count + i);
  }
  for (std::uint32_t i = 0; i < count; ++i) {
    const std::uint32_t a = first + i;
    const std::uint32_t b = first + (i + 1) % count;
    add_triangle(a, a + count, b + count);
    add_triangle(a, b + count, b);
  }
}

void MeshBuilder::rod(const Vector3d& from, const Vector3d& to, double radius_from, double radius_to, int sides) {
  const Vector3d axis = (to - from).normalized();
  const Vector3d u =
      (std::abs(axis.z()) < 0.9 ? axis.cross(Vector3d::UnitZ()) : axis.cross(Vector3d::UnitX())).normalized();
  const Vector3d v = axis.cross(u);
  const auto count = static_cast<std::uint32_t>(sides);
  const auto first = static_cast<std::uint32_t>(mesh_.vertices_m.size());
  for (const bool at_end : {false, true}) {
    for (int i = 0; i < sides; ++i) {
      const double angle = 2.0 * std::numbers::pi * i / sides;
      const Vector3d out = std::cos(angle) * u + std::sin(angle) * v;
      add_vertex(at_end ? Vector3d(to + radius_to * out) : Vector3d(from + radius_from * out));
    }
  }
  for (std::uint32_t i = 0; i < count; ++i) {
    const std::uint32_t a = first + i;
    const std::uint32_t b = first + (i + 1) % count;
    add_triangle(a, b, b + count);
    add_triangle(a, b + count, a + count);
  }
  for (std::uint32_t i = 1; i + 1 < count; ++i) {
    add_triangle(first, first + i + 1, first + i);
    add_triangle(first + count, first + count + i, first + count + i + 1);
  }
}

void MeshBuilder::cone(const Vector3d& base, double radius, double height, int sides, double turn_rad) {
  const auto count = static_cast<std::uint32_t>(sides);
  const std::uint32_t tip = add_vertex(base + Vector3d(0.0, 0.0, height));
  for (int i = 0; i < sides; ++i) {
    const double angle = turn_rad + 2.0 * std::numbers::pi * i / sides;
    add_vertex(base + Vector3d(radius * std::cos(angle), radius * std::sin(angle), 0.0));
  }
  for (std::uint32_t i = 0; i < count; ++i) {
    add_triangle(tip, tip + 1 + i, tip + 1 + (i + 1) % count);
  }
  for (std::uint32_t i = 1; i + 1 < count; ++i) {
    add_triangle(tip + 1, tip + 1 + i + 1, tip + 1 + i);
  }
}

Eigen::Isometry3d upright_frame(const Vector3d& origin_m, double yaw_rad) {
  Eigen::Isometry3d frame = Eigen::Isometry3d::Identity();
  frame.translation() = origin_m;
  frame.linear() = Eigen::AngleAxisd(yaw_rad, Vector3d::UnitZ()).toRotationMatrix();
  return frame;
}

void append_mesh(TriangleMesh& mesh, const TriangleMesh& part, const Eigen::Isometry3d& T_mesh_part) {
  const auto offset = static_cast<std::uint32_t>(mesh.vertices_m.size());
  for (const Eigen::Vector3f& vertex : part.vertices_m) {
    mesh.vertices_m.emplace_back((T_mesh_part * vertex.cast<double>()).cast<float>());
  }
  for (const auto& triangle : part.triangles) {
    mesh.triangles.push_back({triangle[0] + offset, triangle[1] + offset, triangle[2] + offset});
  }
  mesh.materials.insert(mesh.materials.end(), part.materials.begin(), part.materials.end());
}

}  // namespace berm::sim
