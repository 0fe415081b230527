#include "surface_map.hpp"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

namespace berm {
namespace {

class SurfaceMapTest : public testing::Test {
 protected:
  double even(double low, double high) { return std::uniform_real_distribution<double>(low, high)(random_); }

  std::mt19937 random_{3};
  SurfaceMap map_{SurfaceOdometryConfig{}};
};

TEST_F(SurfaceMapTest, KnowsNothingAtFirst) {
  EXPECT_EQ(map_.find({0.1, 0.1, 0.1}, true).cell, nullptr);
  map_.add({0.1, 0.1, 0.1}, true);
  EXPECT_EQ(map_.find({0.1, 0.1, 0.1}, true).cell, nullptr);
  EXPECT_EQ(map_.size(), 1U);
}

TEST_F(SurfaceMapTest, FindsThePlaneFarFromTheOrigin) {
  const Eigen::Vector3d origin_m(5e5, 5e6, 300.0);
  const Eigen::Vector3d normal = Eigen::Vector3d(0.2, -0.1, 1.0).normalized();
  for (int i = 0; i < 4000; ++i) {
    const double x_m = even(0.0, 2.0);
    const double y_m = even(0.0, 2.0);
    const double z_m = 0.25 - (normal.x() * x_m + normal.y() * y_m) / normal.z();
    map_.add(origin_m + Eigen::Vector3d(x_m, y_m, z_m), true);
  }
  const Eigen::Vector3d place_m = origin_m + Eigen::Vector3d(1.2, 1.2, 0.15);
  const SurfaceHit hit = map_.find(place_m, true);
  ASSERT_NE(hit.cell, nullptr);
  EXPECT_EQ(hit.cell->shape(), SurfaceShape::plane);
  EXPECT_NEAR(std::abs(hit.cell->normal().cast<double>().dot(normal)), 1.0, 1e-4);
  const Eigen::Vector3d on_plane_m = origin_m + Eigen::Vector3d(0.0, 0.0, 0.25);
  EXPECT_NEAR(normal.dot(hit.mean_m - on_plane_m), 0.0, 1e-3);
}

TEST_F(SurfaceMapTest, APostIsACloudThatHoldsSidewaysOnly) {
  for (int i = 0; i < 300; ++i) {
    map_.add({0.25 + even(-0.03, 0.03), 0.25 + even(-0.03, 0.03), even(0.0, 0.5)}, false);
  }
  const SurfaceHit hit = map_.find({0.2, 0.2, 0.2}, false);
  ASSERT_NE(hit.cell, nullptr);
  EXPECT_EQ(hit.cell->shape(), SurfaceShape::cloud);
  EXPECT_GT(hit.cell->information_per_m2()(0, 0), 5.0F * hit.cell->information_per_m2()(2, 2));
  EXPECT_EQ(map_.find({0.2, 0.2, 0.2}, true).cell, nullptr) << "ground is never a cloud";
}

TEST_F(SurfaceMapTest, GroundBetweenDistantRingsIsAWidePlane) {
  for (int i = 0; i < 50; ++i) {
    for (const double y_m : {0.6, 3.9}) {
      map_.add({even(0.1, 4.4), y_m, 0.1 + even(-0.01, 0.01)}, true);
    }
  }
  const SurfaceHit hit = map_.find({2.2, 2.2, 0.1}, true);
  ASSERT_NE(hit.cell, nullptr);
  EXPECT_NEAR(std::abs(hit.cell->normal().z()), 1.0F, 0.01F);
  EXPECT_EQ(map_.find({2.2, 2.2, 0.1}, false).cell, nullptr);
}

TEST_F(SurfaceMapTest, FollowsWhatChanged) {
  for (int i = 0; i < 5000; ++i) {
    const double z_m = i < 2500 ? 0.1 : 0.4;
    map_.add({even(0.0, 0.5), even(0.0, 0.5), z_m + even(-0.01, 0.01)}, true);
  }
  const SurfaceHit hit = map_.find({0.25, 0.25, 0.4}, true);
  ASSERT_NE(hit.cell, nullptr);
  EXPECT_NEAR(hit.mean_m.z(), 0.4, 0.02);
}

TEST_F(SurfaceMapTest, CutLeavesWhatIsNear) {
  for (double x_m = 0.25; x_m < 50.0; x_m += 0.5) {
    map_.add({x_m, 0.25, 0.25}, true);
  }
  map_.cut(Eigen::Vector3d::Zero(), 10.0);
  EXPECT_EQ(map_.size(), 20U);
}

TEST_F(SurfaceMapTest, CutLeavesToEveryPlaceItsOwnSurface) {
  const auto height_m = [](double x_m) { return 0.25 + 0.2 * std::sin(x_m); };
  for (int i = 0; i < 60'000; ++i) {
    const double x_m = 0.5 * std::floor(even(-100.0, 100.0)) + even(0.0, 0.5);
    map_.add({x_m, even(0.0, 0.5), height_m(std::floor(2.0 * x_m))}, true);
  }
  map_.cut(Eigen::Vector3d::Zero(), 20.0);
  std::size_t found = 0;
  for (double x_m = -49.75; x_m < 50.0; x_m += 0.5) {
    const double z_m = height_m(std::floor(2.0 * x_m));
    const SurfaceHit hit = map_.find({x_m, 0.25, z_m}, true);
    if (hit.cell != nullptr && std::abs(x_m) < 18.0) {
      ++found;
      EXPECT_NEAR(hit.mean_m.x(), x_m, 0.15);
      EXPECT_NEAR(hit.mean_m.z(), z_m, 0.01);
    } else {
      EXPECT_TRUE(std::abs(x_m) > 18.0) << x_m;
    }
  }
  EXPECT_GT(found, 60U);
}

}  // namespace
}  // namespace berm
