#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

#include <gtest/gtest.h>

#include "berm/sim/scan_maker.hpp"
#include "sim/scan_rig.hpp"

namespace berm::sim {
namespace {

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

}  // namespace
}  // namespace berm::sim
