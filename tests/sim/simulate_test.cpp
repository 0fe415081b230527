#include "berm/sim/simulate.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <utility>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "berm/core/error.hpp"
#include "berm/io/edges_file.hpp"
#include "berm/io/height_raster.hpp"
#include "berm/io/label_file.hpp"
#include "berm/io/recording.hpp"
#include "berm/io/settings.hpp"
#include "berm/io/trajectory_file.hpp"
#include "support/temp_folder.hpp"

namespace berm::sim {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

/// A short, sparse recording on a small world, so that tests are quick.
Scenario small_scenario() {
  Scenario scenario = parse_scenario("scenario:\n  name: small\nmount:\n  height_m: 2.3\n  pitch_deg: 11\n", "s.yaml");
  for (const char* value : {"scenario.seconds=0.4", "route.length_m=80", "world.margin_m=40", "piste.forks=0",
                            "things.trees_per_hectare=50", "things.building_every_m=0", "traffic.parked=0"}) {
    set_value(scenario, value, value);
  }
  return scenario;
}

Sensor small_sensor() {
  Sensor sensor = read_sensor(find_sensor("livox_mid70", {fs::path(BERM_SOURCE_FOLDER) / "sensors"}));
  sensor.pattern.points_per_s = 5000.0;
  return sensor;
}

/// Every file below `folder` with its bytes.
std::map<std::string, std::string> content_of(const fs::path& folder) {
  std::map<std::string, std::string> content;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    if (entry.is_regular_file()) {
      content[fs::relative(entry.path(), folder).string()] = test::slurp(entry.path());
    }
  }
  return content;
}

std::string error_of(const Scenario& scenario, const Sensor& sensor, const fs::path& output) {
  SimulateOptions options;
  options.output = output;
  try {
    static_cast<void>(simulate(scenario, sensor, options));
  } catch (const Error& error) {
    return error.what();
  }
  return "no error";
}

class SimulateTest : public testing::Test {
 protected:
  SimulateSummary make(const Scenario& scenario, const std::string& name, std::uint64_t seed = 1,
                       std::size_t threads = 1) {
    SimulateOptions options;
    options.output = folder_ / name;
    options.seed = seed;
    options.threads = threads;
    return simulate(scenario, small_sensor(), options);
  }

  test::TempFolder folder_;
};

TEST_F(SimulateTest, WritesAWholeSequenceFolder) {
  const Scenario scenario = small_scenario();
  const SimulateSummary summary = make(scenario, "r", 18446744073709551615ULL);
  EXPECT_EQ(summary.scans, 4U);
  EXPECT_EQ(summary.beams, 2000U);
  EXPECT_GT(summary.returns, 500U);
  EXPECT_FALSE(summary.interrupted);
  EXPECT_FALSE(fs::exists(folder_ / "r/.berm-unfinished"));

  const Recording recording = Recording::open(folder_ / "r");
  EXPECT_THAT(recording.notes(), testing::IsEmpty()) << recording.notes().front();
  EXPECT_EQ(recording.layout(), RecordingLayout::sequence);
  EXPECT_EQ(recording.stamp_source(), StampSource::times_file);
  EXPECT_EQ(recording.sheet().height_m, 2.3);
  EXPECT_EQ(recording.sheet().scan_hz, 10.0);
  EXPECT_EQ(recording.sheet().scenario, "small");
  EXPECT_EQ(recording.sheet().seed, 18446744073709551615ULL);
  ASSERT_EQ(recording.size(), 4U);
  for (std::size_t i = 0; i < recording.size(); ++i) {
    const ScanEntry entry = recording.scan(i);
    EXPECT_EQ(entry.stamp_ns, static_cast<Stamp>(i) * 100'000'000);
    Scan scan;
    recording.read(i, scan);
    EXPECT_EQ(scan.cloud.size(), 500U);
    EXPECT_EQ(scan.cloud.view().time.size(), 500U);
    EXPECT_EQ(read_labels(entry.truth_labels.value(), 500).size(), 500U);
  }
  const Trajectory truth = recording.read_truth_poses().value();
  EXPECT_EQ(truth.size(), 42U);
  EXPECT_EQ(recording.read_given_poses()->trajectory.size(), truth.size());
  EXPECT_EQ(to_yaml(parse_scenario(test::slurp(folder_ / "r/scenario.yaml"), "s")), to_yaml(scenario));
  EXPECT_EQ(to_yaml(parse_sensor(test::slurp(folder_ / "r/sensor.yaml"), "s")), to_yaml(small_sensor()));
}

TEST_F(SimulateTest, GroundReturnsLieOnTheTerrainThatIsWritten) {
  Scenario scenario = small_scenario();
  set_value(scenario, "piste.rough_snow_m=0", "test");
  static_cast<void>(make(scenario, "r"));
  const HeightRaster terrain = read_height_raster(folder_ / "r/terrain.asc");
  const Recording recording = Recording::open(folder_ / "r");
  const Trajectory truth = recording.read_truth_poses().value();
  std::vector<double> errors_m;
  for (std::size_t i = 0; i < recording.size(); ++i) {
    Scan scan;
    recording.read(i, scan);
    const auto labels = read_labels(recording.scan(i).truth_labels.value(), scan.cloud.size());
    const PointsView points = scan.cloud.view();
    for (std::size_t k = 0; k < points.size(); ++k) {
      if (semantic_class(labels[k]) != truth::kDrivable) {
        continue;
      }
      const Stamp stamp_ns = scan.stamp_ns + from_seconds(static_cast<double>(points.time[k]));
      const Pose T_world_sensor = truth.at(stamp_ns).value() * scenario.mount.T_base_sensor();
      const Eigen::Vector3d p = T_world_sensor * Eigen::Vector3d(points.x[k], points.y[k], points.z[k]);
      const double column = (p.x() - terrain.origin_x_m) / terrain.cell_m;
      const double row = (p.y() - terrain.origin_y_m) / terrain.cell_m;
      if (column < 0 || row < 0 || column >= static_cast<double>(terrain.columns) ||
          row >= static_cast<double>(terrain.rows)) {
        continue;
      }
      errors_m.push_back(std::abs(
          p.z() - static_cast<double>(terrain.at(static_cast<std::size_t>(column), static_cast<std::size_t>(row)))));
    }
  }
  ASSERT_GT(errors_m.size(), 300U);
  std::sort(errors_m.begin(), errors_m.end());
  // The nearest cell of 0.5 m on a slope of up to 25 degrees: within 12 cm, and the noise.
  EXPECT_LT(errors_m[errors_m.size() / 2], 0.1);
  EXPECT_LT(errors_m[errors_m.size() * 95 / 100], 0.3);
}

TEST_F(SimulateTest, EdgesBoundTheWay) {
  static_cast<void>(make(small_scenario(), "r"));
  const auto edges = read_edges(folder_ / "r/edges.csv");
  const Trajectory truth = read_tum(folder_ / "r/truth.tum");
  const Pose& start = truth.poses().front().T_world_base;
  for (const bool left : {true, false}) {
    double nearest_m = 1e9;
    double side_m = 0.0;
    for (const Edge& edge : edges) {
      for (const Eigen::Vector3d& vertex_m : edge.vertices_m) {
        const Eigen::Vector3d from_base = start.inverse() * vertex_m;
        if (edge.left == left && from_base.head<2>().norm() < nearest_m) {
          nearest_m = from_base.head<2>().norm();
          side_m = from_base.y();
        }
      }
    }
    EXPECT_LT(nearest_m, 30.0);
    EXPECT_GT(nearest_m, 2.0);
    EXPECT_EQ(side_m > 0.0, left);
  }
}

TEST_F(SimulateTest, TheSameBytesForAnyNumberOfThreadsOthersForAnotherSeed) {
  Scenario scenario = small_scenario();
  set_value(scenario, "snowfall.flakes_per_m3=3000", "test");
  static_cast<void>(make(scenario, "one", 3, 1));
  static_cast<void>(make(scenario, "three", 3, 3));
  static_cast<void>(make(scenario, "other", 4, 2));
  const auto one = content_of(folder_ / "one");
  EXPECT_EQ(one, content_of(folder_ / "three"));
  const auto other = content_of(folder_ / "other");
  ASSERT_EQ(one.size(), other.size());
  for (const auto& [file, bytes] : one) {
    const bool same_for_all = file == "times.txt" || file == "scenario.yaml" || file == "sensor.yaml";
    EXPECT_EQ(other.at(file) == bytes, same_for_all) << file;
  }
}

TEST_F(SimulateTest, InTheSnowyScenariosAsManyBeamsMeetFlakesAsTheySay) {
  const fs::path root = BERM_SOURCE_FOLDER;
  for (const auto& [name, share] : {std::pair("groomer_snowfall", 0.05), std::pair("groomer_night_storm", 0.12)}) {
    Scenario scenario = read_scenario(root / "scenarios" / (std::string(name) + ".yaml"));
    Sensor sensor = read_sensor(find_sensor(scenario.scenario.sensor, {root / "sensors"}));
    scenario.scenario.seconds = 10.0;
    sensor.pattern.scan_hz = 1.0;  // a tenth of the beams, over as much time
    sensor.pattern.points_per_s = 10'000.0;
    SimulateOptions options;
    options.output = folder_ / name;
    options.threads = 2;
    const SimulateSummary summary = simulate(scenario, sensor, options);
    // Gusts of ten metres come and go: 10 s tell no better.
    const double found = static_cast<double>(summary.in_the_air) / static_cast<double>(summary.beams);
    EXPECT_NEAR(found / share, 1.0, 0.3) << name;
  }
}

TEST_F(SimulateTest, StoppedEarlyItLeavesNoSheet) {
  SimulateOptions options;
  options.output = folder_ / "r";
  std::size_t done = 0;
  options.on_progress = [&done](std::size_t scans, std::size_t) { done = scans; };
  options.should_stop = [&done] { return done == 2; };
  const SimulateSummary summary = simulate(small_scenario(), small_sensor(), options);
  EXPECT_TRUE(summary.interrupted);
  EXPECT_EQ(summary.scans, 2U);
  EXPECT_FALSE(fs::exists(folder_ / "r/sequence.json"));
  EXPECT_TRUE(fs::exists(folder_ / "r/.berm-unfinished"));
  EXPECT_THAT(error_of(small_scenario(), small_sensor(), folder_ / "r"), HasSubstr("simulation that did not finish"));
}

TEST_F(SimulateTest, WhatGoesWrongLeavesNothing) {
  Scenario scenario = small_scenario();
  scenario.scenario.seconds = 0.0;
  EXPECT_THAT(error_of(scenario, small_sensor(), folder_ / "r"),
              HasSubstr("scenario.seconds: 0 s leave no scan, expected at least 0.1 s"));
  scenario = small_scenario();
  scenario.scenario.seconds = 1000.0;
  EXPECT_THAT(error_of(scenario, small_sensor(), folder_ / "r"), HasSubstr("ask for at most"));
  scenario = small_scenario();
  scenario.mount.height_m = 0.0;
  EXPECT_THAT(error_of(scenario, small_sensor(), folder_ / "r"), HasSubstr("sensor: "));
  scenario = small_scenario();
  scenario.world.elevation = (folder_ / "none.asc").string();
  EXPECT_THAT(error_of(scenario, small_sensor(), folder_ / "r"), HasSubstr("none.asc"));
  EXPECT_THAT(folder_.names(), testing::IsEmpty());
}

TEST_F(SimulateTest, AMachineThatStandsIsFine) {
  Scenario scenario = small_scenario();
  scenario.vehicle.speed_m_per_s = 0.0;
  const SimulateSummary summary = make(scenario, "r");
  EXPECT_EQ(summary.scans, 4U);
  EXPECT_LT(summary.driven_m, 0.05);
}

}  // namespace
}  // namespace berm::sim
