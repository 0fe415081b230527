#include "berm/sim/motion.hpp"

#include <cmath>
#include <functional>
#include <memory>
#include <numbers>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "berm/core/angle.hpp"
#include "berm/core/error.hpp"

namespace berm::sim {
namespace {

using Eigen::Vector3d;
using testing::HasSubstr;

constexpr double kRouteLength_m = 200.0;

/// Ground given by a formula.
class FormulaTerrain final : public Terrain {
 public:
  using Formula = std::function<double(double, double)>;
  explicit FormulaTerrain(Formula height_m) : height_m_(std::move(height_m)) {}
  [[nodiscard]] GroundSample at(double x_m, double y_m) const override {
    GroundSample sample;
    sample.height_m = height_m_(x_m, y_m);
    return sample;
  }

 private:
  Formula height_m_;
};

/// A straight route along x, or a circle to the left.
World make_world(FormulaTerrain::Formula height_m, double radius_m = 0.0) {
  std::vector<RoutePoint> points;
  for (double s_m = 0.0; s_m <= kRouteLength_m; s_m += 1.0) {
    const double turned = radius_m > 0.0 ? s_m / radius_m : 0.0;
    RoutePoint point;
    point.s_m = s_m;
    point.x_m = radius_m > 0.0 ? radius_m * std::sin(turned) : s_m;
    point.y_m = radius_m > 0.0 ? radius_m * (1.0 - std::cos(turned)) : 0.0;
    point.z_m = height_m(point.x_m, point.y_m);
    point.heading_rad = turned;
    point.left_m = 6.0;
    point.right_m = 6.0;
    points.push_back(point);
  }
  World world;
  world.area = {-500.0, -500.0, 500.0, 500.0};
  world.terrain = std::make_shared<FormulaTerrain>(std::move(height_m));
  world.route = Route(std::move(points));
  return world;
}

double flat(double /*x_m*/, double /*y_m*/) {
  return 0.0;
}

/// Drives straight on at one speed, without any shaking.
VehicleConfig steady() {
  VehicleConfig config;
  config.speed_m_per_s = 2.0;
  config.speed_change = 0.0;
  config.heave_m = 0.0;
  config.pitch_deg = 0.0;
  config.roll_deg = 0.0;
  config.hum_m = 0.0;
  config.wander_m = 0.0;
  return config;
}

double speed_at(const Trajectory& path, std::size_t i) {
  return (path.poses()[i + 1].T_world_base.translation_m() - path.poses()[i].T_world_base.translation_m()).norm() *
         kTruthHz;
}

double deviation(const std::vector<double>& values) {
  double sum = 0.0;
  double squares = 0.0;
  for (const double value : values) {
    sum += value;
    squares += value * value;
  }
  const double mean = sum / static_cast<double>(values.size());
  return std::sqrt(squares / static_cast<double>(values.size()) - mean * mean);
}

std::string error_of(const std::function<void()>& body) {
  try {
    body();
  } catch (const Error& error) {
    return error.what();
  }
  return "no error";
}

TEST(Drive, CoversTheTimeAndOneSampleMore) {
  const Trajectory path = drive(make_world(flat), steady(), 3.0, 1);
  EXPECT_EQ(path.poses().front().stamp_ns, 0);
  EXPECT_EQ(path.poses().back().stamp_ns, 3'010'000'000);
  EXPECT_EQ(path.size(), 302U);
  EXPECT_EQ(drive(make_world(flat), steady(), 0.0, 1).size(), 2U);
}

TEST(Drive, OnFlatGroundItGoesStraightAtItsSpeed) {
  const Trajectory path = drive(make_world(flat), steady(), 10.0, 1);
  for (std::size_t i = 0; i + 1 < path.size(); ++i) {
    EXPECT_NEAR(speed_at(path, i), 2.0, 1e-6);
    EXPECT_NEAR(path.poses()[i].T_world_base.log().tail<3>().norm(), 0.0, 1e-9);
  }
  EXPECT_NEAR(path.poses().front().T_world_base.translation_m().x(), 10.0, 1e-9);
}

TEST(Drive, OnASlopeItLiesInTheSlope) {
  const double gradient = std::tan(30.0 * kRadPerDeg);
  const auto slope = [&](double x_m, double y_m) { return gradient * x_m + 0.1 * y_m; };
  const Trajectory path = drive(make_world(slope), steady(), 5.0, 1);
  const Vector3d normal = Vector3d(-gradient, -0.1, 1.0).normalized();
  for (std::size_t i = 0; i + 1 < path.size(); ++i) {
    const Pose& pose = path.poses()[i].T_world_base;
    EXPECT_NEAR((pose.rotation() * Vector3d::UnitZ() - normal).norm(), 0.0, 1e-9);
    EXPECT_NEAR(pose.translation_m().z(), slope(pose.translation_m().x(), pose.translation_m().y()), 1e-9);
    EXPECT_NEAR((pose.rotation() * Vector3d::UnitX()).y(), 0.0, 1e-9) << "the nose follows the route on the map";
    EXPECT_NEAR(speed_at(path, i), 2.0, 0.01) << "measured on the ground, not on the map";
  }
}

TEST(Drive, TracksBridgeWhatIsShorterThanThey) {
  // Waves of 1 m and 5 cm: a machine of 4.5 m hardly feels them.
  const auto waves = [](double x_m, double) { return 0.05 * std::sin(2.0 * std::numbers::pi * x_m); };
  const Trajectory path = drive(make_world(waves), steady(), 10.0, 1);
  std::vector<double> heights;
  for (const StampedPose& pose : path.poses()) {
    heights.push_back(pose.T_world_base.translation_m().z());
  }
  EXPECT_LT(deviation(heights), 0.02);
}

TEST(Drive, InABendTheNosePointsAlongTheChord) {
  VehicleConfig config = steady();
  const Trajectory path = drive(make_world(flat, 25.0), config, 20.0, 1);
  for (std::size_t i = 0; i + 1 < path.size(); i += 100) {
    const Pose& pose = path.poses()[i].T_world_base;
    const double heading = 2.0 * std::atan2(pose.rotation().z(), pose.rotation().w());
    const double expected = (10.0 + 2.0 * static_cast<double>(i) / kTruthHz) / 25.0;
    EXPECT_NEAR(heading, expected, 1e-3);
    EXPECT_NEAR(speed_at(path, i), 2.0, 0.01);
  }
}

TEST(Drive, ShakesAsMuchAsItIsTold) {
  VehicleConfig config = steady();
  config.speed_m_per_s = 1.2;
  config.heave_m = 0.02;
  config.pitch_deg = 0.5;
  config.roll_deg = 0.3;
  config.hum_m = 0.002;
  config.wander_m = 0.4;
  const Trajectory path = drive(make_world(flat), config, 120.0, 5);
  std::vector<double> heave;
  std::vector<double> pitch;
  std::vector<double> roll;
  std::vector<double> stray;
  double product = 0.0;
  for (const StampedPose& stamped : path.poses()) {
    const Pose& pose = stamped.T_world_base;
    const Vector3d up = pose.rotation() * Vector3d::UnitZ();
    const Vector3d ahead = pose.rotation() * Vector3d::UnitX();
    heave.push_back(pose.translation_m().z());
    pitch.push_back(-std::asin(ahead.z()) / kRadPerDeg);
    roll.push_back(std::asin((pose.rotation() * Vector3d::UnitY()).z()) / kRadPerDeg);
    stray.push_back(pose.translation_m().y());
    product += heave.back() * pitch.back();
    EXPECT_GT(up.z(), 0.99);
  }
  EXPECT_NEAR(deviation(heave), 0.02, 0.005);
  EXPECT_NEAR(deviation(pitch), 0.5, 0.12);
  EXPECT_NEAR(deviation(roll), 0.3, 0.08);
  EXPECT_NEAR(deviation(stray), 0.4, 0.25);
  const double correlation = product / (static_cast<double>(heave.size()) * deviation(heave) * deviation(pitch));
  EXPECT_LT(correlation, -0.3) << "it lifts its nose as it rises";
}

TEST(Drive, HeavesAtOneHertzAndHumsAtSeventeen) {
  VehicleConfig config = steady();
  config.heave_m = 0.02;
  config.hum_m = 0.002;
  const Trajectory path = drive(make_world(flat), config, 90.0, 3);
  const auto power = [&path](double low_hz, double high_hz) {
    double sum = 0.0;
    for (double hz = low_hz; hz < high_hz; hz += 0.05) {
      double re = 0.0;
      double im = 0.0;
      for (std::size_t i = 0; i < path.size(); ++i) {
        const double angle = 2.0 * std::numbers::pi * hz * static_cast<double>(i) / kTruthHz;
        re += path.poses()[i].T_world_base.translation_m().z() * std::cos(angle);
        im += path.poses()[i].T_world_base.translation_m().z() * std::sin(angle);
      }
      sum += re * re + im * im;
    }
    return sum;
  };
  EXPECT_GT(power(0.7, 1.3), 3.0 * power(2.0, 15.0));
  EXPECT_GT(power(16.0, 18.0), 3.0 * power(8.0, 10.0));
  EXPECT_GT(power(16.0, 18.0), 3.0 * power(22.0, 24.0));
}

TEST(Drive, StopsTurnsOnTheSpotAndGoesOn) {
  VehicleConfig config = steady();
  config.stop_every_s = 10.0;
  config.stop_s = 2.0;
  config.turn_on_spot_deg = 60.0;
  const Trajectory path = drive(make_world(flat), config, 60.0, 2);
  std::size_t standing = 0;
  std::size_t stops = 0;
  double most_turned = 0.0;
  bool stood = false;
  for (std::size_t i = 0; i + 1 < path.size(); ++i) {
    const bool stands = speed_at(path, i) < 1e-9;
    stops += stands && !stood ? 1U : 0U;
    stood = stands;
    standing += stands ? 1U : 0U;
    const Eigen::Quaterniond& q = path.poses()[i].T_world_base.rotation();
    const double turned = 2.0 * std::atan2(q.z(), q.w()) / kRadPerDeg;
    most_turned = std::max(most_turned, turned);
    if (!stands) {
      EXPECT_NEAR(turned, 0.0, 1e-6) << "turned while it drives";
    }
  }
  EXPECT_NEAR(most_turned, 60.0, 0.1);
  EXPECT_GE(stops, 2U);
  EXPECT_GT(standing, 600U) << "6 s of turning alone";
  EXPECT_GT(path.poses().back().T_world_base.translation_m().x(), 40.0);
}

TEST(Drive, NothingJumpsFromSampleToSample) {
  VehicleConfig config;
  config.stop_every_s = 15.0;
  config.turn_on_spot_deg = -45.0;
  const auto bumpy = [](double x_m, double y_m) { return 0.2 * x_m + 0.1 * std::sin(x_m / 3.0) + 0.05 * y_m; };
  const Trajectory path = drive(make_world(bumpy, 40.0), config, 60.0, 7);
  for (std::size_t i = 2; i < path.size(); ++i) {
    const auto& p = path.poses();
    const Vector3d second = p[i].T_world_base.translation_m() - 2.0 * p[i - 1].T_world_base.translation_m() +
                            p[i - 2].T_world_base.translation_m();
    EXPECT_LT(second.norm(), 0.006) << "at " << to_seconds(p[i].stamp_ns) << " s";
    EXPECT_LT((p[i - 1].T_world_base.inverse() * p[i].T_world_base).log().tail<3>().norm(), 0.02);
  }
}

TEST(Drive, UpAndDownTheSameWay) {
  VehicleConfig config = steady();
  config.leg_s = 20.0;
  const auto bumpy = [](double x_m, double y_m) { return 0.2 * x_m + 0.1 * std::sin(x_m / 3.0) + 0.05 * y_m; };
  const World world = make_world(bumpy, 40.0);
  const auto poses = drive(world, config, 120.0, 7).poses();
  const auto once = drive(world, config, 19.0, 7).poses();
  std::size_t turns = 0;
  for (std::size_t i = 0; i < poses.size(); ++i) {
    const Pose& pose = poses[i].T_world_base;
    if (i >= 1800 && i + 1 < poses.size()) {
      // In front on the way up, behind on the way down: the nose looks where the machine goes.
      const Vector3d step_m = pose.inverse() * poses[i + 1].T_world_base.translation_m();
      EXPECT_GT(step_m.x(), -1e-6) << i;
      turns += step_m.norm() < 1e-6 ? 1U : 0U;
    }
    if (i < 1800) {
      EXPECT_TRUE(pose.matrix().isApprox(once[i].T_world_base.matrix(), 1e-9)) << "the first leg begins like any drive";
    }
  }
  EXPECT_NEAR(static_cast<double>(turns), 3600.0, 500.0) << "three turns of 12 s";
  // 21.5 s up, 12 s to turn, 23 s down: where it began, nose back.
  const Pose T_begin_back = poses.front().T_world_base.inverse() * poses[5650].T_world_base;
  EXPECT_LT(T_begin_back.translation_m().norm(), 1e-6);
  EXPECT_NEAR(std::abs(T_begin_back.log()[5]), std::numbers::pi, 1e-3);
  config.leg_s = 5.0;
  EXPECT_THROW(static_cast<void>(drive(world, config, 120.0, 7)), ConfigError) << "no place to brake in";
}

TEST(Drive, AtZeroSpeedItStands) {
  VehicleConfig config;
  config.speed_m_per_s = 0.0;
  const Trajectory path = drive(make_world(flat), config, 5.0, 1);
  for (const StampedPose& pose : path.poses()) {
    EXPECT_EQ(pose.T_world_base.translation_m().head<2>(), path.poses().front().T_world_base.translation_m().head<2>());
  }
}

TEST(Drive, SeedsDifferAndRepeat) {
  const World world = make_world(flat);
  const Trajectory path = drive(world, VehicleConfig{}, 5.0, 1);
  const Trajectory same = drive(world, VehicleConfig{}, 5.0, 1);
  const Trajectory other = drive(world, VehicleConfig{}, 5.0, 2);
  std::size_t equal = 0;
  for (std::size_t i = 0; i < path.size(); ++i) {
    EXPECT_EQ(path.poses()[i].T_world_base.matrix(), same.poses()[i].T_world_base.matrix());
    equal += path.poses()[i].T_world_base.matrix() == other.poses()[i].T_world_base.matrix() ? 1U : 0U;
  }
  EXPECT_EQ(equal, 0U);
}

TEST(Drive, StaysOnWhatIsDrivable) {
  VehicleConfig config = steady();
  config.wander_m = 5.0;
  const Trajectory path = drive(make_world(flat), config, 80.0, 4);
  for (const StampedPose& pose : path.poses()) {
    EXPECT_LT(std::abs(pose.T_world_base.translation_m().y()), 6.0 - 0.5 * config.width_m);
  }
}

TEST(Drive, SaysHowLongTheRouteLasts) {
  // 200 m less the start and half of the machine: 187.75 m at 2 m/s.
  EXPECT_THAT(error_of([] { static_cast<void>(drive(make_world(flat), steady(), 100.0, 1)); }),
              testing::AllOf(HasSubstr("the route of 200 m ends after 93.9 s, not 100 s"),
                             HasSubstr("ask for at most 93.8 s")));
  VehicleConfig config = steady();
  config.start_m = 300.0;
  EXPECT_THAT(error_of([&] { static_cast<void>(drive(make_world(flat), config, 1.0, 1)); }),
              HasSubstr("ends after 0.0 s"));
}

TEST(Drive, ARouteThatLeavesTheTerrainIsRefused) {
  World world = make_world(flat);
  world.area = {-10.0, -10.0, 20.0, 10.0};
  EXPECT_THAT(error_of([&] { static_cast<void>(drive(world, steady(), 10.0, 1)); }),
              HasSubstr("the route leaves the terrain at x 20.0 m, y 0.0 m"));
}

TEST(Drive, NonsenseIsRefused) {
  VehicleConfig config;
  config.turn_on_spot_deg = 30.0;
  EXPECT_THAT(error_of([&] { config.check(); }), HasSubstr("needs a stop to turn in"));
  config = {};
  config.speed_m_per_s = -1.0;
  EXPECT_THAT(error_of([&] { config.check(); }), HasSubstr("vehicle.speed_m_per_s"));
  EXPECT_THAT(error_of([&] { static_cast<void>(drive(make_world(flat), steady(), -1.0, 1)); }),
              HasSubstr("cannot be driven"));
}

}  // namespace
}  // namespace berm::sim
