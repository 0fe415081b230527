#include "feature/feature_match.hpp"

#include <array>
#include <cmath>
#include <optional>

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include "feature/feature_map.hpp"

namespace berm {
namespace {

double unit() {
  return *rc::gen::inRange(-10000, 10001) * 1e-4;
}

Eigen::Vector3d any_point_m(double size_m) {
  return {size_m * unit(), size_m * unit(), size_m * unit()};
}

/// Turns by nothing, by what a scan turns, and by much.
Displacement any_displacement() {
  const double turn_rad = *rc::gen::element(0.0, 1e-6, 1e-3, 0.1, 1.5);
  Displacement displacement;
  displacement << any_point_m(2.0), turn_rad * any_point_m(1.0);
  return displacement;
}

FeatureMatch any_match(bool on_line) {
  const Eigen::Vector3d axis = any_point_m(1.0);
  return {.base_m = any_point_m(30.0),
          .share = *rc::gen::element(0.0, 0.3, 1.0),
          .anchor_m = any_point_m(30.0),
          .axis = axis.norm() > 0.1 ? Eigen::Vector3d(axis.normalized()) : Eigen::Vector3d::UnitZ(),
          .on_line = on_line};
}

Vector6d numeric_gradient(const FeatureMatch& match, const Displacement& at) {
  constexpr double kStep = 1e-6;
  Vector6d gradient;
  for (int i = 0; i < 6; ++i) {
    const Displacement step = kStep * Displacement::Unit(i);
    gradient[i] = (residual_m(match, at + step, nullptr) - residual_m(match, at - step, nullptr)) / (2.0 * kStep);
  }
  return gradient;
}

TEST(FeatureMatch, GradientsAreThoseOfTheResiduals) {
  EXPECT_TRUE(rc::check([] {
    const FeatureMatch match = any_match(*rc::gen::arbitrary<bool>());
    const Displacement displacement = any_displacement();
    Vector6d gradient;
    const double distance_m = residual_m(match, displacement, &gradient);
    RC_PRE(!match.on_line || distance_m > 0.1);  // the distance to a line has a kink at 0
    RC_ASSERT((gradient - numeric_gradient(match, displacement)).norm() < 1e-5 * (1.0 + gradient.norm()));
  }));
}

TEST(FeatureMatch, OnTheLineNothingPulls) {
  const FeatureMatch match{.base_m = {1.0, 2.0, 3.0},
                           .share = 1.0,
                           .anchor_m = {1.0, 2.0, 0.0},
                           .axis = Eigen::Vector3d::UnitZ(),
                           .on_line = true};
  Vector6d gradient;
  EXPECT_EQ(residual_m(match, Displacement::Zero(), &gradient), 0.0);
  EXPECT_EQ(gradient, Vector6d::Zero());
}

TEST(FeatureMatch, ADisplacementIsThePoseOfItsRotationVector) {
  EXPECT_TRUE(rc::check([] {
    const Displacement displacement = any_displacement();
    const Eigen::Vector3d base_m = any_point_m(30.0);
    const double share = *rc::gen::element(0.0, 0.4, 1.0);
    Vector6d turn = share * displacement;
    turn.head<3>().setZero();
    const Pose pose(Pose::exp(turn).rotation(), share * displacement.head<3>());
    RC_ASSERT((displaced_m(displacement, base_m, share) - pose * base_m).norm() < 1e-9);
  }));
}

/// Five points, nearest first, spread by `along_m` on their plane or line.
std::array<Eigen::Vector3d, 5> five(const Eigen::Vector3d& u, const Eigen::Vector3d& v) {
  return {Eigen::Vector3d(5.0, 1.0, 2.0), Eigen::Vector3d(5.0, 1.0, 2.0) + u, Eigen::Vector3d(5.0, 1.0, 2.0) - u + v,
          Eigen::Vector3d(5.0, 1.0, 2.0) - v, Eigen::Vector3d(5.0, 1.0, 2.0) + u + v};
}

TEST(FeatureSurface, ResidualOfAPlaneIsEquation11) {
  const auto points_m = five({0.4, 0.0, 0.1}, {0.0, 0.5, 0.2});
  const auto plane = surface_through(points_m, false);
  ASSERT_TRUE(plane);
  const Eigen::Vector3d p(4.0, 3.0, 1.0);
  const FeatureMatch match{
      .base_m = p, .share = 1.0, .anchor_m = plane->anchor_m, .axis = plane->axis, .on_line = false};
  const Eigen::Vector3d normal = (points_m[2] - points_m[4]).cross(points_m[2] - points_m[0]);
  const double expected_m = (p - points_m[0]).dot(normal) / normal.norm();
  EXPECT_GT(std::abs(expected_m), 0.1);
  EXPECT_NEAR(residual_m(match, Displacement::Zero(), nullptr), expected_m, 1e-12);
}

TEST(FeatureSurface, ResidualOfALineIsEquation12) {
  const Eigen::Vector3d along_m(0.1, 0.0, 0.5);
  std::array<Eigen::Vector3d, 5> points_m;
  for (int i = 0; i < 5; ++i) {
    points_m[static_cast<std::size_t>(i)] = Eigen::Vector3d(5.0, 1.0, 2.0) + i * along_m;
  }
  const auto line = surface_through(points_m, true);
  ASSERT_TRUE(line);
  const Eigen::Vector3d p(4.0, 3.0, 1.0);
  const FeatureMatch match{.base_m = p, .share = 1.0, .anchor_m = line->anchor_m, .axis = line->axis, .on_line = true};
  const double expected_m = (p - points_m[4]).cross(p - points_m[0]).norm() / (points_m[4] - points_m[0]).norm();
  EXPECT_NEAR(residual_m(match, Displacement::Zero(), nullptr), expected_m, 1e-12);
}

TEST(FeatureSurface, EigenvaluesDecide) {
  const Eigen::Vector3d x(0.5, 0.0, 0.0);
  const Eigen::Vector3d y(0.0, 0.5, 0.0);
  EXPECT_TRUE(surface_through(five(x, y), false));
  EXPECT_FALSE(surface_through(five(x, y), true)) << "a plane is no line";
  EXPECT_FALSE(surface_through(five(x, 0.01 * y), false)) << "a line is no plane";
  EXPECT_TRUE(surface_through(five(x, 0.01 * y), true));
  EXPECT_FALSE(surface_through(five(0.0 * x, 0.0 * y), false)) << "points at one place";
  EXPECT_FALSE(surface_through(five(0.0 * x, 0.0 * y), true));
}

}  // namespace
}  // namespace berm
