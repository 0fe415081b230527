#include <array>
#include <cmath>
#include <numbers>
#include <span>
#include <vector>

#include <gtest/gtest.h>

#include "beams/beam_optics.hpp"
#include "beams/beam_pose.hpp"
#include "beams/beam_random.hpp"
#include "beams/echo.hpp"

namespace berm::sim {
namespace {

TEST(BeamRandom, CosineAndSineAreThoseOfTheLibrary) {
  for (int i = -10'000; i <= 10'000; ++i) {
    const float x = static_cast<float>(i) * 0.5e-4F;
    const double angle_rad = 2.0 * std::numbers::pi * static_cast<double>(x);
    EXPECT_NEAR(cos_turn(x), std::cos(angle_rad), 4e-7);
    EXPECT_NEAR(sin_turn(x), std::sin(angle_rad), 4e-7);
  }
}

TEST(BeamRandom, RoundsToTheNearest) {
  EXPECT_EQ(rounded(2.4F), 2.0F);
  EXPECT_EQ(rounded(2.6F), 3.0F);
  EXPECT_EQ(rounded(-2.6), -3.0);
  EXPECT_EQ(rounded(-0.4), 0.0);
}

TEST(BeamRandom, PairsAreNormalAndIndependent) {
  constexpr int kCount = 400'000;
  std::array<double, 4> first{};
  std::array<double, 4> second{};
  double product = 0.0;
  int beyond_two = 0;
  for (int i = 0; i < kCount; ++i) {
    Random random(3, Purpose::beam, 0, static_cast<std::uint64_t>(i));
    const NormalPair pair = normal_pair(uniform_pair(random));
    const auto a = static_cast<double>(pair.first);
    const auto b = static_cast<double>(pair.second);
    for (std::size_t k = 0; k < 4; ++k) {
      first[k] += std::pow(a, static_cast<double>(k + 1)) / kCount;
      second[k] += std::pow(b, static_cast<double>(k + 1)) / kCount;
    }
    product += a * b / kCount;
    beyond_two += std::abs(a) > 2.0 ? 1 : 0;
  }
  // Moments 0, 1, 0, 3 with variances 1, 2, 15, 96; five standard errors.
  const double error = 5.0 / std::sqrt(static_cast<double>(kCount));
  for (const auto& moments : {first, second}) {
    EXPECT_NEAR(moments[0], 0.0, error);
    EXPECT_NEAR(moments[1], 1.0, error * std::sqrt(2.0));
    EXPECT_NEAR(moments[2], 0.0, error * std::sqrt(15.0));
    EXPECT_NEAR(moments[3], 3.0, error * std::sqrt(96.0));
  }
  EXPECT_NEAR(product, 0.0, error);
  EXPECT_NEAR(beyond_two / static_cast<double>(kCount), 0.0455003, error * 0.21);
}

TEST(ScrewMotion, IsTheTrajectoryWithAMount) {
  Random random(4, Purpose::vehicle);
  const auto random_pose = [&](double turn_rad, double way_m) {
    return Pose::from_yaw_pitch_roll(random.uniform(-turn_rad, turn_rad), random.uniform(-turn_rad, turn_rad),
                                     random.uniform(-turn_rad, turn_rad),
                                     {random.uniform(-way_m, way_m), random.uniform(-way_m, way_m), random.normal()});
  };
  // No turn, a hardly visible one, what a machine does in 10 ms, one beyond the series, half a turn.
  for (const double turn_rad : {0.0, 1e-9, 1e-4, 0.02, 0.28, 1.0, 1.8}) {
    for (int i = 0; i < 50; ++i) {
      const Pose from = random_pose(3.0, 1000.0);
      const Pose mount = random_pose(0.5, 3.0);
      Trajectory trajectory;
      trajectory.append(0, from);
      trajectory.append(1'000'000'000, from * random_pose(turn_rad, 2.0));
      const ScrewMotion motion(from, trajectory.poses()[1].T_world_base, mount);
      for (const double s : {0.0, 0.001, 0.3, 0.777, 1.0}) {
        Placed placed;
        motion.at(s, placed);
        const Pose expected = *trajectory.at(from_seconds(s)) * mount;
        EXPECT_LT((placed.origin_m - expected.translation_m()).norm(), 1e-6);
        EXPECT_LT((placed.rotation - expected.rotation().toRotationMatrix()).norm(), 1e-7);
      }
    }
  }
}

// A machine that turns at 60 degrees a second, pitches and is shaken at 1 g.
TEST(DensePoses, AreThoseOfTheTrajectory) {
  const Pose from = Pose::from_yaw_pitch_roll(1.0, 0.2, -0.1, {800.0, -300.0, 50.0});
  const Pose mount = Pose::from_yaw_pitch_roll(0.1, 0.2, 0.0, {1.0, 0.2, 2.5});
  Trajectory trajectory;
  trajectory.append(0, from);
  trajectory.append(10'000'000, from * Pose::from_yaw_pitch_roll(0.0105, 0.004, -0.004, {0.1, 0.0, 0.001}));
  const ScrewMotion motion(from, trajectory.poses()[1].T_world_base, mount);
  DensePoses dense(motion, 0.01);
  for (int i = 0; i <= 10'000; i += i % 7 + 1) {
    Placed placed;
    dense.at(1e-6 * i, placed);
    const Pose expected = *trajectory.at(Stamp{1000} * i) * mount;
    EXPECT_LT((placed.origin_m - expected.translation_m()).norm(), 1e-6);
    EXPECT_LT((placed.rotation - expected.rotation().toRotationMatrix()).norm(), 1e-7);
  }
}

TEST(PoseTrack, StandsStillBeforeAndAfter) {
  Trajectory trajectory;
  trajectory.append(1'000'000'000, Pose::from_yaw_pitch_roll(0.0, 0.0, 0.0, {1.0, 0.0, 0.0}));
  trajectory.append(3'000'000'000, Pose::from_yaw_pitch_roll(0.0, 0.0, 0.0, {5.0, 0.0, 0.0}));
  const PoseTrack track(trajectory);
  const auto x_at = [&](double time_s) {
    Placed placed;
    track.at(time_s, placed);
    return placed.origin_m.x();
  };
  EXPECT_DOUBLE_EQ(x_at(0.0), 1.0);
  EXPECT_DOUBLE_EQ(x_at(2.0), 3.0);
  EXPECT_DOUBLE_EQ(x_at(3.0), 5.0);
  EXPECT_DOUBLE_EQ(x_at(9.0), 5.0);
  EXPECT_GE(track.max_speed_m_per_s(), 2.0);
}

Echo echo(float range_m, float energy, std::uint32_t label) {
  Echo made;
  made.range_m = range_m;
  made.energy = energy;
  made.light = 0.1F * energy;
  made.variance_m2 = 0.01F;
  made.label = label;
  made.label_lead = energy;
  return made;
}

TEST(Echoes, MeltIfNearAndConserveEnergy) {
  Random random(5, Purpose::beam);
  for (int i = 0; i < 2000; ++i) {
    std::vector<Echo> parts;
    double energy = 0.0;
    double light = 0.0;
    double moment = 0.0;
    const int count = i % 6;
    for (int k = 0; k < count; ++k) {
      parts.push_back(echo(static_cast<float>(random.uniform(10.0, 20.0)),
                           static_cast<float>(random.uniform(0.0, 50.0)),
                           static_cast<std::uint32_t>(random.uniform(40.0, 43.0))));
      energy += static_cast<double>(parts.back().energy);
      light += static_cast<double>(parts.back().light);
      moment += static_cast<double>(parts.back().energy * parts.back().range_m);
    }
    const std::size_t left = melt(parts, 1.5F);
    ASSERT_LE(left, parts.size());
    for (std::size_t k = 0; k < left; ++k) {
      energy -= static_cast<double>(parts[k].energy);
      light -= static_cast<double>(parts[k].light);
      moment -= static_cast<double>(parts[k].energy * parts[k].range_m);
      EXPECT_NEAR(parts[k].variance_m2, 0.01F, 1e-6F);
      if (k > 0) {
        EXPECT_GT(parts[k].range_m, parts[k - 1].range_m);
      }
    }
    EXPECT_NEAR(energy, 0.0, 1e-4);
    EXPECT_NEAR(light, 0.0, 1e-5);
    EXPECT_NEAR(moment, 0.0, 1e-2);
  }
}

TEST(Echoes, TakeTheLabelOfMostOfTheEnergy) {
  std::array<Echo, 4> parts{echo(10.2F, 5.0F, 40), echo(10.0F, 4.0F, 72), echo(10.1F, 4.0F, 72), echo(30.0F, 1.0F, 50)};
  ASSERT_EQ(melt(parts, 1.0F), 2U);
  EXPECT_EQ(parts[0].label, 72U);
  EXPECT_EQ(parts[1].label, 50U);
  EXPECT_FLOAT_EQ(parts[1].range_m, 30.0F);
}

TEST(BeamOptics, ShadesBetweenLambertAndFlat) {
  EXPECT_FLOAT_EQ(shade(roughness_of(Surface::paint), 0.3F), 0.3F);
  for (const Surface surface : {Surface::groomed_snow, Surface::gravel, Surface::asphalt, Surface::cloth}) {
    EXPECT_FLOAT_EQ(shade(roughness_of(surface), 1.0F), 1.0F);
  }
  // The paper saw snow at 150 to 153 from 10 to 40 m, where it is grazed.
  EXPECT_NEAR(shade(roughness_of(Surface::groomed_snow), 0.1F), 1.0F, 0.1F);
  EXPECT_LT(shade(roughness_of(Surface::asphalt), 0.1F), 0.5F);
}

TEST(BeamOptics, FindsHalfAtTheLimit) {
  EXPECT_FLOAT_EQ(detection_probability(1.0F), 0.5F);
  EXPECT_FLOAT_EQ(detection_probability(0.0F), 0.0F);
  EXPECT_FLOAT_EQ(detection_probability(1e30F), 1.0F);
  EXPECT_NEAR(detection_probability(2.7F), 0.98F, 0.003F);
}

TEST(BeamOptics, AveragesCorduroyOverTheFootprint) {
  const auto height_m = [&](double range_m, double across_m) {
    // The mean of the ridges over the width, by sums.
    const double width_m = 0.003 * range_m;
    double sum = 0.0;
    for (int i = 0; i < 1000; ++i) {
      const double y_m = across_m + width_m * ((i + 0.5) / 1000.0 - 0.5);
      sum += 0.01 * std::cos(2.0 * std::numbers::pi * y_m / 0.024) / 1000.0;
    }
    const float found_m =
        corduroy_m({static_cast<float>(across_m), 0.0F, 1.0F, 0.99F, 0.0F, static_cast<float>(width_m), 0.0F});
    EXPECT_NEAR(found_m, sum, 1e-5) << range_m << " " << across_m;
    return sum;
  };
  EXPECT_NEAR(height_m(0.01, -100.0 * 0.024), 0.01, 1e-4);
  for (const double range_m : {0.1, 1.0, 4.0, 10.0, 15.0}) {
    for (const double across_m : {0.0, 0.005, 3.017, -8.009}) {
      (void)height_m(range_m, across_m);
    }
  }
}

TEST(BeamOptics, MirrorsMoreWhereGrazedButNeverAll) {
  constexpr float kWater = 0.9F;
  constexpr float kAsphalt = 0.02F;
  EXPECT_FLOAT_EQ(mirrored(kWater, 1.0F), 0.9F);
  EXPECT_GT(mirrored(kWater, 0.1F), 0.94F);
  EXPECT_LE(mirrored(kWater, 0.0F), 1.0F);
  EXPECT_LT(mirrored(kAsphalt, 0.05F), 0.05F);
}

}  // namespace
}  // namespace berm::sim
