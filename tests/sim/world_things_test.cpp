#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "berm/core/error.hpp"
#include "sim/world_cases.hpp"

namespace berm::sim {
namespace {

/// Height above the ground below which a thing is in the way of who drives there.
constexpr double kInTheWay_m = 4.0;

std::size_t count_of(const TriangleMesh& mesh, Surface surface) {
  return static_cast<std::size_t>(std::count_if(mesh.materials.begin(), mesh.materials.end(),
                                                [&](const Material& m) { return m.surface == surface; }));
}

void expect_sound(const TriangleMesh& mesh) {
  ASSERT_EQ(mesh.materials.size(), mesh.triangles.size());
  for (const auto& triangle : mesh.triangles) {
    for (const std::uint32_t index : triangle) {
      ASSERT_LT(index, mesh.vertices_m.size());
    }
  }
  for (const Eigen::Vector3f& v : mesh.vertices_m) {
    ASSERT_TRUE(v.allFinite());
  }
}

TEST(WorldThings, MeshesAreSound) {
  for (const std::string kind : {"piste", "haul_road", "flat_road", "car_park"}) {
    const World world = world_of(kind, 1);
    EXPECT_GT(world.things.triangles.size(), 100U);
    expect_sound(world.things);
    for (const Mover& mover : world.movers) {
      expect_sound(mover.mesh);
    }
  }
}

TEST(WorldThings, NothingStandsOnThePiste) {
  for (const std::uint64_t seed : {1U, 2U, 3U}) {
    const World world = world_of("piste", seed);
    for (const Eigen::Vector3f& v : world.things.vertices_m) {
      const GroundSample ground = world.terrain->at(v.x(), v.y());
      if (static_cast<double>(v.z()) < ground.height_m + kInTheWay_m) {
        ASSERT_LT(ground.inside_m, 0.1) << v.transpose();
      }
    }
  }
}

TEST(WorldThings, WhatStandsOnOtherRoadsIsParkedOrARock) {
  for (const std::string kind : {"haul_road", "flat_road", "car_park"}) {
    const World world = world_of(kind, 1);
    for (std::size_t i = 0; i < world.things.triangles.size(); ++i) {
      const Eigen::Vector3f v = world.things.vertices_m[world.things.triangles[i][0]];
      const GroundSample ground = world.terrain->at(v.x(), v.y());
      if (ground.inside_m < 0.1 || static_cast<double>(v.z()) > ground.height_m + kInTheWay_m) {
        continue;
      }
      const Material& material = world.things.materials[i];
      ASSERT_TRUE(material.truth_id == truth::kVehicle || material.surface == Surface::rock) << kind << v.transpose();
      // And leaves the middle of the route free.
      ASSERT_GT(std::abs(world.route.nearest(v.x(), v.y()).left_m), 2.2) << kind;
    }
  }
}

TEST(WorldThings, StandOnTheGround) {
  const World world = world_of("piste", 1);
  // A trunk goes from its foot in the ground to half of the tree's height, in triangles that each span it.
  std::size_t trunks = 0;
  for (std::size_t i = 0; i < world.things.triangles.size(); ++i) {
    if (world.things.materials[i].surface != Surface::bark) {
      continue;
    }
    Eigen::Vector3f low = Eigen::Vector3f::Constant(1e9F);
    Eigen::Vector3f high = Eigen::Vector3f::Constant(-1e9F);
    for (const std::uint32_t index : world.things.triangles[i]) {
      const Eigen::Vector3f& v = world.things.vertices_m[index];
      low = v.z() < low.z() ? v : low;
      high = v.z() > high.z() ? v : high;
    }
    if (high.z() - low.z() < 1.0F) {
      continue;  // a lid of the trunk
    }
    const double foot_m = static_cast<double>(low.z()) - world.terrain->at(low.x(), low.y()).height_m;
    ASSERT_LT(foot_m, 0.0);
    ASSERT_GT(foot_m, -2.0);
    ++trunks;
  }
  EXPECT_GT(trunks, 1000U);
}

TEST(WorldThings, NoTreeStandsInAnythingElse) {
  const World world = world_of("piste", 3);
  std::vector<Eigen::Vector2f> trunks;
  std::vector<Eigen::Vector2f> others;
  for (std::size_t i = 0; i < world.things.triangles.size(); ++i) {
    const auto& t = world.things.triangles[i];
    const Eigen::Vector3f middle =
        (world.things.vertices_m[t[0]] + world.things.vertices_m[t[1]] + world.things.vertices_m[t[2]]) / 3.0F;
    const Surface surface = world.things.materials[i].surface;
    if (surface == Surface::bark) {
      trunks.emplace_back(middle.head<2>());
    } else if (surface != Surface::foliage) {
      others.emplace_back(middle.head<2>());
    }
  }
  ASSERT_GT(others.size(), 100U);
  // By x, so that each looks at the few trunks around it only.
  const auto by_x = [](const Eigen::Vector2f& one, const Eigen::Vector2f& two) { return one.x() < two.x(); };
  std::sort(trunks.begin(), trunks.end(), by_x);
  constexpr float kClear_m = 0.8F;
  for (const Eigen::Vector2f& other : others) {
    const Eigen::Vector2f reach(kClear_m, 0.0F);
    const auto end = std::upper_bound(trunks.begin(), trunks.end(), other + reach, by_x);
    for (auto trunk = std::lower_bound(trunks.begin(), trunks.end(), other - reach, by_x); trunk != end; ++trunk) {
      ASSERT_GT((*trunk - other).norm(), kClear_m);
    }
  }
}

TEST(WorldThings, MoversKeepClearOfWhatIsParkedAndOfEachOther) {
  for (const std::uint64_t seed : {1U, 2U, 3U}) {
    WorldPlan plan = plan_of("haul_road");
    plan.traffic.ahead = 1;
    plan.traffic.oncoming = 1;
    plan.traffic.parked = 6;
    plan.haul_road.rocks_per_km = 0;
    const World world = build_world(plan, std::nullopt, seed);
    for (const Mover& mover : world.movers) {
      for (const StampedPose& pose : mover.T_world_object.poses()) {
        for (std::size_t i = 0; i < world.things.triangles.size(); ++i) {
          if (world.things.materials[i].truth_id == truth::kVehicle) {
            const Eigen::Vector3f& v = world.things.vertices_m[world.things.triangles[i][0]];
            const Eigen::Vector3d in_mover = pose.T_world_base.inverse() * v.cast<double>();
            // Half of the width and of the length of a truck.
            ASSERT_FALSE(std::abs(in_mover.y()) < 3.1 && std::abs(in_mover.x()) < 5.1);
          }
        }
      }
    }
    for (const StampedPose& a : world.movers[0].T_world_object.poses()) {
      for (const StampedPose& b : world.movers[1].T_world_object.poses()) {
        const Eigen::Vector3d apart = a.T_world_base.inverse() * b.T_world_base.translation_m();
        ASSERT_FALSE(std::abs(apart.y()) < 6.2 && std::abs(apart.x()) < 4.0);
      }
    }
  }
}

TEST(WorldThings, CrownsAreClosed) {
  WorldPlan plan = plan_of("piste");
  plan.route.length_m = 60.0;
  const World world = build_world(plan, std::nullopt, 1);
  // A closed body has a volume that does not depend on the origin: the sum of its directed areas is zero.
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  double area = 0.0;
  double volume = 0.0;
  for (std::size_t i = 0; i < world.things.triangles.size(); ++i) {
    if (world.things.materials[i].surface != Surface::foliage) {
      continue;
    }
    const auto& t = world.things.triangles[i];
    const Eigen::Vector3d a = world.things.vertices_m[t[0]].cast<double>();
    const Eigen::Vector3d b = world.things.vertices_m[t[1]].cast<double>();
    const Eigen::Vector3d c = world.things.vertices_m[t[2]].cast<double>();
    const Eigen::Vector3d directed = 0.5 * (b - a).cross(c - a);
    sum += directed;
    area += directed.norm();
    volume += a.dot(directed) / 3.0;
  }
  EXPECT_GT(area, 1000.0);
  EXPECT_LT(sum.norm(), 1e-4 * area);
  // Front faces outside.
  EXPECT_GT(volume, 100.0);
}

TEST(WorldThings, AsManyTreesAsAsked) {
  WorldPlan plan = plan_of("piste");
  plan.things.trees_per_hectare = 0.0;
  EXPECT_EQ(count_of(build_world(plan, std::nullopt, 1).things, Surface::foliage), 0U);
  plan.things.trees_per_hectare = 100.0;
  const double some = static_cast<double>(count_of(build_world(plan, std::nullopt, 1).things, Surface::bark));
  plan.things.trees_per_hectare = 400.0;
  const double many = static_cast<double>(count_of(build_world(plan, std::nullopt, 1).things, Surface::bark));
  EXPECT_NEAR(many / some, 4.0, 0.6);
}

TEST(WorldThings, FencesTakeTheirShareOfTheEdges) {
  WorldPlan plan = plan_of("piste");
  plan.piste.forks = 0;
  plan.things.trees_per_hectare = 0.0;
  plan.things.fence_share = 0.0;
  EXPECT_EQ(count_of(build_world(plan, std::nullopt, 1).things, Surface::net), 0U);
  plan.things.fence_share = 0.3;
  // Two triangles every 2.5 m, on two sides, along the route and 60 m around.
  const double all = 2.0 * 2.0 * (300.0 + 120.0) / 2.5;
  EXPECT_NEAR(static_cast<double>(count_of(build_world(plan, std::nullopt, 1).things, Surface::net)) / all, 0.3, 0.06);
}

TEST(WorldThings, MoversDriveOnTheGroundAtTheirSpeed) {
  for (const std::string kind : {"piste", "haul_road", "flat_road"}) {
    WorldPlan plan = plan_of(kind);
    plan.traffic.ahead = 1;
    plan.traffic.oncoming = 1;
    const World world = build_world(plan, std::nullopt, 2);
    ASSERT_EQ(world.movers.size(), 2U);
    for (const Mover& mover : world.movers) {
      const auto& poses = mover.T_world_object.poses();
      ASSERT_GT(poses.size(), 20U);
      EXPECT_EQ(poses.front().stamp_ns, 0);
      double driven = 0.0;
      for (std::size_t i = 0; i < poses.size(); ++i) {
        const Eigen::Vector3d at = poses[i].T_world_base.translation_m();
        const GroundSample ground = world.terrain->at(at.x(), at.y());
        ASSERT_GT(ground.inside_m, 0.8) << kind;
        ASSERT_NEAR(at.z(), ground.height_m, 0.5);
        driven += i > 0 ? (at - poses[i - 1].T_world_base.translation_m()).head<2>().norm() : 0.0;
      }
      const double seconds = to_seconds(poses.back().stamp_ns);
      EXPECT_NEAR(driven / seconds, plan.traffic.speed_m_per_s, 0.2 * plan.traffic.speed_m_per_s);
    }
    // Who comes towards leaves the middle free.
    for (const StampedPose& pose : world.movers[1].T_world_object.poses()) {
      const Eigen::Vector3d at = pose.T_world_base.translation_m();
      const RoutePlace place = world.route.nearest(at.x(), at.y());
      if (place.beyond_m == 0.0) {
        ASSERT_GT(place.left_m, kind == "flat_road" ? 2.0 : 5.0);
      }
    }
    for (const Material& material : world.movers[0].mesh.materials) {
      ASSERT_EQ(material.truth_id, truth::kMovingVehicle);
    }
  }
}

TEST(WorldThings, RefusesOncomingTrafficWhereThereIsNoRoom) {
  WorldPlan plan = plan_of("haul_road");
  plan.haul_road.min_width_m = 8.0;
  plan.haul_road.max_width_m = 9.0;
  plan.traffic.oncoming = 1;
  try {
    static_cast<void>(build_world(plan, std::nullopt, 1));
    FAIL() << "a truck has passed on a narrow road";
  } catch (const ConfigError& error) {
    EXPECT_EQ(error.key(), "traffic.oncoming");
  }
}

TEST(WorldThings, PlumesHoverOverTheRoad) {
  const World world = world_of("haul_road", 1);
  EXPECT_EQ(world.plumes.size(), 6U);
  for (const Plume& plume : world.plumes) {
    const double ground = world.terrain->at(plume.center_m.x(), plume.center_m.y()).height_m;
    EXPECT_GT(plume.center_m.z(), ground);
    EXPECT_LT(plume.center_m.z(), ground + 5.0);
    EXPECT_GT(plume.extinction_per_m, 0.0);
    EXPECT_TRUE((plume.sigma_m.array() > 0.0).all());
  }
}

TEST(WorldThings, TheSameSeedGivesTheSameThingsAndAnotherOneOthers) {
  const World a = world_of("piste", 1);
  const World b = world_of("piste", 1);
  const World c = world_of("piste", 2);
  EXPECT_EQ(a.things.vertices_m, b.things.vertices_m);
  EXPECT_EQ(a.things.triangles, b.things.triangles);
  EXPECT_NE(a.things.vertices_m, c.things.vertices_m);
  EXPECT_EQ(a.movers[0].T_world_object.poses()[5].T_world_base.matrix(),
            b.movers[0].T_world_object.poses()[5].T_world_base.matrix());
}

TEST(WorldThings, AKilometreOfForestStaysSmall) {
  WorldPlan plan = plan_of("piste");
  plan.route.length_m = 1000.0;
  const World world = build_world(plan, std::nullopt, 1);
  // 12 bytes a vertex, 16 a triangle with its material: below 50 MB.
  EXPECT_LT(world.things.triangles.size(), 1'500'000U);
}

}  // namespace
}  // namespace berm::sim
