#include "berm/sim/scan_maker.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <thread>

#include <gtest/gtest.h>

#include "berm/core/error.hpp"
#include "sim/caster_worlds.hpp"

namespace berm::sim {
namespace {

using Eigen::Vector3d;

/// A rosette that sees and hits whatever there is: no noise, no losses, a beam without width.
Sensor clean_sensor() {
  Sensor sensor;
  sensor.sensor.name = "clean";
  sensor.pattern.kind = "rosette";
  sensor.optics.min_range_m = 0.1;
  sensor.optics.near_field_m = 0.0;
  sensor.optics.range_at_10_percent_m = 5000.0;
  sensor.optics.range_noise_m = 0.0;
  sensor.optics.divergence_x_mrad = 0.0;
  sensor.optics.divergence_y_mrad = 0.0;
  sensor.optics.dropout = 0.0;
  return sensor;
}

/// 0..`seconds` at 100 Hz, forward at 5 m/s while it heaves, pitches and turns.
Trajectory shaky_drive(const Terrain& terrain, double seconds) {
  Trajectory trajectory;
  for (int i = 0; i <= static_cast<int>(seconds * 100.0) + 1; ++i) {
    const double t = 0.01 * i;
    const double x_m = -20.0 + 5.0 * t;
    trajectory.append(
        10'000'000 * i,
        Pose::from_yaw_pitch_roll(0.3 * std::sin(2.0 * t), 0.03 * std::sin(6.0 * t), 0.02 * std::cos(7.0 * t),
                                  {x_m, 0.5 * t, terrain.at(x_m, 0.5 * t).height_m + 0.03 * std::sin(6.0 * t)}));
  }
  return trajectory;
}

Trajectory standing(const Vector3d& place_m) {
  Trajectory trajectory;
  trajectory.append(0, Pose::from_yaw_pitch_roll(0.0, 0.0, 0.0, place_m));
  trajectory.append(100'000'000'000, Pose::from_yaw_pitch_roll(0.0, 0.0, 0.0, place_m));
  return trajectory;
}

const Pose kMount = Pose::from_yaw_pitch_roll(0.0, 0.2, 0.01, {0.5, 0.1, 2.3});

/// Everything that a scan needs, kept together.
struct Rig {
  Rig(World world_in, const Sensor& sensor_in, Trajectory trajectory_in, const Pose& mount = kMount,
      const SnowfallConfig& snowfall = {}, std::uint64_t seed = 1)
      : world(std::move(world_in)),
        sensor(sensor_in),
        trajectory(std::move(trajectory_in)),
        caster(world, {}),
        weather(snowfall, sensor.optics, world.plumes, seed),
        T_base_sensor(mount),
        maker(sensor, mount, caster, weather, trajectory, seed) {}

  World world;
  Sensor sensor;
  Trajectory trajectory;
  RayCaster caster;
  Weather weather;
  Pose T_base_sensor;
  ScanMaker maker;

  [[nodiscard]] MadeScan make(std::size_t index) const {
    MadeScan scan;
    maker.make(index, scan);
    return scan;
  }
  [[nodiscard]] Pose sensor_at(const MadeScan& scan, std::size_t i) const {
    const Stamp stamp_ns = scan.stamp_ns + from_seconds(static_cast<double>(scan.points.time[i]));
    return *trajectory.at(stamp_ns) * T_base_sensor;
  }
};

Vector3d point(const MadeScan& scan, std::size_t i) {
  return Eigen::Vector3f{scan.points.x[i], scan.points.y[i], scan.points.z[i]}.cast<double>();
}

bool is_return(const MadeScan& scan, std::size_t i) {
  return point(scan, i).squaredNorm() > 0.0;
}

/// An upright wall of one surface that fills the view, `range_m` ahead of a standing sensor at the origin.
World wall_world(double range_m, Surface surface, std::uint16_t truth_id = truth::kBuilding) {
  World world = world_of(plane_terrain(0.0, 0.0), 1.0);
  const auto x = static_cast<float>(range_m);
  add_quad(world.things, {x, 500.0F, -400.0F}, {x, -500.0F, -400.0F}, {x, -500.0F, 600.0F}, {x, 500.0F, 600.0F},
           {surface, truth_id});
  return world;
}

const Pose kHigh = Pose::from_yaw_pitch_roll(0.0, 0.0, 0.0, {0.0, 0.0, 100.0});

struct Statistics {
  double mean = 0.0;
  double sigma = 0.0;
  double count = 0.0;
};

Statistics statistics(const std::vector<double>& values) {
  Statistics result;
  result.count = static_cast<double>(values.size());
  for (const double value : values) {
    result.mean += value / result.count;
  }
  for (const double value : values) {
    result.sigma += (value - result.mean) * (value - result.mean) / result.count;
  }
  result.sigma = std::sqrt(result.sigma);
  return result;
}

/// Errors of the range against a wall at `range_m`.
std::vector<double> range_errors(const Rig& rig, double range_m, std::size_t scans) {
  std::vector<double> errors;
  MadeScan scan;
  for (std::size_t k = 0; k < scans; ++k) {
    rig.maker.make(k, scan);
    for (std::size_t i = 0; i < scan.labels.size(); ++i) {
      if (is_return(scan, i)) {
        const Vector3d p = point(scan, i);
        errors.push_back(p.norm() - range_m * p.norm() / p.x());
      }
    }
  }
  return errors;
}

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

/// A near wall before the left of a far one, with its edge where the petals of the rosette cross it: the share of the
/// footprint on the near one decides the energy of the mixed echo.
World step_world(double near_m, double far_m) {
  World world = wall_world(far_m, Surface::concrete);
  const auto x = static_cast<float>(near_m);
  add_quad(world.things, {x, 100.0F, 0.0F}, {x, 0.25F * x, 0.0F}, {x, 0.25F * x, 200.0F}, {x, 100.0F, 200.0F},
           {Surface::concrete, truth::kPole});
  return world;
}

/// How far a beam passes from the edge of `step_world`, in widths of a footprint of 10 mrad; far off up and down, where
/// petals run along the edge, it is infinite.
double off_edge(const Beams& beams, std::size_t i) {
  constexpr double kEdge = 0.25;
  const double aside = static_cast<double>(beams.y[i]) / static_cast<double>(beams.x[i]);
  const double up = static_cast<double>(beams.z[i]) / static_cast<double>(beams.x[i]);
  return std::abs(up) < 0.1 ? (aside - kEdge) / (0.010 * (1.0 + kEdge * kEdge))
                            : std::numeric_limits<double>::infinity();
}

TEST(ScanMaker, MixesEchoesOfAnEdgeByTheirEnergy) {
  Sensor sensor = clean_sensor();
  sensor.pattern.points_per_s = 1e6;
  sensor.optics.divergence_x_mrad = 10.0;
  sensor.optics.divergence_y_mrad = 2.0;
  sensor.optics.echo_separation_m = 3.0;
  const Rig rig(step_world(20.0, 22.0), sensor, standing({0, 0, 0}), kHigh);
  std::vector<double> residuals;
  std::size_t between = 0;
  MadeScan scan;
  Beams beams;
  for (std::size_t k = 0; k < 4; ++k) {
    rig.maker.make(k, scan);
    BeamPattern(sensor.pattern).beams_of_scan(k, beams);
    for (std::size_t i = 0; i < scan.labels.size(); ++i) {
      const double off = off_edge(beams, i);
      if (std::abs(off) > 0.6) {
        continue;
      }
      const double on_near = std::clamp(0.5 + off, 0.0, 1.0);
      const double depth_m = static_cast<double>(scan.points.x[i]);
      ASSERT_GT(depth_m, 19.9);
      ASSERT_LT(depth_m, 22.1);
      between += depth_m > 20.2 && depth_m < 21.8 ? 1U : 0U;
      residuals.push_back(depth_m - (22.0 - 2.0 * on_near));
      EXPECT_EQ(scan.labels[i], depth_m < 20.9 ? truth::kPole : depth_m > 21.1 ? truth::kBuilding : scan.labels[i]);
    }
  }
  const Statistics off = statistics(residuals);
  ASSERT_GT(off.count, 500.0);
  EXPECT_GT(between, residuals.size() / 3);
  // Four rays in as many strips across: off by a quarter of the step at most, and on average by none.
  EXPECT_NEAR(off.mean, 0.0, 5.0 * off.sigma / std::sqrt(off.count) + 0.01);
  EXPECT_LT(off.sigma, 0.25);
}

TEST(ScanMaker, ConservesTheEnergyOfMixedEchoes) {
  Sensor sensor = clean_sensor();
  sensor.pattern.points_per_s = 1e6;
  sensor.optics.divergence_x_mrad = 10.0;
  sensor.optics.divergence_y_mrad = 2.0;
  const auto edge_intensity = [&](double separation_m) {
    sensor.optics.echo_separation_m = separation_m;
    const Rig rig(step_world(20.0, 22.0), sensor, standing({0, 0, 0}), kHigh);
    std::vector<double> values;
    MadeScan scan;
    Beams beams;
    for (std::size_t k = 0; k < 4; ++k) {
      rig.maker.make(k, scan);
      BeamPattern(sensor.pattern).beams_of_scan(k, beams);
      for (std::size_t i = 0; i < scan.labels.size(); ++i) {
        if (std::abs(off_edge(beams, i)) < 0.5) {
          values.push_back(static_cast<double>(scan.points.intensity[i]));
        }
      }
    }
    return statistics(values);
  };
  const Statistics melted = edge_intensity(3.0);
  const Statistics apart = edge_intensity(0.5);
  // Concrete is 35: all of it, or the larger of two parts, which is 3/4 of it on average.
  EXPECT_NEAR(melted.mean, 35.0, 5.0 * melted.sigma / std::sqrt(melted.count) + 0.3);
  EXPECT_NEAR(apart.mean, 0.75 * 35.0, 2.0);
}

TEST(ScanMaker, TakesTheEchoThatTheSensorIsSetTo) {
  Sensor sensor = clean_sensor();
  sensor.pattern.points_per_s = 1e6;
  sensor.optics.divergence_x_mrad = 10.0;
  sensor.optics.divergence_y_mrad = 2.0;
  const auto near_share = [&](const char* echo) {
    sensor.optics.echo = echo;
    const Rig rig(step_world(20.0, 30.0), sensor, standing({0, 0, 0}), kHigh);
    double near = 0.0;
    double all = 0.0;
    MadeScan scan;
    Beams beams;
    for (std::size_t k = 0; k < 4; ++k) {
      rig.maker.make(k, scan);
      BeamPattern(sensor.pattern).beams_of_scan(k, beams);
      for (std::size_t i = 0; i < scan.labels.size(); ++i) {
        if (std::abs(off_edge(beams, i)) < 0.5) {
          all += 1.0;
          near += scan.labels[i] == truth::kPole ? 1.0 : 0.0;
        }
      }
    }
    return near / all;
  };
  const double first = near_share("first");
  const double strongest = near_share("strongest");
  const double last = near_share("last");
  EXPECT_GT(first, 0.8);
  EXPECT_LT(last, 0.2);
  // As much light from both where the near one has 1 / (1 + 30^2 / 20^2) of the footprint, which two of the four rays
  // pass: half of a quarter, and two quarters of all places of the edge.
  EXPECT_NEAR(strongest, 0.625, 0.06);
}

TEST(ScanMaker, BeamsEnterCrownsToAnExponentialDepthAndMayPass) {
  World world = wall_world(40.0, Surface::concrete);
  add_box(world.things, {20.0F, -60.0F, 40.0F}, {21.0F, 60.0F, 160.0F}, {Surface::foliage, truth::kVegetation});
  Sensor sensor = clean_sensor();
  sensor.pattern.field_of_view_deg = 8.0;
  const Rig rig(world, sensor, standing({0, 0, 0}), kHigh);
  double passed = 0.0;
  std::vector<double> depths;
  for (std::size_t k = 0; k < 5; ++k) {
    const MadeScan scan = rig.make(k);
    for (std::size_t i = 0; i < scan.labels.size(); ++i) {
      ASSERT_TRUE(is_return(scan, i));
      if (scan.labels[i] == truth::kBuilding) {
        passed += 1.0;
      } else {
        ASSERT_EQ(scan.labels[i], truth::kVegetation);
        depths.push_back(static_cast<double>(scan.points.x[i]) - 20.0);
      }
    }
  }
  const double all = passed + static_cast<double>(depths.size());
  const double through = std::exp(-1.0 / 0.6);
  EXPECT_NEAR(passed / all, through, 5.0 * std::sqrt(through / all) + 0.002);
  // Mean of an exponential of 0.6 m that ends at 1 m.
  EXPECT_NEAR(statistics(depths).mean, 0.6 - through / (1.0 - through), 0.01);
}

TEST(ScanMaker, NetsLetBeamsThroughAndTrunksInCrownsAreMet) {
  World world = wall_world(40.0, Surface::concrete);
  add_quad(world.things, {10.0F, 60.0F, 40.0F}, {10.0F, -60.0F, 40.0F}, {10.0F, -60.0F, 160.0F}, {10.0F, 60.0F, 160.0F},
           {Surface::net, truth::kFence});
  add_box(world.things, {20.0F, -60.0F, 40.0F}, {24.0F, 60.0F, 160.0F}, {Surface::foliage, truth::kVegetation});
  add_box(world.things, {20.5F, -60.0F, 40.0F}, {21.0F, 60.0F, 160.0F}, {Surface::bark, truth::kPole});
  Sensor sensor = clean_sensor();
  sensor.pattern.field_of_view_deg = 8.0;
  const Rig rig(world, sensor, standing({0, 0, 0}), kHigh);
  double nets = 0.0;
  double crowns = 0.0;
  double trunks = 0.0;
  for (std::size_t k = 0; k < 5; ++k) {
    for (const std::uint32_t label : rig.make(k).labels) {
      nets += label == truth::kFence ? 1.0 : 0.0;
      crowns += label == truth::kVegetation ? 1.0 : 0.0;
      trunks += label == truth::kPole ? 1.0 : 0.0;
    }
  }
  const double all = nets + crowns + trunks;
  EXPECT_EQ(all, 50'000.0);
  EXPECT_NEAR(nets / all, 0.35, 0.011);
  EXPECT_NEAR(trunks / (crowns + trunks), std::exp(-0.5 / 0.6), 0.02);
}

TEST(ScanMaker, MarksMoversWithTheirNumberAndWhereTheyAreAtTheTimeOfTheBeam) {
  World world = world_of(plane_terrain(0.0, 0.0), 50.0);
  Mover mover;
  add_box(mover.mesh, {-1.0F, -1.0F, 0.0F}, {1.0F, 1.0F, 3.0F}, {Surface::paint, truth::kVehicle});
  mover.T_world_object.append(0, Pose::from_yaw_pitch_roll(0, 0, 0, {15.0, -6.0, 0.0}));
  mover.T_world_object.append(1'000'000'000, Pose::from_yaw_pitch_roll(0, 0, 0, {15.0, 6.0, 0.0}));
  world.movers = {mover, mover};
  world.movers[1].T_world_object = {};
  world.movers[1].T_world_object.append(0, Pose::from_yaw_pitch_roll(0, 0, 0, {25.0, 0.0, 0.0}));
  const Rig rig(world, clean_sensor(), standing({0, 0, 0}), Pose::from_yaw_pitch_roll(0, 0, 0, {0, 0, 2.0}));
  for (const std::size_t k : {0U, 8U}) {
    const MadeScan scan = rig.make(k);
    std::size_t first = 0;
    std::size_t second = 0;
    for (std::size_t i = 0; i < scan.labels.size(); ++i) {
      const Vector3d p = point(scan, i);
      if (scan.labels[i] == (truth::kMovingVehicle | (1U << 16U))) {
        ++first;
        const double middle_m = -6.0 + 12.0 * (to_seconds(scan.stamp_ns) + static_cast<double>(scan.points.time[i]));
        EXPECT_NEAR(p.y(), middle_m, 1.01);
        EXPECT_NEAR(p.x(), 15.0, 1.01);
      } else if (scan.labels[i] == (truth::kMovingVehicle | (2U << 16U))) {
        ++second;
        EXPECT_NEAR(p.x(), 25.0, 1.01);
      }
    }
    EXPECT_GT(first, 20U);
    EXPECT_GT(second, 20U);
  }
}

TEST(ScanMaker, SnowfallHidesWhatLiesBehind) {
  SnowfallConfig snowfall;
  snowfall.flakes_per_m3 = 2000.0;
  Sensor sensor = clean_sensor();
  sensor.optics.range_at_10_percent_m = 90.0;
  sensor.optics.near_field_m = 2.0;
  const Rig rig(wall_world(20.0, Surface::concrete), sensor, standing({0, 0, 0}), kHigh, snowfall);
  std::size_t flakes = 0;
  std::size_t walls = 0;
  const MadeScan scan = rig.make(0);
  for (std::size_t i = 0; i < scan.labels.size(); ++i) {
    flakes += scan.labels[i] == truth::kFallingSnow ? 1U : 0U;
    walls += scan.labels[i] == truth::kBuilding ? 1U : 0U;
    if (scan.labels[i] == truth::kFallingSnow) {
      EXPECT_LT(point(scan, i).x(), 20.5);
      EXPECT_GT(point(scan, i).norm(), 0.0);
    }
  }
  EXPECT_GT(flakes, 50U);
  EXPECT_GT(walls, 1000U);
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
