#include <algorithm>
#include <cstdint>
#include <functional>
#include <numeric>
#include <random>
#include <vector>

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include "berm/ground/terrain_ground.hpp"
#include "ground/ground_cases.hpp"

// Laws that hold for every scan.

namespace berm {
namespace {

using test::MadeScan;
using test::Terrain;

/// A scan small enough that every point is looked at for the plane.
MadeScan small_scan(const Terrain& terrain, std::uint32_t seed) {
  const test::Beams beams = test::spinning_beams(32, -25.0, 5.0, 250);
  return test::cast(terrain.world, beams, test::standing_at_origin(terrain.world, 1.73), {.seed = seed});
}

const std::vector<Terrain>& terrains() {
  static const std::vector<Terrain> all = test::all_terrains();
  return all;
}

/// Any small scan of any of the worlds.
rc::Gen<MadeScan> any_scan() {
  return rc::gen::apply([](std::size_t terrain, std::uint32_t seed) { return small_scan(terrains()[terrain], seed); },
                        rc::gen::inRange<std::size_t>(0, terrains().size()), rc::gen::arbitrary<std::uint32_t>());
}

std::vector<GroundClass> classes_of(TerrainGround& ground, const PointCloud& cloud) {
  return test::classes_of(ground.process(cloud.view(), test::mount(1.73)));
}

PointCloud picked(const PointsView& view, const std::vector<std::size_t>& order) {
  std::vector<Eigen::Vector3f> points;
  for (const std::size_t i : order) {
    points.emplace_back(view.x[i], view.y[i], view.z[i]);
  }
  return test::cloud_of(points);
}

double share_different(const std::vector<GroundClass>& a, const std::vector<GroundClass>& b) {
  const double same = std::inner_product(a.begin(), a.end(), b.begin(), 0.0, std::plus<>(),
                                         [](GroundClass l, GroundClass r) { return l == r ? 1.0 : 0.0; });
  return 1.0 - same / static_cast<double>(a.size());
}

TEST(TerrainLaws, OrderOfPointsDoesNotMatter) {
  EXPECT_TRUE(rc::check("labels are permuted with the points", [] {
    const MadeScan scan = *any_scan();
    std::vector<std::size_t> order(scan.cloud.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::mt19937 random(*rc::gen::arbitrary<std::uint32_t>());
    std::shuffle(order.begin(), order.end(), random);
    TerrainGround ground({});
    const auto expected = classes_of(ground, scan.cloud);
    const auto shuffled = classes_of(ground, picked(scan.cloud.view(), order));
    for (std::size_t i = 0; i < order.size(); ++i) {
      RC_ASSERT(shuffled[i] == expected[order[i]]);
    }
  }));
}

TEST(TerrainLaws, NothingIsRememberedOfTheScanBefore) {
  EXPECT_TRUE(rc::check("the same bytes after any other scan", [] {
    const MadeScan scan = *any_scan();
    const MadeScan other = *any_scan();
    const PointCloud tilted = test::turned(other.cloud.view(), 0.0, *rc::gen::inRange(-30, 30), 0.0);
    TerrainGround ground({});
    TerrainGround fresh({});
    (void)ground.process(tilted.view(), test::mount(*rc::gen::inRange(0, 4)));
    const GroundResult again = ground.process(scan.cloud.view(), test::mount(1.73));
    const GroundResult first = fresh.process(scan.cloud.view(), test::mount(1.73));
    RC_ASSERT(std::equal(again.classes.begin(), again.classes.end(), first.classes.begin(), first.classes.end()));
    const HeightGrid::Channels& a = again.surface->channels();
    const HeightGrid::Channels& b = first.surface->channels();
    RC_ASSERT(a.height_m == b.height_m);
    RC_ASSERT(a.radial_slope == b.radial_slope);
    RC_ASSERT(a.variance_m2 == b.variance_m2);
    RC_ASSERT(a.measured == b.measured);
    RC_ASSERT(again.surface->T_level_sensor().matrix() == first.surface->T_level_sensor().matrix());
  }));
}

TEST(TerrainLaws, LabelsTurnWithTheCloudByWholeSectors) {
  TerrainGroundConfig config;
  config.level = false;  // the plane comes from a square grid that does not turn
  EXPECT_TRUE(rc::check("labels stay under a turn by sectors", [config] {
    // On a street; where the ground is hard to follow, one point more or less in a cell moves many labels.
    const MadeScan scan = small_scan(terrains().front(), *rc::gen::arbitrary<std::uint32_t>());
    TerrainGround ground(config);
    const double yaw_deg = 360.0 / config.sectors * *rc::gen::inRange(1, config.sectors);
    const auto expected = classes_of(ground, scan.cloud);
    const auto turned = classes_of(ground, test::turned(scan.cloud.view(), yaw_deg, 0.0, 0.0));
    // The few points that rounding of coordinates moves over a border of cells or of tolerance.
    RC_ASSERT(share_different(turned, expected) < 0.005);
  }));
}

TEST(TerrainLaws, ATurnHardlyMattersToTheLevelledMethodEither) {
  for (const Terrain& terrain : {terrains()[0], terrains()[1], terrains()[7]}) {
    const MadeScan scan = test::rings_64().look(terrain.world);
    TerrainGround ground({});
    const auto expected = classes_of(ground, scan.cloud);
    for (const double yaw_deg : {2.0, 33.0, 90.0, 178.0, 271.0}) {
      const double changed =
          share_different(classes_of(ground, test::turned(scan.cloud.view(), yaw_deg, 0.0, 0.0)), expected);
      EXPECT_LT(changed, 0.01) << terrain.name << ", yaw " << yaw_deg;
    }
  }
}

TEST(TerrainLaws, NothingIsGroundThatLiesAboveTheToleranceOfItsCell) {
  EXPECT_TRUE(rc::check("ground points lie low over the surface", [] {
    const MadeScan scan = *any_scan();
    const TerrainGroundConfig config;
    TerrainGround ground(config);
    const GroundResult result = ground.process(scan.cloud.view(), test::mount(1.73));
    const PointsView view = scan.cloud.view();
    std::size_t contradictions = 0;
    for (std::size_t i = 0; i < view.size(); ++i) {
      const Eigen::Vector3d p(static_cast<double>(view.x[i]), static_cast<double>(view.y[i]),
                              static_cast<double>(view.z[i]));
      const auto above = result.surface->height_above(p);
      if (!above || result.classes[i] == GroundClass::no_return) {
        continue;
      }
      // The tolerance grows by 3 mm per metre of range.
      const double most_m = config.tolerance_m + 0.003 * (p.norm() + 3.0);
      const bool ground_said = result.classes[i] == GroundClass::ground;
      contradictions += ground_said && above->height_m > most_m + 0.01 ? 1U : 0U;
      contradictions += !ground_said && above->height_m < config.object_tolerance_m - 0.01 ? 1U : 0U;
    }
    // Look-up by arc tangent and the fast one of the method differ near borders of sectors.
    RC_ASSERT(contradictions <= view.size() / 200);
  }));
}

}  // namespace
}  // namespace berm
