#include <algorithm>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "berm/core/error.hpp"
#include "berm/sim/random.hpp"
#include "berm/sim/ray_caster.hpp"
#include "sim/caster_worlds.hpp"

namespace berm::sim {
namespace {

using Eigen::Vector3d;

constexpr double kFar_m = 1000.0;

Vector3d random_direction(Random& random) {
  const double z = random.uniform(-1.0, 1.0);
  const double turn = random.uniform(0.0, 2.0 * std::numbers::pi);
  const double flat = std::sqrt(1.0 - z * z);
  return {flat * std::cos(turn), flat * std::sin(turn), z};
}

Route straight_route(double from_x_m, double to_x_m) {
  std::vector<RoutePoint> points;
  for (double x_m = from_x_m; x_m <= to_x_m; x_m += 1.0) {
    points.push_back({x_m - from_x_m, x_m, 0.0, 0.0, 0.0, 6.0, 6.0});
  }
  return Route(points);
}

TEST(RayCaster, AgreesWithAPlane) {
  const World world = world_of(plane_terrain(0.3, -0.1), 60.0);
  const RayCaster caster(world, {});
  const Vector3d normal = Vector3d(-0.3, 0.1, 1.0).normalized();
  Random random(1, Purpose::things);
  int hits = 0;
  for (int i = 0; i < 20'000; ++i) {
    const Vector3d origin_m{random.uniform(-40.0, 40.0), random.uniform(-40.0, 40.0), 20.0};
    const Vector3d direction = random_direction(random);
    const double expected_m = -normal.dot(origin_m) / normal.dot(direction);
    const Vector3d place_m = origin_m + expected_m * direction;
    const double out_m = place_m.head<2>().cwiseAbs().maxCoeff() - 60.0;
    Hit hit;
    const bool met = caster.cast(origin_m, direction, 0.0, kFar_m, 0.0, hit);
    // The mesh ends with a tile, at 60 m or a little after.
    if (expected_m > 0.0 && expected_m < kFar_m && out_m < 0.0) {
      ASSERT_TRUE(met) << origin_m.transpose() << " to " << direction.transpose();
      ++hits;
      const double grazing = std::abs(normal.dot(direction));
      EXPECT_NEAR(hit.range_m, expected_m, 2e-5 / grazing + 1e-5);
      EXPECT_NEAR((hit.normal.cast<double>() - normal * (normal.dot(direction) < 0.0 ? 1.0 : -1.0)).norm(), 0.0, 1e-4);
      EXPECT_NEAR(hit.across_m, place_m.y(), 1e-4 / grazing);
      if (std::abs(5.0 - std::abs(place_m.y())) > 0.05) {
        EXPECT_EQ(hit.material.truth_id, std::abs(place_m.y()) < 5.0 ? truth::kDrivable : truth::kTerrain);
      }
      EXPECT_EQ(hit.material.surface, Surface::gravel);
      EXPECT_EQ(hit.object, 0U);
    } else if (expected_m < 0.0) {
      EXPECT_FALSE(met);
    }
  }
  EXPECT_GT(hits, 5000);
}

TEST(RayCaster, AgreesWithBermsWithinWhatTheCellsLeaveOut) {
  const World world = world_of(berm_terrain(), 50.0);
  const RayCaster caster(world, {});
  Random random(2, Purpose::things);
  int hits = 0;
  int apart = 0;
  for (int i = 0; i < 3000; ++i) {
    const double x_m = random.uniform(-30.0, 30.0);
    const Vector3d origin_m{x_m, 0.0, world.terrain->at(x_m, 0.0).height_m + 3.0};
    Vector3d direction = random_direction(random);
    direction.z() = -0.3 * std::abs(direction.z());
    direction.normalize();
    const double expected_m = slow_cast(*world.terrain, origin_m, direction, 60.0);
    if (!std::isfinite(expected_m) || (origin_m + expected_m * direction).head<2>().cwiseAbs().maxCoeff() > 49.0) {
      continue;
    }
    Hit hit;
    ASSERT_TRUE(caster.cast(origin_m, direction, 0.0, kFar_m, 0.0, hit));
    const Vector3d place_m = origin_m + hit.range_m * direction;
    const GroundSample ground = world.terrain->at(place_m.x(), place_m.y());
    ++hits;
    // A cell of 0.25 m cuts a toe of 40 degrees by 0.25 tan 40 / 4.
    EXPECT_NEAR(place_m.z(), ground.height_m, 0.055);
    // Rays over a crest may go on to somewhere else.
    apart += std::abs(hit.range_m - expected_m) > 0.06 / std::abs(hit.normal.dot(direction.cast<float>())) ? 1 : 0;
    if (std::abs(ground.inside_m) > 0.05) {
      EXPECT_EQ(hit.material.truth_id, ground.inside_m > 0.0 ? truth::kDrivable : truth::kTerrain);
    }
    // Cells cut off the ridge of the distances in the middle of the road.
    EXPECT_NEAR(hit.inside_m, ground.inside_m, ground.inside_m < 5.5 ? 0.05 : 0.15);
  }
  EXPECT_GT(hits, 2000);
  EXPECT_LT(apart, hits / 100);
}

TEST(RayCaster, AgreesWithASlowSearchOverAllTriangles) {
  Random random(3, Purpose::things);
  World world = world_of(plane_terrain(0.0, 0.0), 1.0);
  for (int i = 0; i < 300; ++i) {
    const Vector3d middle_m{random.uniform(-20.0, 20.0), random.uniform(-20.0, 20.0), random.uniform(30.0, 60.0)};
    std::array<Eigen::Vector3f, 3> corners;
    for (Eigen::Vector3f& corner : corners) {
      corner = (middle_m + 3.0 * random_direction(random)).cast<float>();
    }
    add_triangle(world.things, corners[0], corners[1], corners[2],
                 {i % 2 == 0 ? Surface::metal : Surface::bark, static_cast<std::uint16_t>(50 + i % 7)});
  }
  const RayCaster caster(world, {});
  int hits = 0;
  for (int i = 0; i < 5000; ++i) {
    const Vector3d origin_m{random.uniform(-20.0, 20.0), random.uniform(-20.0, 20.0), 25.0};
    Vector3d direction = random_direction(random);
    direction.z() = std::abs(direction.z());
    const auto [expected_m, triangle] = slow_cast(world.things, origin_m, direction);
    Hit hit;
    const bool met = caster.cast(origin_m, direction, 0.0, kFar_m, 0.0, hit);
    ASSERT_EQ(met, std::isfinite(expected_m)) << i;
    if (met) {
      ++hits;
      EXPECT_NEAR(hit.range_m, expected_m, 1e-3);
      EXPECT_EQ(hit.material.truth_id, world.things.materials[triangle].truth_id);
      EXPECT_EQ(hit.material.surface, world.things.materials[triangle].surface);
      EXPECT_EQ(hit.object, 1U);
      EXPECT_LT(hit.normal.dot(direction.cast<float>()), 0.0F);
    }
  }
  EXPECT_GT(hits, 500);
}

TEST(RayCaster, MeetsFrontsAndBacksAsTheyAreWound) {
  World world = world_of(plane_terrain(0.0, 0.0), 1.0);
  add_box(world.things, {-1.0F, -1.0F, 10.0F}, {1.0F, 1.0F, 12.0F}, {Surface::concrete, truth::kBuilding});
  const RayCaster caster(world, {});
  RayPacket packet{};
  packet.max_range_m.fill(-1.0F);
  for (std::size_t lane : {2U, 5U}) {
    packet.z_m[lane] = lane == 2 ? 5.0F : 11.0F;
    packet.dz[lane] = 1.0F;
    packet.max_range_m[lane] = 100.0F;
  }
  caster.cast(packet);
  EXPECT_TRUE(packet.hits[0].is_nothing());
  EXPECT_FLOAT_EQ(packet.hits[2].range_m, 5.0F);
  EXPECT_FLOAT_EQ(packet.hits[2].normal.z(), -1.0F);
  EXPECT_FLOAT_EQ(packet.hits[5].range_m, 1.0F);
  EXPECT_FLOAT_EQ(packet.hits[5].normal.z(), 1.0F);
  EXPECT_EQ(caster.material_of(packet.hits[5]).truth_id, truth::kBuilding);
  EXPECT_LT(caster.describe(packet.origin_m(5), packet.direction(5), packet.hits[5]).normal.z(), 0.0F);
}

TEST(RayCaster, PosesMoversAtTheTimeOfTheRay) {
  World world = world_of(plane_terrain(0.0, 0.0), 1.0);
  Mover mover;
  add_box(mover.mesh, {-2.0F, -1.0F, 0.0F}, {2.0F, 1.0F, 3.0F}, {Surface::paint, truth::kVehicle});
  // Turns by 90 degrees about its own z while it goes 20 m along x.
  for (int i = 0; i <= 100; ++i) {
    mover.T_world_object.append(
        10'000'000 * i, Pose::from_yaw_pitch_roll(0.005 * std::numbers::pi * i, 0.0, 0.0, {0.2 * i, 0.0, 10.0}));
  }
  world.movers = {mover, mover};
  world.movers[1].T_world_object = {};
  world.movers[1].T_world_object.append(0, Pose::from_yaw_pitch_roll(0.0, 0.0, 0.0, {-50.0, 0.0, 10.0}));
  const RayCaster caster(world, {});
  Random random(4, Purpose::movers);
  int hits = 0;
  for (int i = 0; i < 20'000; ++i) {
    const double time_s = random.uniform(-0.5, 1.5);
    const double share = std::clamp(time_s, 0.0, 1.0);
    const Vector3d origin_m{random.uniform(-70.0, 40.0), random.uniform(5.0, 30.0), random.uniform(5.0, 18.0)};
    const Vector3d target_m{i % 2 == 0 ? 20.0 * share : -50.0, random.uniform(-3.0, 3.0), random.uniform(9.0, 14.0)};
    const Vector3d direction = (target_m - origin_m).normalized();
    double expected_m = std::numeric_limits<double>::infinity();
    std::uint32_t object = 0;
    for (std::uint32_t k = 0; k < 2; ++k) {
      // Trajectory::at goes by whole nanoseconds.
      const Trajectory& trajectory = world.movers[k].T_world_object;
      const Pose T_object_world = trajectory.at(k == 0 ? from_seconds(share) : 0)->inverse();
      const auto [range_m, triangle] =
          slow_cast(world.movers[k].mesh, T_object_world * origin_m, T_object_world.rotation() * direction);
      if (range_m < expected_m) {
        expected_m = range_m;
        object = k + 2;
      }
    }
    Hit hit;
    const bool met = caster.cast(origin_m, direction, 0.0, kFar_m, time_s, hit);
    ASSERT_EQ(met, std::isfinite(expected_m)) << i;
    if (met) {
      ++hits;
      EXPECT_NEAR(hit.range_m, expected_m, 1e-4);
      EXPECT_EQ(hit.object, object);
      EXPECT_EQ(hit.material.truth_id, truth::kVehicle);
    }
  }
  EXPECT_GT(hits, 5000);
}

// Eight rays of different times, of which one meets the mover: culling must not lose it.
TEST(RayCaster, FindsTheMoverInAPacketOfDifferentTimes) {
  World world = world_of(plane_terrain(0.0, 0.0), 1.0);
  Mover mover;
  add_box(mover.mesh, {-0.5F, -0.5F, 0.0F}, {0.5F, 0.5F, 1.0F}, {Surface::paint, truth::kVehicle});
  mover.T_world_object.append(0, Pose::from_yaw_pitch_roll(0.0, 0.0, 0.0, {0.0, 0.0, 10.0}));
  mover.T_world_object.append(10'000'000'000, Pose::from_yaw_pitch_roll(1.0, 0.0, 0.0, {100.0, 0.0, 10.0}));
  world.movers.push_back(mover);
  const RayCaster caster(world, {});
  RayPacket packet{};
  packet.max_range_m.fill(1000.0F);
  packet.dy.fill(1.0F);
  packet.y_m.fill(-20.0F);
  packet.z_m.fill(10.5F);
  for (std::size_t lane = 0; lane < RayPacket::kSize; ++lane) {
    packet.time_s[lane] = static_cast<double>(lane);
    const Pose pose = *mover.T_world_object.at(static_cast<Stamp>(lane) * 1'000'000'000);
    packet.x_m[lane] = static_cast<float>(pose.translation_m().x());
    packet.y_m[lane] = static_cast<float>(pose.translation_m().y()) - 20.0F;
  }
  caster.cast(packet);
  for (std::size_t lane = 0; lane < RayPacket::kSize; ++lane) {
    EXPECT_EQ(packet.hits[lane].object, 2U) << lane;
    EXPECT_NEAR(packet.hits[lane].range_m, 19.5, 0.25) << lane;
  }
}

World levels_world() {
  World world;
  world.terrain = berm_terrain();
  world.area = {-260.0, -300.0, 261.0, 290.0};
  world.route = straight_route(-200.0, 200.0);
  return world;
}

TEST(RayCaster, LetsNoRayThroughTheTerrain) {
  const World world = levels_world();
  const RayCaster caster(world, {0.25, 10.0, 0});
  Random random(5, Purpose::things);
  Hit hit;
  for (int i = 0; i < 300'000; ++i) {
    const double x_m = random.uniform(-255.0, 255.0);
    const double y_m = random.uniform(-290.0, 285.0);
    const Vector3d origin_m{x_m, y_m, world.terrain->at(x_m, y_m).height_m + random.uniform(0.5, 3.0)};
    // To a place below the terrain within the area, often exactly on a border of tiles or a corner of cells.
    Vector3d target_m{random.uniform(-255.0, 255.0), random.uniform(-290.0, 285.0), 0.0};
    if (i % 3 != 0) {
      target_m.x() = -260.0 + 16.0 * std::floor((target_m.x() + 260.0) / 16.0) + (i % 3 == 2 ? 0.0 : 0.25);
      target_m.y() = -300.0 + 16.0 * std::floor((target_m.y() + 300.0) / 16.0);
    }
    target_m.z() = world.terrain->at(target_m.x(), target_m.y()).height_m - 10.0;
    const Vector3d direction = (target_m - origin_m).normalized();
    ASSERT_TRUE(caster.cast(origin_m, direction, 0.0, kFar_m, 0.0, hit))
        << origin_m.transpose() << " to " << target_m.transpose();
    const Vector3d place_m = origin_m + hit.range_m * direction;
    ASSERT_NEAR(place_m.z(), world.terrain->at(place_m.x(), place_m.y()).height_m, 2.5);
  }
}

TEST(RayCaster, MeshIsFineWhereTheRouteIs) {
  const World world = levels_world();
  const RayCaster near(world, {0.25, 10.0, 0});
  const RayCaster wide(world, {0.25, 40.0, 0});
  EXPECT_LT(near.memory_bytes(), 120'000'000U);
  EXPECT_GT(wide.memory_bytes(), near.memory_bytes());
  Random random(6, Purpose::things);
  double worst_m = 0.0;
  for (int i = 0; i < 5000; ++i) {
    const double x_m = random.uniform(-199.0, 199.0);
    const double y_m = random.uniform(-9.0, 9.0);
    Hit hit;
    ASSERT_TRUE(near.cast({x_m, y_m, 100.0}, -Vector3d::UnitZ(), 0.0, kFar_m, 0.0, hit));
    worst_m = std::max(worst_m, std::abs(100.0 - hit.range_m - world.terrain->at(x_m, y_m).height_m));
  }
  EXPECT_LT(worst_m, 0.055);
}

TEST(RayCaster, IsTheSameForAnyNumberOfThreads) {
  const World world = levels_world();
  const RayCaster one(world, {0.25, 10.0, 1});
  const RayCaster four(world, {0.25, 10.0, 4});
  Random random(7, Purpose::things);
  for (int i = 0; i < 20'000; ++i) {
    const Vector3d origin_m{random.uniform(-200.0, 200.0), random.uniform(-200.0, 200.0), 60.0};
    Vector3d direction = random_direction(random);
    direction.z() = -std::abs(direction.z());
    Hit a;
    Hit b;
    ASSERT_EQ(one.cast(origin_m, direction, 0.0, kFar_m, 0.0, a), four.cast(origin_m, direction, 0.0, kFar_m, 0.0, b));
    EXPECT_EQ(a.range_m, b.range_m);
    EXPECT_EQ(a.normal, b.normal);
    EXPECT_EQ(a.inside_m, b.inside_m);
  }
}

TEST(RayCaster, KeepsToTheRangesThatAreAsked) {
  const World world = world_of(plane_terrain(0.0, 0.0), 10.0);
  const RayCaster caster(world, {});
  Hit hit;
  EXPECT_TRUE(caster.cast({0.0, 0.0, 5.0}, -Vector3d::UnitZ(), 4.9, 5.1, 0.0, hit));
  EXPECT_FALSE(caster.cast({0.0, 0.0, 5.0}, -Vector3d::UnitZ(), 0.0, 4.9, 0.0, hit));
  EXPECT_FALSE(caster.cast({0.0, 0.0, 5.0}, -Vector3d::UnitZ(), 5.1, 100.0, 0.0, hit));
}

TEST(RayCaster, RefusesBrokenWorlds) {
  const auto code_of = [](const World& world, const RayCasterConfig& config) {
    try {
      const RayCaster caster(world, config);
    } catch (const Error& error) {
      return error.code();
    }
    return ErrorCode::exists;
  };
  const World good = world_of(plane_terrain(0.0, 0.0), 10.0);
  EXPECT_EQ(code_of(good, {}), ErrorCode::exists);
  World world = good;
  world.things.vertices_m = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  world.things.triangles = {{0, 1, 3}};
  world.things.materials.resize(1);
  EXPECT_EQ(code_of(world, {}), ErrorCode::invalid_argument);
  world.things.triangles = {{0, 1, 2}};
  EXPECT_EQ(code_of(world, {}), ErrorCode::exists);
  world.things.materials.clear();
  EXPECT_EQ(code_of(world, {}), ErrorCode::invalid_argument);
  world.things.materials.resize(1);
  world.things.vertices_m[1].x() = std::numeric_limits<float>::quiet_NaN();
  EXPECT_EQ(code_of(world, {}), ErrorCode::invalid_argument);
  world = good;
  world.movers.emplace_back();
  EXPECT_EQ(code_of(world, {}), ErrorCode::invalid_argument);
  world = good;
  world.terrain = plane_terrain(std::numeric_limits<double>::quiet_NaN(), 0.0);
  EXPECT_EQ(code_of(world, {}), ErrorCode::invalid_argument);
  world = good;
  world.terrain = nullptr;
  EXPECT_EQ(code_of(world, {}), ErrorCode::invalid_argument);
  world = good;
  world.area.max_x_m = 1e9;
  EXPECT_EQ(code_of(world, {}), ErrorCode::invalid_argument);
  world.area.max_x_m = 9e5;
  world.area.max_y_m = 9e5;
  EXPECT_EQ(code_of(world, {}), ErrorCode::invalid_argument);
  EXPECT_EQ(code_of(good, {0.0, 25.0, 0}), ErrorCode::invalid_argument);
}

}  // namespace
}  // namespace berm::sim
