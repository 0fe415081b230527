#include "berm/geometry/plane_fit.hpp"

#include <cmath>
#include <vector>

#include <Eigen/Geometry>
#include <gtest/gtest.h>
#include <rapidcheck.h>

#include "berm/core/error.hpp"
#include "geometry/made_points.hpp"

namespace berm {
namespace {

using Eigen::Vector3d;
using test::cloud_of;
using test::kHuge;
using test::kInf;
using test::kNan;
using test::Noise;

double normal_angle_rad(const Vector3d& a, const Vector3d& b) {
  return std::atan2(a.cross(b).norm(), std::abs(a.dot(b)));
}

/// Points of z = 0.3 x - 0.2 y + 1 with noise across it.
std::vector<Vector3d> slope(int count, double noise_m, unsigned seed) {
  Noise noise(seed);
  std::vector<Vector3d> points_m;
  for (int i = 0; i < count; ++i) {
    const double x = noise.even(5.0);
    const double y = noise.even(5.0);
    points_m.emplace_back(x, y, 0.3 * x - 0.2 * y + 1.0 + noise.normal(noise_m));
  }
  return points_m;
}

const Vector3d kSlopeNormal = Vector3d(-0.3, 0.2, 1.0).normalized();

TEST(PlaneFit, FindsAPlaneAndItsQuality) {
  const auto fit = fit_plane(cloud_of(slope(2000, 0.02, 1)).view());
  ASSERT_TRUE(fit.has_value());
  EXPECT_LT(normal_angle_rad(fit->normal, kSlopeNormal), 5e-4);
  EXPECT_GT(fit->normal.z(), 0.0);
  EXPECT_NEAR(fit->rms_m, 0.02 * kSlopeNormal.z(), 1e-3);
  EXPECT_NEAR(fit->rms_m, std::sqrt(fit->eigenvalues_m2[0]), 1e-15);
  EXPECT_EQ(fit->count, 2000U);
  EXPECT_EQ(fit->weight, 2000.0);
  EXPECT_LE(fit->eigenvalues_m2[0], fit->eigenvalues_m2[1]);
  EXPECT_LE(fit->eigenvalues_m2[1], fit->eigenvalues_m2[2]);
  EXPECT_GT(fit->distance_m({0.0, 0.0, 3.0}), 0.0);
  EXPECT_LT(fit->distance_m({0.0, 0.0, -3.0}), 0.0);
}

TEST(PlaneFit, OfThreePointsPassesThroughThem) {
  EXPECT_TRUE(rc::check("also far from the origin", [] {
    Noise noise(*rc::gen::arbitrary<unsigned>());
    const Vector3d offset_m = Vector3d(noise.even(1.0), noise.even(1.0), noise.even(1.0)) * *rc::gen::element(0.0, 5e6);
    std::vector<Vector3d> points_m;
    Moments moments;
    for (int i = 0; i < 3; ++i) {
      points_m.emplace_back(Vector3d(noise.even(10.0), noise.even(10.0), noise.even(10.0)) + offset_m);
      moments.add(points_m.back());
    }
    const Vector3d normal = (points_m[1] - points_m[0]).cross(points_m[2] - points_m[0]);
    RC_PRE(normal.norm() > 1.0);
    const auto fit = fit_plane(moments);
    RC_ASSERT(fit.has_value());
    for (const Vector3d& p : points_m) {
      RC_ASSERT(std::abs(fit->distance_m(p)) < 1e-7);
    }
    RC_ASSERT(normal_angle_rad(fit->normal, normal) < 1e-6);
  }));
}

TEST(PlaneFit, IsBetterThanAnyPlaneNearby) {
  EXPECT_TRUE(rc::check("sum of squared distances against turned and shifted planes", [] {
    const auto points_m = slope(50, 0.3, *rc::gen::arbitrary<unsigned>());
    const auto fit = fit_plane(cloud_of(points_m).view());
    RC_ASSERT(fit.has_value());
    const auto cost = [&](const Vector3d& normal, double shift_m) {
      double sum = 0.0;
      for (const Vector3d& p : points_m) {
        sum += std::pow(normal.dot(p - fit->centroid_m) - shift_m, 2);
      }
      return sum;
    };
    const double best = cost(fit->normal, 0.0);
    RC_ASSERT(std::abs(std::sqrt(best / 50.0) - fit->rms_m) < 1e-5);
    Noise noise(*rc::gen::arbitrary<unsigned>());
    for (int i = 0; i < 20; ++i) {
      const Vector3d turned = fit->normal + Vector3d(noise.even(0.1), noise.even(0.1), noise.even(0.1));
      RC_ASSERT(cost(turned.normalized(), noise.even(0.1)) >= best - 1e-4);
    }
  }));
}

TEST(PlaneFit, TurnsWithItsPoints) {
  for (const Vector3d& normal : {Vector3d(0.0, 0.0, 1.0), Vector3d(0.0, 1.0, 0.0), Vector3d(1.0, 0.0, 0.0)}) {
    const Vector3d u = normal.unitOrthogonal();
    const Vector3d v = normal.cross(u);
    Moments moments;
    Noise noise(3);
    for (int i = 0; i < 100; ++i) {
      moments.add(2.0 * normal + noise.even(3.0) * u + noise.even(1.0) * v);
    }
    const auto fit = fit_plane(moments);
    ASSERT_TRUE(fit.has_value());
    EXPECT_LT((fit->normal - normal).norm(), 1e-9) << "walls have a sign as well: " << fit->normal.transpose();
  }
}

TEST(PlaneFit, WeighsPoints) {
  std::vector<Vector3d> points_m = slope(100, 0.0, 4);
  std::vector<double> weights(100, 1.0);
  points_m.emplace_back(0.0, 0.0, 50.0);
  weights.push_back(0.0);
  const auto fit = fit_plane(cloud_of(points_m).view(), weights);
  ASSERT_TRUE(fit.has_value());
  EXPECT_EQ(fit->count, 100U);
  EXPECT_LT(normal_angle_rad(fit->normal, kSlopeNormal), 1e-6);
  weights.back() = 1.0;
  EXPECT_GT(normal_angle_rad(fit_plane(cloud_of(points_m).view(), weights)->normal, kSlopeNormal), 1e-3);
}

TEST(PlaneFit, GivesNothingWherePointsDetermineNone) {
  const Vector3d p(1.5, 2.5, -3.5);
  EXPECT_FALSE(fit_plane(PointsView{}).has_value()) << "empty";
  EXPECT_FALSE(fit_plane(cloud_of({p}).view()).has_value()) << "one point";
  EXPECT_FALSE(fit_plane(cloud_of({p, 2.0 * p}).view()).has_value()) << "two points";
  EXPECT_FALSE(fit_plane(cloud_of(std::vector<Vector3d>(1000, p)).view()).has_value()) << "identical";
  EXPECT_FALSE(fit_plane(cloud_of(std::vector<Vector3d>(10, {0.0, 0.0, 0.0})).view()).has_value()) << "at the origin";
  EXPECT_FALSE(fit_plane(cloud_of(std::vector<Vector3d>(10, {kNan, kNan, kNan})).view()).has_value()) << "all NaN";
  EXPECT_FALSE(fit_plane(cloud_of(std::vector<Vector3d>(10, {kInf, -kInf, 0.0})).view()).has_value()) << "all Inf";
  std::vector<Vector3d> cube_m;
  for (int corner = 0; corner < 8; ++corner) {
    cube_m.emplace_back(corner & 1, (corner >> 1) & 1, corner >> 2);
  }
  EXPECT_FALSE(fit_plane(cloud_of(cube_m).view()).has_value()) << "as thick as wide";
}

TEST(PlaneFit, GivesNothingForPointsOnALine) {
  EXPECT_TRUE(rc::check("in any direction, at any distance", [] {
    Noise noise(*rc::gen::arbitrary<unsigned>());
    const Vector3d start_m = 1000.0 * Vector3d(noise.even(1.0), noise.even(1.0), noise.even(1.0));
    const Vector3d along(noise.even(1.0), noise.even(1.0), noise.even(1.0));
    RC_PRE(along.norm() > 0.1);
    Moments moments;
    for (int i = 0; i < 100; ++i) {
      moments.add(start_m + noise.even(50.0) * along);
    }
    RC_ASSERT(!fit_plane(moments).has_value());
  }));
}

TEST(PlaneFit, SurvivesBadAndHugePoints) {
  auto points_m = slope(100, 0.01, 5);
  points_m.insert(points_m.begin() + 50, {kNan, 0.0, 0.0});
  points_m.emplace_back(0.0, kInf, 0.0);
  const auto fit = fit_plane(cloud_of(points_m).view());
  ASSERT_TRUE(fit.has_value());
  EXPECT_EQ(fit->count, 100U);
  EXPECT_LT(normal_angle_rad(fit->normal, kSlopeNormal), 1e-2);

  const auto huge = fit_plane(cloud_of({{kHuge, 0.0, 0.0}, {-kHuge, 1.0, 0.0}, {0.0, kHuge, kHuge}}).view());
  ASSERT_TRUE(huge.has_value());
  EXPECT_TRUE(huge->normal.allFinite());
  Moments overflow;
  for (const double x : {1e200, -1e200, 1e180}) {
    overflow.add({x, x * x > 0 ? 1.0 : 0.0, 2.0 * x});
  }
  EXPECT_FALSE(fit_plane(overflow).has_value());
}

TEST(PlaneFit, RobustlyIgnoresWhatStandsOnThePlane) {
  // 40 % of the points are a wall on one side: the worst kind, as it pulls in one direction.
  auto points_m = slope(600, 0.02, 6);
  Noise noise(7);
  for (int i = 0; i < 400; ++i) {
    points_m.emplace_back(4.0 + noise.even(0.2), noise.even(4.0), 4.0 + noise.even(1.5));
  }
  const PointCloud cloud = cloud_of(points_m);
  const auto plain = fit_plane(cloud.view());
  const auto robust = fit_plane_robust(cloud.view(), {});
  ASSERT_TRUE(plain.has_value());
  ASSERT_TRUE(robust.has_value());
  EXPECT_GT(normal_angle_rad(plain->normal, kSlopeNormal), 0.1);
  EXPECT_LT(normal_angle_rad(robust->normal, kSlopeNormal), 2e-3);
  EXPECT_NEAR(robust->distance_m({0.0, 0.0, 1.0}), 0.0, 5e-3);
  EXPECT_LT(robust->rms_m, 0.05);
}

TEST(PlaneFit, RobustEqualsPlainWithoutOutliers) {
  const PointCloud cloud = cloud_of(slope(500, 0.0, 8));
  const auto plain = fit_plane(cloud.view());
  const auto robust = fit_plane_robust(cloud.view(), {});
  ASSERT_TRUE(robust.has_value());
  EXPECT_LT(normal_angle_rad(plain->normal, robust->normal), 1e-6);
}

TEST(PlaneFit, RobustGivesTheSameTwiceAndNothingWhereThereIsNone) {
  const PointCloud cloud = cloud_of(slope(200, 0.1, 9));
  EXPECT_EQ(fit_plane_robust(cloud.view(), {})->normal, fit_plane_robust(cloud.view(), {})->normal);
  EXPECT_FALSE(fit_plane_robust({}, {}).has_value());
  EXPECT_FALSE(fit_plane_robust(cloud_of({{1.0, 2.0, 3.0}, {2.0, 3.0, 4.0}}).view(), {}).has_value());
  EXPECT_FALSE(fit_plane_robust(cloud_of(std::vector<Vector3d>(9, {kNan, 0.0, 0.0})).view(), {}).has_value());
  auto points_m = slope(200, 0.01, 10);
  points_m.emplace_back(kNan, kNan, kNan);
  points_m.emplace_back(kHuge, kHuge, kHuge);
  const auto fit = fit_plane_robust(cloud_of(points_m).view(), {.max_iterations = 300});
  ASSERT_TRUE(fit.has_value());
  EXPECT_LT(normal_angle_rad(fit->normal, kSlopeNormal), 5e-3) << "one absurd point must not decide";
}

TEST(PlaneFit, RobustChecksItsConfiguration) {
  const PointCloud cloud = cloud_of(slope(20, 0.1, 11));
  EXPECT_THROW((void)fit_plane_robust(cloud.view(), {.scale_m = 0.0}), ConfigError);
  EXPECT_THROW((void)fit_plane_robust(cloud.view(), {.scale_m = static_cast<double>(kNan)}), ConfigError);
  EXPECT_THROW((void)fit_plane_robust(cloud.view(), {.max_iterations = 0}), ConfigError);
}

}  // namespace
}  // namespace berm
