#include "berm/core/pose_guard.hpp"

#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "berm/core/error.hpp"

namespace berm {
namespace {

using Eigen::Vector3d;

/// A machine on a winding, hilly way at 8 m/s that brakes to a stand from 20 s to 25 s and starts again; with the noise
/// of RTK.
class Drive {
 public:
  explicit Drive(double rate_hz = 100.0) : rate_hz_(rate_hz) {}

  /// Adds `shift(t)` to the position at t; leaves poses out where `keep(t)` is false.
  Trajectory make(const std::function<Vector3d(double)>& shift = {}, const std::function<bool(double)>& keep = {},
                  const std::function<double(double)>& turn = {}) const {
    std::mt19937 random(7);
    std::normal_distribution<double> noise(0.0, 0.02);
    Trajectory trajectory;
    double along_m = 0.0;
    const int count = static_cast<int>(kSeconds * rate_hz_);
    for (int i = 0; i < count; ++i) {
      const double t = i / rate_hz_;
      const double yaw = 0.6 * std::sin(along_m / 40.0);
      Vector3d p(along_m, 24.0 * (1.0 - std::cos(along_m / 40.0)), 0.08 * along_m);
      for (int k = 0; k < kSubsteps; ++k) {
        along_m += speed_mps(t + (k + 0.5) / (kSubsteps * rate_hz_)) / (kSubsteps * rate_hz_);
      }
      p += Vector3d(noise(random), noise(random), noise(random));
      p += shift ? shift(t) : Vector3d::Zero();
      if (!keep || keep(t)) {
        trajectory.append(from_seconds(t), Pose::from_yaw_pitch_roll(yaw + (turn ? turn(t) : 0.0), -0.08, 0.0, p));
      }
    }
    return trajectory;
  }

  static constexpr double kSeconds = 60.0;

 private:
  static double speed_mps(double t) { return t < 20.0 ? 8.0 : t < 30.0 ? 1.6 * std::abs(t - 25.0) : 8.0; }
  static constexpr int kSubsteps = 20;
  double rate_hz_;
};

PoseTrust at(const PoseGuard& guard, double seconds) {
  return guard.at(from_seconds(seconds));
}

bool within(double t, double first, double last) {
  return t > first && t < last;
}

TEST(PoseGuard, TrustsADriveAtAnyRate) {
  for (const double rate_hz : {1.0, 5.0, 10.0, 100.0, 400.0}) {
    const PoseGuard guard(Drive(rate_hz).make(), {});
    EXPECT_EQ(guard.jumps(), 0U) << rate_hz;
    EXPECT_TRUE(guard.spans().empty()) << rate_hz;
    EXPECT_EQ(at(guard, 30.0), PoseTrust::trusted);
    EXPECT_EQ(at(guard, -0.1), PoseTrust::no_pose);
    EXPECT_EQ(at(guard, 60.0), PoseTrust::no_pose);
  }
}

TEST(PoseGuard, NothingIsTrustedWithoutPoses) {
  EXPECT_EQ(PoseGuard().at(0), PoseTrust::no_pose);
  EXPECT_EQ(PoseGuard(Trajectory(), {}).at(0), PoseTrust::no_pose);
  Trajectory one;
  one.append(5, Pose());
  const PoseGuard guard(one, {});
  EXPECT_EQ(guard.at(5), PoseTrust::trusted);
  EXPECT_EQ(guard.at(4), PoseTrust::no_pose);
  EXPECT_EQ(guard.over(5, 6), PoseTrust::no_pose);
}

TEST(PoseGuard, AGapIsNoJumpAndTrustedAtItsEnds) {
  const Trajectory drive = Drive().make({}, [](double t) { return !within(t, 10.0, 13.0); });
  const PoseGuard guard(drive, {});
  EXPECT_EQ(guard.jumps(), 0U);
  ASSERT_EQ(guard.spans().size(), 1U);
  EXPECT_EQ(at(guard, 10.0), PoseTrust::trusted);
  EXPECT_EQ(guard.at(from_seconds(10.0) + 1), PoseTrust::gap);
  EXPECT_EQ(at(guard, 13.0), PoseTrust::trusted);
  EXPECT_NEAR(guard.seconds(PoseTrust::gap), 3.0, 0.011);
  EXPECT_EQ(guard.over(from_seconds(9.0), from_seconds(9.9)), PoseTrust::trusted);
  EXPECT_EQ(guard.over(from_seconds(9.0), from_seconds(10.1)), PoseTrust::gap);
  const std::vector<Stamp> poor = {from_seconds(11.0)};
  EXPECT_EQ(at(PoseGuard(drive, {}, poor), 12.0), PoseTrust::poor_fix);
  const std::vector<Stamp> elsewhere = {from_seconds(9.0), from_seconds(14.0)};
  EXPECT_EQ(at(PoseGuard(drive, {}, elsewhere), 12.0), PoseTrust::gap);
}

TEST(PoseGuard, AnExcursionIsLeftOutAndWhatComesBackIsTrusted) {
  for (const double rate_hz : {1.0, 10.0, 100.0}) {
    for (const double jump_m : {rate_hz < 5.0 ? 4.0 : 1.5, 50.0, 5e6}) {
      const PoseGuard guard(Drive(rate_hz).make([&](double t) {
        return t >= 40.0 && t < 45.0 ? Vector3d(0, jump_m, 0) : Vector3d(0, 0, 0);
      }),
                            {});
      SCOPED_TRACE(testing::Message() << rate_hz << " Hz, " << jump_m << " m");
      EXPECT_EQ(guard.jumps(), 2U);
      EXPECT_EQ(at(guard, 38.9), PoseTrust::trusted);
      EXPECT_EQ(at(guard, 40.0), PoseTrust::jump);
      EXPECT_EQ(at(guard, 44.0), PoseTrust::jump);
      EXPECT_EQ(at(guard, 46.1), PoseTrust::trusted);
    }
  }
}

TEST(PoseGuard, TwoJumpsOneWayDoNotCancel) {
  const PoseGuard guard(Drive().make([](double t) {
    return Vector3d(t < 12.0 ? 0.0 : t < 50.0 ? 2.0 : 4.0, 0, 0);
  }),
                        {});
  EXPECT_EQ(guard.jumps(), 2U);
  EXPECT_EQ(at(guard, 5.0), PoseTrust::jump);
  EXPECT_EQ(at(guard, 30.0), PoseTrust::trusted);
  EXPECT_EQ(at(guard, 55.0), PoseTrust::jump);
}

TEST(PoseGuard, SinglePosesFarOffAreLeftOutAlone) {
  for (const double rate_hz : {1.0, 10.0}) {
    const PoseGuard guard(Drive(rate_hz).make([&](double t) {
      const int pose = static_cast<int>(std::lround(t * rate_hz));
      return Vector3d(pose == 8 || pose == 9 ? 60.0 * (pose - 6) : 0.0, pose == 40 ? -50.0 : 0.0, 0.0);
    }),
                          {});
    EXPECT_EQ(guard.jumps(), 5U);
    for (const double pose : {7.0, 10.0, 39.0, 41.0, 50.0}) {
      EXPECT_EQ(at(guard, pose / rate_hz), PoseTrust::trusted) << pose;
    }
    for (const double pose : {7.5, 8.0, 9.0, 40.0}) {
      EXPECT_EQ(at(guard, pose / rate_hz), PoseTrust::jump) << pose;
    }
  }
}

TEST(PoseGuard, AMetreAfterAnOutageIsNoticed) {
  struct Case {
    double outage_s;
    Vector3d shift_m;
  };
  for (const Case& c : {Case{0.0, {0, 1, 0}},
                        {0.3, {1, 0, 0}},
                        {0.6, {0, 1, 0}},
                        {0.6, {-1, 0, 0}},
                        {1.5, {0, 0, 1}},
                        {3.0, {0, 10, 0}}}) {
    const PoseGuard guard(Drive().make([&](double t) { return t > 40.0 ? c.shift_m : Vector3d(0, 0, 0); },
                                       [&](double t) { return !within(t, 40.005, 40.0 + c.outage_s); }),
                          {});
    EXPECT_EQ(guard.jumps(), 1U) << c.outage_s << " s, " << c.shift_m.transpose();
    EXPECT_EQ(at(guard, 39.0), PoseTrust::trusted);
    EXPECT_EQ(at(guard, 50.0), PoseTrust::jump);
  }
}

TEST(PoseGuard, AnOutageWithinACurveAndBrakingIsNoJump) {
  for (double begin = 1.0; begin < 50.0; begin += 0.7) {
    for (const double length : {0.3, 0.9, 3.0, 8.0}) {
      const PoseGuard guard(Drive().make({}, [&](double t) { return !within(t, begin, begin + length); }), {});
      EXPECT_EQ(guard.jumps(), 0U) << begin << " s, " << length << " s";
    }
  }
}

TEST(PoseGuard, AHeadingThatFlipsIsNotTrusted) {
  const PoseGuard guard(
      Drive(10.0).make({}, {}, [](double t) { return t >= 15.0 && t < 18.0 ? std::numbers::pi : 0.0; }), {});
  EXPECT_EQ(guard.jumps(), 2U);
  EXPECT_EQ(at(guard, 14.8), PoseTrust::trusted);
  EXPECT_EQ(at(guard, 16.0), PoseTrust::jump);
  EXPECT_EQ(at(guard, 18.2), PoseTrust::trusted);
}

TEST(PoseGuard, JumpsEverywhereAndExtremeStampsEnd) {
  Trajectory wild;
  for (int i = 0; i < 100'000; ++i) {
    wild.append(i, Pose(Eigen::Quaterniond::Identity(), Vector3d(i % 2 == 0 ? 1e9 : -1e9, i % 3, 0)));
  }
  EXPECT_GT(PoseGuard(wild, {}).jumps(), 0U);
  Trajectory wide;
  wide.append(std::numeric_limits<Stamp>::min(), Pose());
  wide.append(std::numeric_limits<Stamp>::max(), Pose());
  const PoseGuard guard(wide, {});
  EXPECT_EQ(guard.at(0), PoseTrust::gap);
  EXPECT_EQ(guard.at(std::numeric_limits<Stamp>::max()), PoseTrust::trusted);
  EXPECT_GT(guard.seconds(PoseTrust::gap), 1.8e10);
}

TEST(PoseGuard, ConfigurationIsChecked) {
  PoseGuardConfig config;
  config.max_gap_s = 0.0;
  EXPECT_THROW(PoseGuard(Trajectory(), config), ConfigError);
}

TEST(TimeBase, NamesBothSpans) {
  Trajectory poses;
  poses.append(from_seconds(1'700'000'000.0), Pose());
  poses.append(from_seconds(1'700'000'010.0), Pose());
  EXPECT_FALSE(find_time_base_problem(poses, from_seconds(1'700'000'010.0), from_seconds(1'700'000'020.0)));
  const auto problem = find_time_base_problem(poses, 0, from_seconds(10.5));
  ASSERT_TRUE(problem);
  EXPECT_NE(problem->find("poses are from 1700000000.000 to 1700000010.000 s, scans from 0.000 to 10.500 s"),
            std::string::npos)
      << *problem;
  EXPECT_TRUE(find_time_base_problem(Trajectory(), 0, 1));
}

}  // namespace
}  // namespace berm
