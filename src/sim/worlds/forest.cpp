#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include "buckets.hpp"
#include "mesh_builder.hpp"
#include "natural_ground.hpp"
#include "things.hpp"

namespace berm::sim {
namespace {

/// Trees keep this far from the edges: berms and a strip that is cut clear.
constexpr double kClear_m = 5.0;
/// And from other things, which also clears a lane under a lift.
constexpr double kTreesApart_m = 1.8;
/// Glades and thickets, from one to the next.
constexpr double kGladeWave_m = 110.0;
/// No tree stands on steeper ground.
constexpr double kMostSlope = 1.0;
/// Every fifth tree or so is no spruce.
constexpr double kBroadShare = 0.2;

constexpr Material kBark{Surface::bark, truth::kVegetation};
constexpr Material kCrown{Surface::foliage, truth::kVegetation};

void add_spruce(MeshBuilder& builder, double height_m, Random& random) {
  const double clear = height_m * random.uniform(0.06, 0.22);
  const double radius = height_m * random.uniform(0.13, 0.2);
  builder.set_material(kBark);
  builder.rod({0, 0, -0.6}, {0, 0, 0.5 * height_m}, 0.016 * height_m + 0.04, 0.008 * height_m + 0.02, 6);
  builder.set_material(kCrown);
  // Three cones into each other look ragged, as spruces do.
  for (int i = 0; i < 3; ++i) {
    const double share = i / 3.0;
    const double base = clear + share * (height_m - clear);
    const double top = i == 2 ? height_m : std::min(height_m, base + 0.55 * (height_m - clear));
    builder.cone({0, 0, base}, radius * (1.0 - 0.72 * share), top - base, 7, random.uniform(0.0, 1.0));
  }
}

void add_broad_tree(MeshBuilder& builder, double height_m, Random& random) {
  const double clear = height_m * random.uniform(0.2, 0.35);
  const double radius = height_m * random.uniform(0.2, 0.3);
  builder.set_material(kBark);
  builder.rod({0, 0, -0.6}, {0, 0, 0.6 * height_m}, 0.02 * height_m + 0.04, 0.008 * height_m + 0.02, 6);
  builder.set_material(kCrown);
  const double waist = clear + 0.45 * (height_m - clear);
  builder.rod({0, 0, clear}, {0, 0, waist}, 0.45 * radius, radius, 8);
  builder.rod({0, 0, waist + 0.01}, {0, 0, height_m}, radius, 0.3 * radius, 8);
}

/// Distance beyond the nearest edge of any run.
double beyond_edges(const BuiltTerrain& terrain, double x_m, double y_m) {
  double beyond = 1e9;
  for (const Run& run : terrain.runs()) {
    const RoutePlace place = run.route.nearest(x_m, y_m);
    const RoutePoint at = run.route.at(place.s_m);
    const double edge = place.left_m > 0.0 ? at.left_m : at.right_m;
    beyond = std::min(beyond, std::hypot(std::max(0.0, std::abs(place.left_m) - edge), place.beyond_m));
  }
  return beyond;
}

/// Ground that something else covers already.
struct Covered {
  double x_m = 0.0;
  double y_m = 0.0;
  double reach_m = 0.0;
};

Buckets<Covered> find_covered(const TriangleMesh& mesh) {
  std::vector<Covered> covered;
  for (const auto& triangle : mesh.triangles) {
    const Eigen::Vector2f a = mesh.vertices_m[triangle[0]].head<2>();
    const Eigen::Vector2f b = mesh.vertices_m[triangle[1]].head<2>();
    const Eigen::Vector2f c = mesh.vertices_m[triangle[2]].head<2>();
    const Eigen::Vector2f middle = (a + b + c) / 3.0F;
    const double radius = std::max({(a - middle).norm(), (b - middle).norm(), (c - middle).norm()});
    covered.push_back({middle.x(), middle.y(), radius + kTreesApart_m});
  }
  return Buckets<Covered>(std::move(covered));
}

bool is_covered(const Buckets<Covered>& covered, double x_m, double y_m) {
  bool found = false;
  covered.visit_at(x_m, y_m, [&](const Covered& item) {
    found = found || std::hypot(item.x_m - x_m, item.y_m - y_m) < item.reach_m;
  });
  return found;
}

bool is_steep(const BuiltTerrain& terrain, double x_m, double y_m, double height_m) {
  constexpr double kStep_m = 1.5;
  const double dx = terrain.at(x_m + kStep_m, y_m).height_m - height_m;
  const double dy = terrain.at(x_m, y_m + kStep_m).height_m - height_m;
  return std::hypot(dx, dy) > kMostSlope * kStep_m;
}

}  // namespace

void add_forest(const Site& site, TriangleMesh& mesh) {
  const ThingsConfig& config = site.plan.things;
  if (config.trees_per_hectare <= 0.0) {
    return;
  }
  // A tree per cell, somewhere in it. In glades most are missing, so cells are smaller than the mean.
  const Buckets<Covered> covered = find_covered(mesh);
  const PlaneNoise glades(site.seed, Purpose::things, 50);
  const double cell = std::sqrt(1e4 / (1.6 * config.trees_per_hectare));
  const Area area = area_around(site.terrain.runs(), config.tree_reach_m);
  const auto columns = static_cast<std::uint64_t>((area.max_x_m - area.min_x_m) / cell);
  const auto rows = static_cast<std::uint64_t>((area.max_y_m - area.min_y_m) / cell);
  MeshBuilder builder(mesh);
  for (std::uint64_t row = 0; row < rows; ++row) {
    for (std::uint64_t column = 0; column < columns; ++column) {
      Random random = random_of(site, ThingRandom::forest, row * columns + column);
      const double x = area.min_x_m + cell * (static_cast<double>(column) + random.uniform());
      const double y = area.min_y_m + cell * (static_cast<double>(row) + random.uniform());
      if (!random.chance(smooth_step(-1.2, 0.6, glades.fractal(x, y, kGladeWave_m, 2)))) {
        continue;
      }
      const double beyond = beyond_edges(site.terrain, x, y);
      if (beyond < kClear_m || beyond > config.tree_reach_m || is_covered(covered, x, y)) {
        continue;
      }
      const GroundSample ground = site.terrain.at(x, y);
      if (ground.surface == Surface::rock || is_steep(site.terrain, x, y, ground.height_m)) {
        continue;
      }
      const double height = config.tree_height_m * std::clamp(1.0 + 0.3 * random.normal(), 0.25, 1.7);
      builder.set_frame(upright_frame({x, y, ground.height_m}, random.uniform(0.0, 2.0 * std::numbers::pi)));
      if (random.chance(kBroadShare)) {
        add_broad_tree(builder, 0.8 * height, random);
      } else {
        add_spruce(builder, height, random);
      }
    }
  }
}

}  // namespace berm::sim
