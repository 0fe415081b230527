#include "feature/feature_map.hpp"

#include <algorithm>
#include <random>

#include <gtest/gtest.h>

namespace berm {
namespace {

class FeatureMapTest : public testing::Test {
 protected:
  Eigen::Vector3d any_m(double size_m) {
    std::uniform_real_distribution<double> even(-size_m, size_m);
    return {even(random_), even(random_), 0.05 * even(random_)};
  }

  std::mt19937 random_{3};
};

TEST_F(FeatureMapTest, FindsWhatBruteForceFinds) {
  const FeatureOdometryConfig config;
  FeatureMap map(config);
  VoxelMeans brute(config.plane_spacing_m);
  for (int i = 0; i < 3000; ++i) {
    const Eigen::Vector3d world_m = any_m(20.0);
    map.add(world_m, FeatureClass::obstacle_plane, 0);
    brute.add(world_m, 0.0, 0);
  }
  map.update(Eigen::Vector3d::Zero(), 0);
  std::size_t found = 0;
  for (int i = 0; i < 300; ++i) {
    const Eigen::Vector3d place_m = any_m(22.0);
    auto means = brute.means();
    std::sort(means.begin(), means.end(), [&](const VoxelMean& a, const VoxelMean& b) {
      return (a.mean_m - place_m).squaredNorm() < (b.mean_m - place_m).squaredNorm();
    });
    std::array<Eigen::Vector3d, 5> nearest_m;
    for (std::size_t j = 0; j < 5; ++j) {
      nearest_m[j] = means[j].mean_m;
    }
    const auto expected = surface_through(nearest_m, false);
    const auto surface = map.find(place_m, FeatureClass::obstacle_plane);
    ASSERT_EQ(surface.has_value(), expected.has_value());
    if (surface) {
      EXPECT_EQ(surface->anchor_m, expected->anchor_m);
      EXPECT_EQ(surface->axis, expected->axis);
      ++found;
    }
  }
  EXPECT_GT(found, 100U);
}

TEST_F(FeatureMapTest, ClassesAreApart) {
  FeatureMap map({});
  for (int i = 0; i < 500; ++i) {
    map.add(any_m(3.0), FeatureClass::piste_plane, 0);
  }
  EXPECT_EQ(map.planes(), 0U) << "not before the update";
  map.update(Eigen::Vector3d::Zero(), 0);
  EXPECT_GT(map.planes(), 100U);
  EXPECT_FALSE(map.find(Eigen::Vector3d::Zero(), FeatureClass::obstacle_plane));
  EXPECT_FALSE(map.find(Eigen::Vector3d::Zero(), FeatureClass::piste_edge));
}

TEST_F(FeatureMapTest, NothingIsFoundTooFarAway) {
  FeatureMap map({.max_plane_distance_m = 2.0});
  for (int i = 0; i < 500; ++i) {
    map.add(any_m(3.0), FeatureClass::piste_plane, 0);
  }
  map.update(Eigen::Vector3d::Zero(), 0);
  EXPECT_FALSE(map.find({9.0, 0.0, 0.0}, FeatureClass::piste_plane));
}

TEST_F(FeatureMapTest, MemoryIsBoundedOnALongWay) {
  FeatureMap map({.keep_scans = 40, .keep_m = 30.0});
  std::size_t most = 0;
  for (std::size_t scan = 0; scan < 400; ++scan) {
    const Eigen::Vector3d machine_m(0.5 * static_cast<double>(scan), 0.0, 0.0);
    for (int i = 0; i < 50; ++i) {
      map.add(machine_m + any_m(10.0), FeatureClass::piste_plane, scan);
    }
    map.update(machine_m, scan);
    most = std::max(most, map.size());
  }
  EXPECT_LE(most, 50U * 50U);
  EXPECT_GT(map.size(), 500U);
}

TEST(VoxelMeans, CutKeepsTheRestWholeAndFindable) {
  VoxelMeans means(1.0);
  for (int i = 0; i < 100; ++i) {
    means.add({i + 0.25, 0.5, 0.5}, 1.0, static_cast<std::size_t>(i % 3));
    means.add({i + 0.75, 0.5, 0.5}, 3.0, static_cast<std::size_t>(i % 3));
  }
  ASSERT_EQ(means.size(), 100U);
  EXPECT_EQ(means.means()[7].mean_m, Eigen::Vector3d(7.5, 0.5, 0.5));
  EXPECT_EQ(means.means()[7].time_s, 2.0);
  means.cut({0.0, 0.0, 0.0}, 50.0, 1);
  ASSERT_EQ(means.size(), 33U);
  for (const VoxelMean& mean : means.means()) {
    EXPECT_LT(mean.mean_m.x(), 50.0);
    EXPECT_GE(mean.seen, 1U);
  }
  // Cut voxels are made anew, kept ones are found.
  means.add({0.5, 0.5, 0.5}, 0.0, 5);
  means.add({1.5, 0.5, 0.5}, 0.0, 5);
  ASSERT_EQ(means.size(), 34U);
  EXPECT_EQ(means.means().back().count, 1.0);
  EXPECT_EQ(means.means().front().count, 3.0);
}

}  // namespace
}  // namespace berm
