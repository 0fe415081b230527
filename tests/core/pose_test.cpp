#include "berm/core/pose.hpp"

#include <array>
#include <cmath>
#include <limits>

#include <gtest/gtest.h>
#include <rapidcheck.h>

namespace berm {
namespace {

using Eigen::Matrix3d;
using Eigen::Quaterniond;
using Eigen::Vector3d;

constexpr double kPi = 3.14159265358979323846;

/// Angles around which the formulas change: identity, the switch to the series (1e-4, 2e-4 for half angles), pi.
constexpr std::array kAngles_rad = {0.0,  1e-300, 1e-12, 1e-8, 0.99e-4, 1e-4,       1.01e-4,    1.99e-4, 2e-4,
                                    1e-3, 0.1,    1.0,   3.0,  3.14,    kPi - 1e-6, kPi - 1e-9, kPi};

double gen_double(double low, double high) {
  return low + (high - low) * *rc::gen::inRange(0, 1'000'001) * 1e-6;
}

Vector3d gen_vector(double size) {
  return {gen_double(-size, size), gen_double(-size, size), gen_double(-size, size)};
}

Vector3d gen_axis() {
  const Vector3d v = gen_vector(1.0);
  return v.norm() > 1e-3 ? v.normalized() : Vector3d(0.0, 0.6, -0.8);
}

/// Rotational parts of all sizes up to pi, the odd angles as often as all others together.
Vector3d gen_rotation() {
  const double angle = *rc::gen::arbitrary<bool>() ? *rc::gen::elementOf(kAngles_rad) : gen_double(0.0, kPi);
  return angle * gen_axis();
}

Pose gen_pose(double size_m) {
  const Vector3d rotation_rad = gen_rotation();
  Vector6d twist;
  twist << Vector3d::Zero(), rotation_rad;
  return {Pose::exp(twist).rotation(), gen_vector(size_m)};
}

double difference(const Pose& a, const Pose& b) {
  return (a.matrix() - b.matrix()).cwiseAbs().maxCoeff();
}

Vector6d twist_of(const Vector3d& translation_m, const Vector3d& rotation_rad) {
  Vector6d twist;
  twist << translation_m, rotation_rad;
  return twist;
}

TEST(Pose, IsIdentityByDefault) {
  EXPECT_TRUE(Pose().matrix().isIdentity(0.0));
  EXPECT_TRUE(Pose().log().isZero(0.0));
  EXPECT_EQ(Pose() * Vector3d(1.0, 2.0, 3.0), Vector3d(1.0, 2.0, 3.0));
}

TEST(Pose, IsAGroup) {
  EXPECT_TRUE(rc::check("associative", [] {
    const Pose a = gen_pose(100.0);
    const Pose b = gen_pose(100.0);
    const Pose c = gen_pose(100.0);
    RC_ASSERT(difference((a * b) * c, a * (b * c)) < 1e-12);
  }));
  EXPECT_TRUE(rc::check("inverse from both sides", [] {
    const Pose a = gen_pose(100.0);
    RC_ASSERT(difference(a * a.inverse(), Pose()) < 1e-12);
    RC_ASSERT(difference(a.inverse() * a, Pose()) < 1e-12);
  }));
  EXPECT_TRUE(rc::check("neutral element", [] {
    const Pose a = gen_pose(100.0);
    RC_ASSERT(difference(a * Pose(), a) < 1e-15);
    RC_ASSERT(difference(Pose() * a, a) < 1e-15);
  }));
}

TEST(Pose, ActsOnPoints) {
  EXPECT_TRUE(rc::check("(a b) p = a (b p), as the matrices say, and lengths stay", [] {
    const Pose a = gen_pose(100.0);
    const Pose b = gen_pose(100.0);
    const Vector3d p = gen_vector(100.0);
    const Vector3d q = gen_vector(100.0);
    RC_ASSERT(((a * b) * p - a * (b * p)).norm() < 1e-11);
    RC_ASSERT((a * p - (a.matrix() * p.homogeneous()).head<3>()).norm() < 1e-11);
    RC_ASSERT(std::abs((a * p - a * q).norm() - (p - q).norm()) < 1e-11);
  }));
}

TEST(Pose, TurnsTheWayTheDocumentationSays) {
  const Vector3d none = Vector3d::Zero();
  const Vector3d ahead = Vector3d::UnitX();
  EXPECT_TRUE((Pose::from_yaw_pitch_roll(0.5 * kPi, 0.0, 0.0, none) * ahead).isApprox(Vector3d::UnitY(), 1e-15))
      << "yaw turns ahead to the left";
  EXPECT_TRUE((Pose::from_yaw_pitch_roll(0.0, 0.5 * kPi, 0.0, none) * ahead).isApprox(-Vector3d::UnitZ(), 1e-15))
      << "positive pitch is nose down";
  EXPECT_TRUE(
      (Pose::from_yaw_pitch_roll(0.0, 0.0, 0.5 * kPi, none) * Vector3d::UnitY()).isApprox(Vector3d::UnitZ(), 1e-15))
      << "positive roll lifts the left side";
  const Pose all = Pose::from_yaw_pitch_roll(0.3, 0.2, 0.1, {1.0, 2.0, 3.0});
  const Pose steps = Pose::from_yaw_pitch_roll(0.3, 0.0, 0.0, {1.0, 2.0, 3.0}) *
                     Pose::from_yaw_pitch_roll(0.0, 0.2, 0.0, none) * Pose::from_yaw_pitch_roll(0.0, 0.0, 0.1, none);
  EXPECT_LT(difference(all, steps), 1e-15);
}

TEST(Pose, ExpIsTheSumOfItsSeries) {
  EXPECT_TRUE(rc::check("exp(xi) = sum of hat(xi)^k / k!", [] {
    const Vector6d twist = twist_of(gen_vector(10.0), gen_rotation());
    Eigen::Matrix4d hat = Eigen::Matrix4d::Zero();
    hat << 0.0, -twist[5], twist[4], twist[0], twist[5], 0.0, -twist[3], twist[1], -twist[4], twist[3], 0.0, twist[2],
        0.0, 0.0, 0.0, 0.0;
    Eigen::Matrix4d sum = Eigen::Matrix4d::Identity();
    Eigen::Matrix4d term = Eigen::Matrix4d::Identity();
    for (int k = 1; k < 40; ++k) {
      term = term * hat / k;
      sum += term;
    }
    RC_ASSERT((Pose::exp(twist).matrix() - sum).cwiseAbs().maxCoeff() < 1e-12);
  }));
}

TEST(Pose, ComesBackFromLogToExp) {
  for (const double angle : kAngles_rad) {
    for (const Vector3d& axis :
         {Vector3d(1.0, 0.0, 0.0), Vector3d(0.0, -1.0, 0.0), Vector3d(0.0, 0.0, 1.0), Vector3d(0.48, -0.6, 0.64)}) {
      const Pose pose = Pose::exp(twist_of({100.0, -20.0, 3.0}, angle * axis));
      EXPECT_LT(difference(Pose::exp(pose.log()), pose), 1e-12) << angle << " about " << axis.transpose();
    }
  }
  EXPECT_TRUE(rc::check("exp(log(T)) = T", [] {
    const Pose pose = gen_pose(100.0);
    RC_ASSERT(difference(Pose::exp(pose.log()), pose) < 1e-12);
  }));
}

TEST(Pose, ComesBackFromExpToLogBelowPi) {
  EXPECT_TRUE(rc::check("log(exp(xi)) = xi", [] {
    const Vector3d rotation_rad = gen_rotation();
    RC_PRE(rotation_rad.norm() < kPi - 1e-10);
    const Vector6d twist = twist_of(gen_vector(100.0), rotation_rad);
    const double error = (Pose::exp(twist).log() - twist).cwiseAbs().maxCoeff();
    // Near pi the rotation is determined as well as anywhere, but its axis turns the translation by about as much.
    RC_ASSERT(error < 1e-11);
  }));
}

TEST(Pose, KeepsTinyRotationsExactly) {
  for (const double angle : {1e-300, 1e-100, 1e-15, 1e-12, 1e-9, 1e-8}) {
    const Vector6d twist = twist_of({1.0, 2.0, 3.0}, {angle, 0.0, 0.0});
    const Vector6d back = Pose::exp(twist).log();
    EXPECT_NEAR(back[3] / angle, 1.0, 1e-14) << angle;
  }
}

TEST(Pose, HasNoStepAtTheSwitchToTheSeries) {
  // Both sides of the switch, 1e-11 apart: the poses differ by no more than that.
  for (const double threshold : {1e-4, 2e-4}) {
    const Vector3d translation_m(1000.0, -1000.0, 1000.0);
    const Vector3d axis = Vector3d(0.48, -0.6, 0.64);
    const Pose below = Pose::exp(twist_of(translation_m, (threshold - 5e-12) * axis));
    const Pose above = Pose::exp(twist_of(translation_m, (threshold + 5e-12) * axis));
    EXPECT_LT(difference(below, above), 2e-8);
    EXPECT_LT((below.log().head<3>() - translation_m).norm(), 1e-11);
    EXPECT_LT((above.log().head<3>() - translation_m).norm(), 1e-11);
  }
}

TEST(Pose, LogIsShortestAndTheSameForBothSignsOfTheQuaternion) {
  EXPECT_TRUE(rc::check("q and -q are one rotation, |log| <= pi", [] {
    const Pose pose = gen_pose(10.0);
    const Quaterniond q = pose.rotation();
    const Pose other(Quaterniond(-q.w(), -q.x(), -q.y(), -q.z()), pose.translation_m());
    RC_ASSERT(pose.log().tail<3>().norm() <= kPi + 1e-15);
    // At pi itself both axes are right.
    RC_PRE(std::abs(q.w()) > 1e-9);
    RC_ASSERT((pose.log() - other.log()).cwiseAbs().maxCoeff() < 1e-9);
  }));
}

TEST(Pose, LogOfExactlyHalfATurnIsHalfATurn) {
  const Pose half_turn(Quaterniond(0.0, 0.0, 0.0, 1.0), {2.0, 0.0, 0.0});
  const Vector6d twist = half_turn.log();
  EXPECT_NEAR(twist.tail<3>().norm(), kPi, 1e-15);
  EXPECT_LT(difference(Pose::exp(twist), half_turn), 1e-15);
}

TEST(Pose, LeftJacobianTurnsChangesOfTheVectorIntoRotationsOnTheLeft) {
  EXPECT_TRUE(rc::check("column i of V is the rotation that a step along i adds on the left", [] {
    const Vector3d rotation_rad = gen_rotation();
    // At pi a step changes the sign of the logarithm; V itself is smooth there.
    RC_PRE(rotation_rad.norm() < 3.1);
    const Pose pose = Pose::exp(twist_of(Vector3d::Zero(), rotation_rad));
    constexpr double kStep_rad = 1e-5;
    for (int i = 0; i < 3; ++i) {
      const Vector3d column = Pose::exp(twist_of(Vector3d::Unit(i), rotation_rad)).translation_m();
      const Vector3d step = kStep_rad * Vector3d::Unit(i);
      const Pose ahead = Pose::exp(twist_of(Vector3d::Zero(), rotation_rad + step));
      const Pose back = Pose::exp(twist_of(Vector3d::Zero(), rotation_rad - step));
      const Vector3d numeric = ((ahead * pose.inverse()).log() - (back * pose.inverse()).log()).tail<3>();
      RC_ASSERT((numeric / (2.0 * kStep_rad) - column).norm() < 1e-9);
    }
  }));
}

TEST(Pose, InterpolationEndsWhereItShould) {
  EXPECT_TRUE(rc::check("s = 0, s = 1", [] {
    const Pose a = gen_pose(100.0);
    const Pose b = gen_pose(100.0);
    RC_ASSERT(difference(interpolate(a, b, 0.0), a) < 1e-11);
    RC_ASSERT(difference(interpolate(a, b, 1.0), b) < 1e-11);
    RC_ASSERT(difference(interpolate(a, a, gen_double(0.0, 1.0)), a) < 1e-11);
  }));
}

TEST(Pose, InterpolationMovesEvenly) {
  EXPECT_TRUE(rc::check("halfway takes the same motion twice; equal shares are equal motions", [] {
    const Pose a = gen_pose(10.0);
    const Pose b = gen_pose(10.0);
    // Exactly half a turn has two shortest ways.
    RC_PRE((a.inverse() * b).log().tail<3>().norm() < kPi - 1e-3);
    const Pose middle = interpolate(a, b, 0.5);
    RC_ASSERT(difference(a.inverse() * middle, middle.inverse() * b) < 1e-10);
    const double s = gen_double(0.0, 0.75);
    const Pose first = interpolate(a, b, 0.0).inverse() * interpolate(a, b, 0.25);
    const Pose later = interpolate(a, b, s).inverse() * interpolate(a, b, s + 0.25);
    RC_ASSERT(difference(first, later) < 1e-10);
  }));
  EXPECT_TRUE(rc::check("the same from the other end", [] {
    const Pose a = gen_pose(10.0);
    const Pose b = gen_pose(10.0);
    RC_PRE((a.inverse() * b).log().tail<3>().norm() < kPi - 1e-3);
    const double s = gen_double(0.0, 1.0);
    RC_ASSERT(difference(interpolate(a, b, s), interpolate(b, a, 1.0 - s)) < 1e-9);
  }));
}

TEST(Pose, IsBuiltFromMatrices) {
  EXPECT_TRUE(rc::check("from_matrix is the inverse of matrix", [] {
    const Pose pose = gen_pose(100.0);
    RC_ASSERT(difference(Pose::from_matrix(pose.matrix().topRows<3>()), pose) < 1e-12);
  }));
}

TEST(Pose, StaysARotationAfterAMillionProducts) {
  const Pose step = Pose::from_yaw_pitch_roll(1e-3, 2e-4, -3e-4, {0.01, 0.0, 0.0});
  Pose pose;
  for (int i = 0; i < 1'000'000; ++i) {
    pose = pose * step;
  }
  const Matrix3d rotation = pose.matrix().topLeftCorner<3, 3>();
  EXPECT_LT((rotation * rotation.transpose() - Matrix3d::Identity()).norm(), 1e-14);
}

TEST(Pose, NormalisesItsQuaternion) {
  const Pose pose(Quaterniond(2.0, 0.0, 0.0, 2.0), Vector3d::Zero());
  EXPECT_NEAR(pose.rotation().norm(), 1.0, 1e-15);
  EXPECT_TRUE((pose * Vector3d::UnitX()).isApprox(Vector3d::UnitY(), 1e-15));
}

}  // namespace
}  // namespace berm
