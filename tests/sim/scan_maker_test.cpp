#include "berm/sim/scan_maker.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <thread>

#include <gtest/gtest.h>

#include "berm/core/error.hpp"
#include "sim/scan_rig.hpp"

namespace berm::sim {
namespace {

TEST(ScanMaker, ReturnsLieOnTheGroundAsSeenFromTheTruePose) {
  World world = world_of(plane_terrain(0.1, 0.05, 5.0, Surface::groomed_snow), 120.0);
  const Rig rig(world, clean_sensor(), shaky_drive(*world.terrain, 1.0));
  std::size_t returns = 0;
  for (std::size_t k = 0; k < 10; ++k) {
    const MadeScan scan = rig.make(k);
    EXPECT_EQ(scan.stamp_ns, from_seconds(0.1 * static_cast<double>(k)));
    EXPECT_EQ(scan.beams, 10'000U);
    ASSERT_EQ(scan.points.x.size(), scan.beams);
    for (std::size_t i = 0; i < scan.labels.size(); ++i) {
      if (!is_return(scan, i)) {
        continue;
      }
      ++returns;
      const Vector3d p = rig.sensor_at(scan, i) * point(scan, i);
      const GroundSample ground = rig.world.terrain->at(p.x(), p.y());
      // Corduroy is 1 cm at most; the rest is relief of 4 mm.
      ASSERT_NEAR(p.z(), ground.height_m, 0.01 + 5.0 * 0.004) << k << " " << i;
      if (std::abs(ground.inside_m) > 0.05 && p.head<2>().cwiseAbs().maxCoeff() < 119.0) {
        ASSERT_EQ(scan.labels[i], ground.inside_m > 0.0 ? truth::kDrivable : truth::kTerrain);
      }
    }
  }
  EXPECT_GT(returns, 30'000U);
}

TEST(ScanMaker, NoiseAndReliefAreWhatAGroundReturnIsOffTheBerms) {
  World world = world_of(berm_terrain(), 100.0);
  Sensor sensor = clean_sensor();
  sensor.optics.range_noise_m = 0.02;
  sensor.optics.divergence_x_mrad = 3.0;
  sensor.optics.divergence_y_mrad = 1.0;
  sensor.optics.range_at_10_percent_m = 90.0;
  const Rig rig(world, sensor, shaky_drive(*world.terrain, 1.0));
  std::size_t returns = 0;
  std::size_t wrong = 0;
  for (std::size_t k = 0; k < 10; ++k) {
    const MadeScan scan = rig.make(k);
    for (std::size_t i = 0; i < scan.labels.size(); ++i) {
      const Vector3d seen = point(scan, i);
      const Pose pose = rig.sensor_at(scan, i);
      const Vector3d p = pose * seen;
      if (!is_return(scan, i) || p.head<2>().cwiseAbs().maxCoeff() > 95.0 || seen.norm() > 30.0) {
        continue;
      }
      ++returns;
      const GroundSample ground = rig.world.terrain->at(p.x(), p.y());
      // The nearest place along the beam that the ground has: mixed returns over a crest lie between its two sides.
      const double off_m = std::abs(p.z() - ground.height_m);
      wrong += off_m > 0.055 + 5.0 * std::hypot(0.02 * 2.0, 0.015) ? 1U : 0U;
      if (std::abs(ground.inside_m) > 0.3) {
        wrong += scan.labels[i] == (ground.inside_m > 0.0 ? truth::kDrivable : truth::kTerrain) ? 0U : 1U;
      }
    }
  }
  EXPECT_GT(returns, 20'000U);
  EXPECT_LT(wrong, returns / 500);
}

TEST(ScanMaker, PosesOfBeamsAreThoseOfTheTrajectory) {
  // A sphere far away would hide errors; a wall under a sensor that turns does not.
  World world = wall_world(50.0, Surface::concrete);
  Trajectory trajectory;
  for (int i = 0; i <= 20; ++i) {
    trajectory.append(10'000'000 * i, Pose::from_yaw_pitch_roll(0.02 * i, 0.1 * std::sin(0.9 * i), 0.004 * i,
                                                                {0.1 * i, 0.02 * i, 100.0 + 0.05 * std::sin(1.0 * i)}));
  }
  const Rig rig(world, clean_sensor(), trajectory);
  const MadeScan scan = rig.make(0);
  std::size_t returns = 0;
  for (std::size_t i = 0; i < scan.labels.size(); ++i) {
    if (is_return(scan, i)) {
      ++returns;
      // Relief of concrete: 3 mm, up to five times along the ray.
      ASSERT_NEAR((rig.sensor_at(scan, i) * point(scan, i)).x(), 50.0, 5.0 * 0.003 * 1.2);
    }
  }
  EXPECT_GT(returns, 9000U);
}

TEST(ScanMaker, RangeNoiseIsTheConfiguredOne) {
  for (const double sigma_m : {0.005, 0.03}) {
    Sensor sensor = clean_sensor();
    sensor.optics.range_noise_m = sigma_m;
    // Metal has the least relief, 1 mm.
    const Rig rig(wall_world(20.0, Surface::metal), sensor, standing({0, 0, 0}), kHigh);
    const Statistics errors = statistics(range_errors(rig, 20.0, 10));
    ASSERT_GT(errors.count, 10'000.0);
    const double expected_m = std::hypot(sigma_m, 0.001);
    EXPECT_NEAR(errors.mean, 0.0, 5.0 * expected_m / std::sqrt(errors.count));
    // Up to 5 standard errors, and the cosine of up to 35 degrees at which relief is seen.
    EXPECT_NEAR(errors.sigma, expected_m, 5.0 * expected_m / std::sqrt(2.0 * errors.count) + 1e-4);
  }
}

TEST(ScanMaker, RangeNoiseGrowsAsTheSignalSinks) {
  Sensor sensor = clean_sensor();
  sensor.optics.range_noise_m = 0.02;
  sensor.optics.range_at_10_percent_m = 50.0;
  // Asphalt, 8 %, at 44.7 m: signal 1 straight ahead, less aside.
  const Rig weak(wall_world(44.7, Surface::asphalt), sensor, standing({0, 0, 0}), kHigh);
  const Rig strong(wall_world(5.0, Surface::asphalt), sensor, standing({0, 0, 0}), kHigh);
  const Statistics far = statistics(range_errors(weak, 44.7, 10));
  const Statistics near = statistics(range_errors(strong, 5.0, 10));
  EXPECT_NEAR(near.sigma, 0.02, 0.001);
  EXPECT_GT(far.sigma, 1.7 * near.sigma);
  EXPECT_LT(far.sigma, 2.5 * near.sigma);
}

double share_of_returns(const Rig& rig, std::size_t scans) {
  double returns = 0.0;
  double beams = 0.0;
  MadeScan scan;
  for (std::size_t k = 0; k < scans; ++k) {
    rig.maker.make(k, scan);
    for (std::size_t i = 0; i < scan.labels.size(); ++i) {
      returns += is_return(scan, i) ? 1.0 : 0.0;
    }
    beams += static_cast<double>(scan.beams);
  }
  return returns / beams;
}

TEST(ScanMaker, HalfOfTheBeamsComeBackWhereTheSensorSaysSo) {
  Sensor sensor = clean_sensor();
  sensor.pattern.field_of_view_deg = 4.0;
  sensor.optics.range_at_10_percent_m = 50.0;
  // 20 % bark: as far as the square root of 2 farther.
  const Rig at_limit(wall_world(50.0 * std::sqrt(2.0), Surface::bark), sensor, standing({0, 0, 0}), kHigh);
  EXPECT_NEAR(share_of_returns(at_limit, 5), 0.5, 0.02);
  const Rig nearer(wall_world(30.0, Surface::bark), sensor, standing({0, 0, 0}), kHigh);
  EXPECT_GT(share_of_returns(nearer, 5), 0.98);
  const Rig farther(wall_world(140.0, Surface::bark), sensor, standing({0, 0, 0}), kHigh);
  EXPECT_LT(share_of_returns(farther, 5), 0.1);
}

TEST(ScanMaker, DarkAndGrazedSurfacesDropOut) {
  Sensor sensor = clean_sensor();
  sensor.optics.range_at_10_percent_m = 50.0;
  const auto share_within = [&](Surface surface, double nearest_m, double farthest_m) {
    World world = world_of(plane_terrain(0.0, 0.0, 5.0, surface), 200.0);
    const Rig rig(world, sensor, standing({0, 0, 0}), Pose::from_yaw_pitch_roll(0.0, 0.2, 0.0, {0.0, 0.0, 2.3}));
    const MadeScan scan = rig.make(0);
    double beams = 0.0;
    double returns = 0.0;
    BeamPattern pattern(sensor.pattern);
    Beams all;
    pattern.beams_of_scan(0, all);
    for (std::size_t i = 0; i < all.size(); ++i) {
      const Vector3d direction = rig.sensor_at(scan, i).rotation() * Vector3d(all.x[i], all.y[i], all.z[i]);
      const double range_m = -2.3 / direction.z();
      if (range_m > nearest_m && range_m < farthest_m) {
        beams += 1.0;
        returns += is_return(scan, i) ? 1.0 : 0.0;
      }
    }
    return returns / beams;
  };
  EXPECT_GT(share_within(Surface::groomed_snow, 3.0, 30.0), 0.99);
  EXPECT_GT(share_within(Surface::asphalt, 3.0, 10.0), 0.95);
  EXPECT_LT(share_within(Surface::asphalt, 30.0, 60.0), 0.2);
  EXPECT_GT(share_within(Surface::groomed_snow, 30.0, 60.0), share_within(Surface::asphalt, 30.0, 60.0) + 0.3);
  // Water mirrors beams away, the more the flatter they come.
  EXPECT_LT(share_within(Surface::water, 3.0, 10.0), 0.03);
  EXPECT_EQ(share_within(Surface::water, 20.0, 60.0), 0.0);
}

TEST(ScanMaker, LosesWhatIsLostForNoReasonAndWhatIsTooNear) {
  Sensor sensor = clean_sensor();
  sensor.optics.dropout = 0.1;
  const Rig rig(wall_world(20.0, Surface::concrete), sensor, standing({0, 0, 0}), kHigh);
  EXPECT_NEAR(share_of_returns(rig, 10), 0.9, 5.0 * std::sqrt(0.1 * 0.9 / 100'000.0));
  sensor.optics.dropout = 0.0;
  sensor.optics.min_range_m = 30.0;
  EXPECT_EQ(share_of_returns(Rig(wall_world(20.0, Surface::concrete), sensor, standing({0, 0, 0}), kHigh), 1), 0.0);
  sensor.optics.keeps_no_returns = false;
  const Rig blind(wall_world(20.0, Surface::concrete), sensor, standing({0, 0, 0}), kHigh);
  const MadeScan scan = blind.make(0);
  EXPECT_EQ(scan.points.x.size(), 0U);
  EXPECT_EQ(scan.labels.size(), 0U);
  EXPECT_EQ(scan.beams, 10'000U);
}

TEST(ScanMaker, KeepsNoReturnsWithTheirTimeAndNothingElse) {
  World world = world_of(plane_terrain(0.0, 0.0), 50.0);
  const Rig rig(world, clean_sensor(), standing({0, 0, 0}), Pose::from_yaw_pitch_roll(0, 0, 0, {0, 0, 2.0}));
  const MadeScan scan = rig.make(0);
  std::size_t missing = 0;
  for (std::size_t i = 0; i < scan.labels.size(); ++i) {
    EXPECT_NEAR(scan.points.time[i], 1e-5 * static_cast<double>(i), 1e-7);
    if (!is_return(scan, i)) {
      ++missing;
      EXPECT_EQ(scan.points.intensity[i], 0.0F);
      EXPECT_EQ(scan.labels[i], 0U);
    } else {
      EXPECT_GE(scan.points.intensity[i], 0.0F);
      EXPECT_NE(scan.labels[i], 0U);
    }
  }
  EXPECT_GT(missing, 3000U);
  EXPECT_LT(missing, 7000U);
}

TEST(ScanMaker, ReportsTheRangeInStepsOfTheQuantum) {
  Sensor sensor = clean_sensor();
  sensor.optics.range_noise_m = 0.02;
  sensor.optics.range_quantum_m = 0.004;
  const Rig rig(wall_world(20.0, Surface::concrete), sensor, standing({0, 0, 0}), kHigh);
  const MadeScan scan = rig.make(0);
  for (std::size_t i = 0; i < scan.labels.size(); ++i) {
    const double steps = point(scan, i).norm() / 0.004;
    EXPECT_NEAR(steps, std::round(steps), 0.002);
  }
}

TEST(ScanMaker, GivesTheSameBytesOnAnyNumberOfThreads) {
  World world = world_of(berm_terrain(), 80.0);
  add_box(world.things, {-5.0F, 2.0F, -5.0F}, {-4.0F, 3.0F, 9.0F}, {Surface::bark, truth::kPole});
  add_box(world.things, {5.0F, -5.0F, -5.0F}, {8.0F, -2.0F, 9.0F}, {Surface::foliage, truth::kVegetation});
  SnowfallConfig snowfall;
  snowfall.flakes_per_m3 = 1000.0;
  Sensor sensor;
  sensor.sensor.name = "noisy";
  sensor.pattern.kind = "rosette";
  const Rig rig(world, sensor, shaky_drive(*world.terrain, 2.0), kMount, snowfall);
  constexpr std::size_t kScans = 16;
  const auto make_all = [&](std::size_t threads) {
    std::vector<MadeScan> scans(kScans);
    std::vector<std::thread> pool;
    for (std::size_t thread = 0; thread < threads; ++thread) {
      pool.emplace_back([&, thread] {
        for (std::size_t k = thread; k < kScans; k += threads) {
          rig.maker.make(k, scans[k]);
        }
      });
    }
    for (std::thread& thread : pool) {
      thread.join();
    }
    return scans;
  };
  const std::vector<MadeScan> one = make_all(1);
  for (const std::size_t threads : {2U, 4U}) {
    const std::vector<MadeScan> more = make_all(threads);
    for (std::size_t k = 0; k < kScans; ++k) {
      EXPECT_EQ(one[k].points.x, more[k].points.x);
      EXPECT_EQ(one[k].points.y, more[k].points.y);
      EXPECT_EQ(one[k].points.z, more[k].points.z);
      EXPECT_EQ(one[k].points.intensity, more[k].points.intensity);
      EXPECT_EQ(one[k].labels, more[k].labels);
    }
  }
  // Memory that was used before makes no difference, another seed does.
  MadeScan again;
  rig.maker.make(3, again);
  rig.maker.make(7, again);
  EXPECT_EQ(one[7].points.x, again.points.x);
  EXPECT_EQ(one[7].labels, again.labels);
  const ScanMaker other(sensor, kMount, rig.caster, rig.weather, rig.trajectory, 2);
  other.make(7, again);
  EXPECT_NE(one[7].points.x, again.points.x);
}

TEST(ScanMaker, SpinningSensorsKeepTheirRings) {
  Sensor sensor;
  sensor.sensor.name = "spinning";
  sensor.pattern.elevations_deg = "-15 1 -13 3 -11 5 -9 7 -7 9 -5 11 -3 13 -1 15";
  sensor.pattern.column_s = 55.296e-6;
  sensor.pattern.firing_s = 2.304e-6;
  sensor.optics.keeps_no_returns = false;
  World world = world_of(berm_terrain(), 60.0);
  const Rig rig(world, sensor, standing({0, 0, 2}), Pose::from_yaw_pitch_roll(0, 0, 0, {0, 0, 4}));
  const MadeScan scan = rig.make(0);
  EXPECT_GT(scan.points.ring.size(), 5000U);
  ASSERT_EQ(scan.points.ring.size(), scan.points.x.size());
  ASSERT_EQ(scan.points.intensity.size(), scan.points.x.size());
  ASSERT_EQ(scan.labels.size(), scan.points.x.size());
  for (std::size_t i = 0; i < scan.labels.size(); ++i) {
    const Vector3d p = point(scan, i);
    EXPECT_NEAR(std::atan2(p.z(), p.head<2>().norm()) * 180.0 / std::numbers::pi, -15.0 + 2.0 * scan.points.ring[i],
                0.01);
  }
}

TEST(ScanMaker, RefusesToStartBelowTheGroundOrInsideOfSomething) {
  World world = world_of(plane_terrain(0.0, 0.0), 50.0);
  add_box(world.things, {-2.0F, -2.0F, -1.0F}, {2.0F, 2.0F, 4.0F}, {Surface::concrete, truth::kBuilding});
  const auto refused = [&](const Vector3d& place_m, const Pose& mount) {
    const Rig rig(world, clean_sensor(), standing(place_m), mount);
    try {
      rig.maker.check_start(*rig.world.terrain);
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), ErrorCode::invalid_argument);
      return std::string(error.what());
    }
    return std::string();
  };
  EXPECT_EQ(refused({5.0, 0.0, 0.0}, kMount), "");
  EXPECT_NE(refused({5.0, 0.0, -3.0}, kMount).find("below the terrain"), std::string::npos);
  EXPECT_NE(refused({0.0, 0.0, 0.0}, kMount).find("inside of something"), std::string::npos);
  EXPECT_EQ(refused({0.0, 0.0, 3.0}, kMount), "");
}

TEST(ScanMaker, RefusesScansThatTheTrajectoryDoesNotCover) {
  World world = world_of(plane_terrain(0.0, 0.0), 10.0);
  const Rig rig(world, clean_sensor(), shaky_drive(*world.terrain, 0.5));
  MadeScan scan;
  EXPECT_NO_THROW(rig.maker.make(4, scan));
  EXPECT_THROW(rig.maker.make(6, scan), Error);
  const Rig nowhere(world, clean_sensor(), Trajectory{});
  EXPECT_THROW(nowhere.maker.make(0, scan), Error);
  EXPECT_THROW(nowhere.maker.check_start(*world.terrain), Error);
}

}  // namespace
}  // namespace berm::sim
