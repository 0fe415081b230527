#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <vector>

#include "mesh_builder.hpp"
#include "route_course.hpp"
#include "things.hpp"

namespace berm::sim {
namespace {

/// How far from any drivable place things stand at least.
constexpr double kRoadsideClear_m = 0.35;
constexpr double kFenceBeyond_m = 1.6;
constexpr double kFencePostEvery_m = 2.5;
constexpr double kFenceHeight_m = 1.9;
constexpr double kFenceWave_m = 30.0;
/// Things are put up as far as this before and behind the route.
constexpr double kAround_m = 60.0;

constexpr Material kPost{Surface::paint, truth::kPole};
constexpr Material kSteel{Surface::metal, truth::kPole};

double first_s(const Site& site) {
  return std::max(-kAround_m, site.main_run().route.points().front().s_m);
}

double last_s(const Site& site) {
  return std::min(site.plan.route.length_m + kAround_m, site.main_run().route.points().back().s_m);
}

void add_net(MeshBuilder& builder, const RoadsidePlace& from, const RoadsidePlace& to) {
  const Eigen::Vector3d low(0.0, 0.0, 0.08);
  const Eigen::Vector3d high(0.0, 0.0, kFenceHeight_m - 0.1);
  builder.set_material({Surface::net, truth::kFence});
  builder.quad(from.ground_m + low, to.ground_m + low, to.ground_m + high, from.ground_m + high);
}

void add_fence(const Site& site, double side, TriangleMesh& mesh) {
  const double from = first_s(site);
  const auto count = static_cast<std::size_t>((last_s(site) - from) / kFencePostEvery_m);
  const std::vector<double> presence =
      smooth_random(count, kFenceWave_m / kFencePostEvery_m, random_of(site, ThingRandom::fences, side > 0.0 ? 0 : 1));
  std::vector<double> sorted = presence;
  std::sort(sorted.begin(), sorted.end());
  const double share = std::clamp(1.0 - site.plan.things.fence_share, 0.0, 1.0);
  const double threshold =
      share <= 0.0 ? -1e9 : sorted[std::min(count - 1, static_cast<std::size_t>(share * static_cast<double>(count)))];
  MeshBuilder builder(mesh);
  std::optional<RoadsidePlace> before;
  for (std::size_t i = 0; i < count; ++i) {
    const double s = from + kFencePostEvery_m * static_cast<double>(i);
    const RoadsidePlace place = roadside(site, s, side, kFenceBeyond_m);
    if (presence[i] < threshold || place.inside_m > -kRoadsideClear_m) {
      before.reset();
      continue;
    }
    builder.set_material({Surface::metal, truth::kFence});
    builder.rod(place.ground_m - Eigen::Vector3d(0, 0, 0.3), place.ground_m + Eigen::Vector3d(0, 0, kFenceHeight_m),
                0.03, 0.03, 6);
    if (before) {
      add_net(builder, *before, place);
    }
    before = place;
  }
}

}  // namespace

Random random_of(const Site& site, ThingRandom what, std::uint64_t index) {
  return {site.seed, Purpose::things, static_cast<std::uint64_t>(what), index};
}

RoadsidePlace roadside(const Site& site, double s_m, double side, double beyond_m) {
  const RoutePoint at = site.main_run().route.at(s_m);
  const Eigen::Vector2d place = beside(at, side > 0.0 ? at.left_m + beyond_m : -at.right_m - beyond_m);
  const GroundSample ground = site.terrain.at(place.x(), place.y());
  return {{place.x(), place.y(), ground.height_m}, at.heading_rad, ground.inside_m};
}

void add_fences(const Site& site, TriangleMesh& mesh) {
  if (site.plan.things.fence_share > 0.0) {
    add_fence(site, 1.0, mesh);
    add_fence(site, -1.0, mesh);
  }
}

void add_poles(const Site& site, TriangleMesh& mesh) {
  if (site.plan.things.pole_every_m <= 0.0) {
    return;
  }
  MeshBuilder builder(mesh);
  builder.set_material(kPost);
  Random random = random_of(site, ThingRandom::poles);
  double side = 1.0;
  for (double s = first_s(site); s < last_s(site); s += site.plan.things.pole_every_m * random.uniform(0.7, 1.3)) {
    side = -side;
    const RoadsidePlace place = roadside(site, s, side, random.uniform(0.6, 1.1));
    if (place.inside_m > -kRoadsideClear_m) {
      continue;
    }
    builder.set_frame(upright_frame(place.ground_m, 0.0));
    const double height = random.uniform(1.7, 2.4);
    // Never quite upright.
    builder.rod({0, 0, -0.4}, {random.uniform(-0.1, 0.1), random.uniform(-0.1, 0.1), height}, 0.035, 0.03, 7);
  }
}

void add_billboards(const Site& site, TriangleMesh& mesh) {
  if (site.plan.things.billboard_every_m <= 0.0) {
    return;
  }
  MeshBuilder builder(mesh);
  Random random = random_of(site, ThingRandom::billboards);
  double s = first_s(site) + site.plan.things.billboard_every_m * random.uniform();
  for (; s < last_s(site); s += site.plan.things.billboard_every_m * random.uniform(0.5, 1.5)) {
    const double side = random.chance(0.5) ? 1.0 : -1.0;
    const RoadsidePlace place = roadside(site, s, side, random.uniform(3.6, 5.0));
    if (place.inside_m > -3.2) {
      continue;
    }
    // Faces those who come, or stands along the way.
    const double turn = random.chance(0.5) ? 0.5 * std::numbers::pi : random.uniform(-0.2, 0.2);
    builder.set_frame(upright_frame(place.ground_m, place.heading_rad + turn));
    const double half = random.uniform(1.2, 2.6);
    const double low = random.uniform(0.8, 1.5);
    const double high = low + random.uniform(1.0, 1.8);
    builder.set_material({Surface::cloth, truth::kFence});
    builder.box({-half, -0.03, low}, {half, 0.03, high});
    builder.set_material(kSteel);
    for (const double x : {-0.8 * half, 0.8 * half}) {
      builder.rod({x, 0.08, -1.5}, {x, 0.08, high}, 0.05, 0.05, 6);
    }
  }
}

void add_lamps(const Site& site, TriangleMesh& mesh) {
  if (site.plan.things.lamp_every_m <= 0.0) {
    return;
  }
  MeshBuilder builder(mesh);
  builder.set_material(kSteel);
  for (double s = first_s(site); s < last_s(site); s += site.plan.things.lamp_every_m) {
    const RoadsidePlace place = roadside(site, s, 1.0, 1.2);
    if (place.inside_m > -1.0) {
      continue;
    }
    builder.set_frame(upright_frame(place.ground_m, place.heading_rad - 0.5 * std::numbers::pi));
    builder.rod({0, 0, -0.5}, {0, 0, 7.0}, 0.09, 0.05, 8);
    builder.rod({0, 0, 6.95}, {1.4, 0, 7.15}, 0.04, 0.04, 6);
    builder.box({1.2, -0.12, 7.08}, {1.8, 0.12, 7.22});
  }
}

}  // namespace berm::sim
