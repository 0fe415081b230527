#include <memory>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "berm/ground/polar_ground.hpp"
#include "berm/ground/terrain_ground.hpp"
#include "ground/ground_cases.hpp"
#include "support/counting_new.hpp"

namespace berm {
namespace {

std::vector<PointCloud> scans() {
  std::vector<PointCloud> clouds;
  const test::Terrain street = test::flat_street();
  const test::Sensor sensor = test::rings_64();
  clouds.push_back(sensor.look(street.world, 1).cloud);
  clouds.push_back(test::turned(clouds.front().view(), 30.0, 10.0, -5.0));
  clouds.push_back(sensor.look(test::all_terrains()[4].world, 2).cloud);
  clouds.push_back(test::rings_16().look(street.world, 3).cloud);
  clouds.emplace_back();
  return clouds;
}

void expect_no_allocation(GroundSegmenter& ground, const std::string& name) {
  const std::vector<PointCloud> clouds = scans();
  const Pose T_base_sensor = test::mount(1.73);
  for (std::size_t i = 0; i < 3; ++i) {
    (void)ground.process(clouds[i].view(), T_base_sensor);
  }
  for (std::size_t i = 0; i < 2 * clouds.size(); ++i) {
    const PointsView points = clouds[i % clouds.size()].view();
    const std::size_t before = test::allocations();
    (void)ground.process(points, T_base_sensor);
    EXPECT_EQ(test::allocations() - before, 0U) << name << ", scan " << i;
  }
}

TEST(GroundAllocation, IsCounted) {
  const std::size_t before = test::allocations();
  const auto number = std::make_unique<std::vector<int>>(10);
  EXPECT_EQ(test::allocations() - before, 2U) << number->size();
}

TEST(GroundAllocation, IsOverAfterTheThirdScanOfTheDefault) {
  TerrainGround ground({});
  expect_no_allocation(ground, "default");
}

TEST(GroundAllocation, IsOverAfterTheThirdScanOfTheReference) {
  PolarGround ground({});
  expect_no_allocation(ground, "reference");
}

}  // namespace
}  // namespace berm
