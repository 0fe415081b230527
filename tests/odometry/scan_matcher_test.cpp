#include "scan_matcher.hpp"

#include <random>
#include <vector>

#include <gtest/gtest.h>

namespace berm {
namespace {

constexpr double kSensorHeight_m = 2.0;

/// Points on the upright plane y = 0, which holds the sensor, 10 to 20 m ahead.
std::vector<ScanPoint> upright_plane(bool is_ground) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> x_m(10.0, 20.0);
  std::uniform_real_distribution<double> z_m(0.0, 4.0);
  std::vector<ScanPoint> points;
  for (int i = 0; i < 3000; ++i) {
    ScanPoint point{.base_m = {x_m(random), 0.0, z_m(random)}, .share = 0.5, .is_ground = is_ground};
    point.ray = (point.base_m - Eigen::Vector3d(0.0, 0.0, kSensorHeight_m)).normalized().cast<float>();
    points.push_back(point);
  }
  return points;
}

/// How many of the points meet a surface in a map of themselves.
std::size_t met(const std::vector<ScanPoint>& points) {
  const SurfaceOdometryConfig config;
  SurfaceMap map(config);
  for (const ScanPoint& point : points) {
    map.add(point.base_m, point.is_ground);
  }
  const MotionPrior prior{
      .expected = {}, .begin_sigma = motion_sigmas(0.01, 0.01), .displacement_sigma = motion_sigmas(0.1, 0.1)};
  return ScanMatcher(config).match(points, map, prior).met;
}

TEST(ScanMatcher, PlanesThatAreSeenEdgeOnTellNothing) {
  const std::vector<ScanPoint> fan = upright_plane(false);
  EXPECT_LT(met(fan), fan.size() / 20) << "but for clouds at its rim";
}

TEST(ScanMatcher, PlanesThatAreSeenAskewTell) {
  std::vector<ScanPoint> wall = upright_plane(false);
  for (ScanPoint& point : wall) {
    point.base_m.y() = 0.7 * (point.base_m.x() - 10.0) - 3.0;
    point.ray = (point.base_m - Eigen::Vector3d(0.0, 0.0, kSensorHeight_m)).normalized().cast<float>();
  }
  EXPECT_GT(met(wall), wall.size() * 9 / 10);
}

TEST(ScanMatcher, GroundTellsHoweverItIsSeen) {
  const std::vector<ScanPoint> ground = upright_plane(true);
  EXPECT_GT(met(ground), ground.size() * 8 / 10);
}

}  // namespace
}  // namespace berm
