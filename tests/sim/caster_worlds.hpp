#pragma once

#include <cmath>
#include <functional>
#include <memory>
#include <utility>

#include "berm/sim/world.hpp"

// Small worlds with known answers, for the tests of casting.
namespace berm::sim {

/// A terrain from a function.
class MadeTerrain : public Terrain {
 public:
  explicit MadeTerrain(std::function<GroundSample(double, double)> at) : at_(std::move(at)) {}
  [[nodiscard]] GroundSample at(double x_m, double y_m) const override { return at_(x_m, y_m); }

 private:
  std::function<GroundSample(double, double)> at_;
};

/// z = slope_x x + slope_y y; drivable where |y| < half_width_m; lined along x.
inline std::shared_ptr<const Terrain> plane_terrain(double slope_x, double slope_y, double half_width_m = 5.0,
                                                    Surface surface = Surface::gravel) {
  return std::make_shared<MadeTerrain>([=](double x_m, double y_m) {
    return GroundSample{slope_x * x_m + slope_y * y_m, half_width_m - std::abs(y_m), y_m, surface};
  });
}

/// A road along x between banks of 40 degrees, 1.5 m high, on rolling ground.
inline std::shared_ptr<const Terrain> berm_terrain() {
  return std::make_shared<MadeTerrain>([](double x_m, double y_m) {
    const double middle_m = 3.0 * std::sin(0.03 * x_m);
    const double inside_m = 6.0 - std::abs(y_m - middle_m);
    const double bank_m = std::clamp(-0.84 * inside_m, 0.0, 1.5);
    const double rolling_m = 0.5 * std::sin(0.11 * x_m) + 2.0 * std::sin(0.02 * y_m + 1.0) + 0.1 * x_m;
    return GroundSample{rolling_m + bank_m, inside_m, y_m - middle_m, Surface::gravel};
  });
}

/// A world with nothing but ground, the same mesh everywhere.
inline World world_of(std::shared_ptr<const Terrain> terrain, double half_size_m) {
  World world;
  world.terrain = std::move(terrain);
  world.area = {-half_size_m, -half_size_m, half_size_m, half_size_m};
  return world;
}

inline void add_triangle(TriangleMesh& mesh, const Eigen::Vector3f& a, const Eigen::Vector3f& b,
                         const Eigen::Vector3f& c, const Material& material) {
  const auto first = static_cast<std::uint32_t>(mesh.vertices_m.size());
  mesh.vertices_m.insert(mesh.vertices_m.end(), {a, b, c});
  mesh.triangles.push_back({first, first + 1, first + 2});
  mesh.materials.push_back(material);
}

inline void add_quad(TriangleMesh& mesh, const Eigen::Vector3f& a, const Eigen::Vector3f& b, const Eigen::Vector3f& c,
                     const Eigen::Vector3f& d, const Material& material) {
  add_triangle(mesh, a, b, c, material);
  add_triangle(mesh, a, c, d, material);
}

/// Closed, fronts outside.
inline void add_box(TriangleMesh& mesh, const Eigen::Vector3f& low, const Eigen::Vector3f& high,
                    const Material& material) {
  const auto corner = [&](int i) {
    return Eigen::Vector3f{(i & 1) != 0 ? high.x() : low.x(), (i & 2) != 0 ? high.y() : low.y(),
                           (i & 4) != 0 ? high.z() : low.z()};
  };
  add_quad(mesh, corner(0), corner(2), corner(3), corner(1), material);
  add_quad(mesh, corner(4), corner(5), corner(7), corner(6), material);
  add_quad(mesh, corner(0), corner(1), corner(5), corner(4), material);
  add_quad(mesh, corner(2), corner(6), corner(7), corner(3), material);
  add_quad(mesh, corner(0), corner(4), corner(6), corner(2), material);
  add_quad(mesh, corner(1), corner(3), corner(7), corner(5), material);
}

/// What a slow search over all triangles finds, in double: range, index of the triangle.
inline std::pair<double, std::size_t> slow_cast(const TriangleMesh& mesh, const Eigen::Vector3d& origin_m,
                                                const Eigen::Vector3d& direction) {
  std::pair<double, std::size_t> best{std::numeric_limits<double>::infinity(), 0};
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const Eigen::Vector3d a = mesh.vertices_m[mesh.triangles[i][0]].cast<double>();
    const Eigen::Vector3d b = mesh.vertices_m[mesh.triangles[i][1]].cast<double>();
    const Eigen::Vector3d c = mesh.vertices_m[mesh.triangles[i][2]].cast<double>();
    // Where the ray meets the plane, and on which sides of the three edges that is.
    const Eigen::Vector3d normal = (b - a).cross(c - a);
    const double range_m = normal.dot(a - origin_m) / normal.dot(direction);
    if (!(range_m > 0.0) || range_m >= best.first) {
      continue;
    }
    const Eigen::Vector3d p = origin_m + range_m * direction;
    if (normal.dot((b - a).cross(p - a)) >= 0.0 && normal.dot((c - b).cross(p - b)) >= 0.0 &&
        normal.dot((a - c).cross(p - c)) >= 0.0) {
      best = {range_m, i};
    }
  }
  return best;
}

/// Where a ray first goes below a terrain, by small steps; infinite if nowhere before `end_m`.
inline double slow_cast(const Terrain& terrain, const Eigen::Vector3d& origin_m, const Eigen::Vector3d& direction,
                        double end_m) {
  const auto above_m = [&](double range_m) {
    const Eigen::Vector3d p = origin_m + range_m * direction;
    return p.z() - terrain.at(p.x(), p.y()).height_m;
  };
  constexpr double kStep_m = 0.01;
  for (double range_m = 0.0; range_m < end_m; range_m += kStep_m) {
    if (above_m(range_m) < 0.0) {
      double before_m = range_m - kStep_m;
      double after_m = range_m;
      for (int i = 0; i < 30; ++i) {
        const double middle_m = 0.5 * (before_m + after_m);
        (above_m(middle_m) < 0.0 ? after_m : before_m) = middle_m;
      }
      return after_m;
    }
  }
  return std::numeric_limits<double>::infinity();
}

}  // namespace berm::sim
