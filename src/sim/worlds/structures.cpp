#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "mesh_builder.hpp"
#include "things.hpp"

namespace berm::sim {
namespace {

constexpr double kPylonEvery_m = 55.0;
constexpr double kPylonHeight_m = 11.0;
/// Ropes keep this far above the ground.
constexpr double kClearance_m = 7.0;
constexpr double kHalfCrossbar_m = 2.6;
constexpr double kRopeRadius_m = 0.025;
constexpr int kRopePieces = 6;
/// Share of the span that a rope sags.
constexpr double kSag = 0.02;
constexpr Material kSteelPole{Surface::metal, truth::kPole};

struct Pylon {
  Eigen::Vector3d foot_m;
  double height_m;
};

/// Middle of the two ropes between two pylons, at share t.
Eigen::Vector3d rope_at(const Pylon& from, const Pylon& to, double t) {
  const Eigen::Vector3d low = from.foot_m + Eigen::Vector3d(0, 0, from.height_m);
  const Eigen::Vector3d high = to.foot_m + Eigen::Vector3d(0, 0, to.height_m);
  return low + t * (high - low) - Eigen::Vector3d(0, 0, 4.0 * kSag * (high - low).norm() * t * (1.0 - t));
}

/// Makes pylons higher where the ropes would come too near to the ground.
void clear_ground(const Terrain& terrain, std::vector<Pylon>& pylons) {
  for (std::size_t i = 1; i < pylons.size(); ++i) {
    double missing = 0.0;
    for (double t = 0.05; t < 1.0; t += 0.05) {
      const Eigen::Vector3d rope = rope_at(pylons[i - 1], pylons[i], t);
      missing = std::max(missing, terrain.at(rope.x(), rope.y()).height_m + kClearance_m - rope.z());
    }
    pylons[i - 1].height_m += missing;
    pylons[i].height_m += missing;
  }
}

void add_pylon(MeshBuilder& builder, const Pylon& pylon, double yaw_rad) {
  const double top = pylon.height_m;
  builder.set_frame(upright_frame(pylon.foot_m, yaw_rad));
  builder.set_material({Surface::concrete, truth::kPole});
  builder.box({-0.9, -0.9, -1.5}, {0.9, 0.9, 0.4});
  builder.set_material(kSteelPole);
  builder.rod({0, 0, 0.3}, {0, 0, top}, 0.45, 0.28, 12);
  builder.box({-0.2, -kHalfCrossbar_m, top - 0.5}, {0.2, kHalfCrossbar_m, top - 0.2});
  for (const double y : {-kHalfCrossbar_m, kHalfCrossbar_m}) {
    builder.box({-1.2, y - 0.12, top - 0.25}, {1.2, y + 0.12, top});
  }
}

void add_ropes(MeshBuilder& builder, const Pylon& from, const Pylon& to, double yaw_rad) {
  builder.set_frame(Eigen::Isometry3d::Identity());
  builder.set_material(kSteelPole);
  for (const double y : {-kHalfCrossbar_m, kHalfCrossbar_m}) {
    const Eigen::Vector3d aside(-y * std::sin(yaw_rad), y * std::cos(yaw_rad), 0.0);
    for (int i = 0; i < kRopePieces; ++i) {
      builder.rod(rope_at(from, to, static_cast<double>(i) / kRopePieces) + aside,
                  rope_at(from, to, static_cast<double>(i + 1) / kRopePieces) + aside, kRopeRadius_m, kRopeRadius_m, 4);
    }
  }
}

/// A house with a gable roof, x along its ridge.
void add_house(MeshBuilder& builder, double length_m, double width_m, double wall_m) {
  const double half = 0.5 * width_m;
  builder.set_material({Surface::concrete, truth::kBuilding});
  builder.box({-0.5 * length_m, -half, -3.0}, {0.5 * length_m, half, wall_m});
  builder.set_material({Surface::metal, truth::kBuilding});
  const double eaves = half + 0.6;
  const double ridge = wall_m + 0.55 * half;
  const double end = 0.5 * length_m + 0.5;
  const double low = wall_m - 0.2;
  const Eigen::Vector3d a(-end, -eaves, low);
  const Eigen::Vector3d b(end, -eaves, low);
  const Eigen::Vector3d c(end, eaves, low);
  const Eigen::Vector3d d(-end, eaves, low);
  const Eigen::Vector3d e(-end, 0.0, ridge);
  const Eigen::Vector3d f(end, 0.0, ridge);
  builder.quad(a, b, f, e);
  builder.quad(c, d, e, f);
  builder.triangle(b, c, f);
  builder.triangle(d, a, e);
  builder.quad(d, c, b, a);
}

}  // namespace

void add_lift(const Site& site, TriangleMesh& mesh) {
  if (!site.plan.things.lift) {
    return;
  }
  // Straight, from beside the start to beside the end of the route.
  Random random = random_of(site, ThingRandom::lift);
  const double side = random.chance(0.5) ? 1.0 : -1.0;
  const double beyond = random.uniform(14.0, 24.0);
  const Eigen::Vector3d from = roadside(site, -40.0, side, beyond).ground_m;
  const Eigen::Vector3d to = roadside(site, site.plan.route.length_m + 40.0, side, beyond).ground_m;
  const double yaw = std::atan2(to.y() - from.y(), to.x() - from.x());
  const int spans = std::max(1, static_cast<int>(std::hypot(to.x() - from.x(), to.y() - from.y()) / kPylonEvery_m));
  MeshBuilder builder(mesh);
  std::vector<Pylon> pylons;
  for (int i = 0; i <= spans; ++i) {
    const Eigen::Vector3d place = from + (to - from) * (static_cast<double>(i) / spans);
    const GroundSample ground = site.terrain.at(place.x(), place.y());
    if (ground.inside_m > -2.5) {
      continue;
    }
    pylons.push_back({{place.x(), place.y(), ground.height_m}, kPylonHeight_m});
  }
  clear_ground(site.terrain, pylons);
  for (std::size_t i = 0; i < pylons.size(); ++i) {
    add_pylon(builder, pylons[i], yaw);
    if (i > 0) {
      add_ropes(builder, pylons[i - 1], pylons[i], yaw);
    }
  }
}

void add_buildings(const Site& site, TriangleMesh& mesh) {
  const double every = site.plan.things.building_every_m;
  if (every <= 0.0) {
    return;
  }
  MeshBuilder builder(mesh);
  Random random = random_of(site, ThingRandom::buildings);
  for (double s = every * random.uniform(0.1, 0.6); s < site.plan.route.length_m;
       s += every * random.uniform(0.6, 1.4)) {
    const double length = random.uniform(7.0, 16.0);
    const double width = random.uniform(5.0, 10.0);
    const double half_diagonal = 0.5 * std::hypot(length, width);
    const double beyond = half_diagonal + random.uniform(3.0, 14.0);
    const double side = random.chance(0.5) ? 1.0 : -1.0;
    const RoadsidePlace place = roadside(site, s, side, beyond);
    if (place.inside_m > -half_diagonal - 1.5) {
      continue;
    }
    builder.set_frame(upright_frame(place.ground_m, place.heading_rad + random.uniform(-0.4, 0.4)));
    add_house(builder, length, width, random.uniform(2.8, 6.0));
  }
}

}  // namespace berm::sim
