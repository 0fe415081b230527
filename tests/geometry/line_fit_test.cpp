#include "berm/geometry/line_fit.hpp"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include "geometry/made_points.hpp"

namespace berm {
namespace {

using Eigen::Vector3d;
using test::cloud_of;
using test::kHuge;
using test::kInf;
using test::kNan;
using test::Noise;

const Vector3d kDirection = Vector3d(2.0, -1.0, 0.5).normalized();
const Vector3d kPlace_m(3.0, 4.0, -1.0);

double angle_rad(const Vector3d& a, const Vector3d& b) {
  return std::atan2(a.cross(b).norm(), std::abs(a.dot(b)));
}

std::vector<Vector3d> edge(int count, double noise_m, unsigned seed) {
  Noise noise(seed);
  std::vector<Vector3d> points_m;
  for (int i = 0; i < count; ++i) {
    const Vector3d off(noise.normal(noise_m), noise.normal(noise_m), noise.normal(noise_m));
    points_m.emplace_back(kPlace_m + noise.even(10.0) * kDirection + off);
  }
  return points_m;
}

TEST(LineFit, FindsALineAndItsQuality) {
  const auto fit = fit_line(cloud_of(edge(2000, 0.05, 1)).view());
  ASSERT_TRUE(fit.has_value());
  EXPECT_LT(angle_rad(fit->direction, kDirection), 1e-3);
  EXPECT_GT(fit->direction.x(), 0.0);
  EXPECT_LT(fit->distance_m(kPlace_m), 0.01);
  EXPECT_NEAR(fit->rms_m, 0.05 * std::sqrt(2.0), 5e-3) << "two directions across";
  EXPECT_EQ(fit->count, 2000U);
}

TEST(LineFit, OfTwoPointsPassesThroughThem) {
  EXPECT_TRUE(rc::check("also far from the origin", [] {
    Noise noise(*rc::gen::arbitrary<unsigned>());
    const Vector3d offset_m = Vector3d(noise.even(1.0), noise.even(1.0), noise.even(1.0)) * *rc::gen::element(0.0, 5e6);
    const Vector3d a = offset_m + Vector3d(noise.even(10.0), noise.even(10.0), noise.even(10.0));
    const Vector3d b = offset_m + Vector3d(noise.even(10.0), noise.even(10.0), noise.even(10.0));
    RC_PRE((b - a).norm() > 0.1);
    Moments moments;
    moments.add(a);
    moments.add(b);
    const auto fit = fit_line(moments);
    RC_ASSERT(fit.has_value());
    RC_ASSERT(fit->distance_m(a) < 1e-7);
    RC_ASSERT(fit->distance_m(b) < 1e-7);
    RC_ASSERT(std::abs(fit->direction.norm() - 1.0) < 1e-12);
  }));
}

TEST(LineFit, HasASignAlongEveryAxis) {
  for (int axis = 0; axis < 3; ++axis) {
    Moments moments;
    for (int i = 5; i >= 0; --i) {
      moments.add(-1.0 * i * Vector3d::Unit(axis));
    }
    EXPECT_EQ(fit_line(moments)->direction, Vector3d(Vector3d::Unit(axis)));
  }
}

TEST(LineFit, GivesNothingWherePointsDetermineNone) {
  const Vector3d p(1.5, 2.5, -3.5);
  EXPECT_FALSE(fit_line(PointsView{}).has_value()) << "empty";
  EXPECT_FALSE(fit_line(cloud_of({p}).view()).has_value()) << "one point";
  EXPECT_FALSE(fit_line(cloud_of({p, p}).view()).has_value()) << "one place";
  EXPECT_FALSE(fit_line(cloud_of(std::vector<Vector3d>(1000, p)).view()).has_value()) << "identical";
  EXPECT_FALSE(fit_line(cloud_of(std::vector<Vector3d>(10, {kNan, kNan, kNan})).view()).has_value()) << "all NaN";
  EXPECT_FALSE(fit_line(cloud_of(std::vector<Vector3d>(10, {kInf, 0.0, 0.0})).view()).has_value()) << "all Inf";
  EXPECT_FALSE(
      fit_line(cloud_of({{0.0, 0.0, 0.0}, {1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {1.0, 1.0, 0.0}}).view()).has_value())
      << "a square is as broad as long";
}

TEST(LineFit, SurvivesBadAndHugePoints) {
  auto points_m = edge(100, 0.01, 2);
  points_m.emplace_back(kNan, 0.0, 0.0);
  const auto fit = fit_line(cloud_of(points_m).view());
  ASSERT_TRUE(fit.has_value());
  EXPECT_EQ(fit->count, 100U);
  const auto huge = fit_line(cloud_of({{kHuge, kHuge, 0.0}, {-kHuge, -kHuge, 0.0}}).view());
  ASSERT_TRUE(huge.has_value());
  EXPECT_NEAR(huge->direction.x(), std::sqrt(0.5), 1e-12);
}

TEST(LineFit, WeighsPoints) {
  const PointCloud cloud = cloud_of({{0.0, 0.0, 0.0}, {1.0, 0.0, 0.0}, {2.0, 0.0, 0.0}, {1.0, 9.0, 0.0}});
  const auto fit = fit_line(cloud.view(), std::vector<double>{1.0, 1.0, 1.0, 0.0});
  ASSERT_TRUE(fit.has_value());
  EXPECT_LT(angle_rad(fit->direction, Vector3d::UnitX()), 1e-9);
}

TEST(LineFit, RobustlyIgnoresWhatLiesBeside) {
  // A wall beside the first half of the line, and things strewn about: 40 % of all points.
  auto points_m = edge(300, 0.02, 3);
  Noise noise(4);
  for (int i = 0; i < 100; ++i) {
    points_m.emplace_back(kPlace_m + (5.0 + noise.even(5.0)) * kDirection + Vector3d(noise.even(0.05), 1.0, 1.0));
    points_m.emplace_back(kPlace_m + Vector3d(noise.even(8.0), noise.even(8.0), noise.even(8.0)));
  }
  points_m.emplace_back(kHuge, 0.0, 0.0);
  points_m.emplace_back(kNan, 0.0, 0.0);
  const PointCloud cloud = cloud_of(points_m);
  const auto robust = fit_line_robust(cloud.view(), {});
  ASSERT_TRUE(robust.has_value());
  EXPECT_LT(angle_rad(robust->direction, kDirection), 2e-3);
  EXPECT_LT(robust->distance_m(kPlace_m), 0.02);
}

TEST(LineFit, RobustGivesNothingWherePointsDetermineNone) {
  EXPECT_FALSE(fit_line_robust({}, {}).has_value());
  EXPECT_FALSE(fit_line_robust(cloud_of({{1.0, 2.0, 3.0}}).view(), {}).has_value());
  EXPECT_FALSE(fit_line_robust(cloud_of(std::vector<Vector3d>(9, {kNan, 0.0, 0.0})).view(), {}).has_value());
  EXPECT_FALSE(fit_line_robust(cloud_of(std::vector<Vector3d>(9, {1.0, 0.0, 0.0})).view(), {}).has_value());
  EXPECT_TRUE(fit_line_robust(cloud_of({{1.0, 2.0, 3.0}, {2.0, 2.0, 3.0}}).view(), {}).has_value());
}

}  // namespace
}  // namespace berm
