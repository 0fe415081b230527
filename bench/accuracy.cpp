// What the ground methods get right, as tables: trivial baseline, method G, the default, and the default with its
// steps switched off one by one; then the default in every made world by itself. F1 in percent; ground and what is left
// out as `berm eval` has it.
//
//   BERM_DATA=FOLDER berm_accuracy        FOLDER holds kitti00 and wads36; without it the made terrains alone

#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <functional>
#include <memory>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include <fmt/core.h>

#include "berm/core/angle.hpp"
#include "berm/core/scan.hpp"
#include "berm/eval/label_metrics.hpp"
#include "berm/ground/polar_ground.hpp"
#include "berm/ground/terrain_ground.hpp"
#include "berm/io/label_file.hpp"
#include "berm/io/recording.hpp"
#include "made_terrains.hpp"
#include "world_table.hpp"

namespace berm::bench {
namespace {

namespace fs = std::filesystem;

struct LabelledScan {
  PointCloud cloud;
  Pose T_base_sensor;
  std::vector<std::uint32_t> truth;
};

/// A column of the table.
struct Series {
  std::string name;
  bool made;  ///< of made worlds, each of which counts the same; else the points of all scans count together
  std::vector<LabelledScan> scans;
};

/// A row of the table.
struct Method {
  std::string name;
  std::function<std::unique_ptr<GroundSegmenter>()> make;
};

Pose mount(double height_m, double pitch_deg = 0.0, double roll_deg = 0.0) {
  return Pose::from_yaw_pitch_roll(0.0, pitch_deg * kRadPerDeg, roll_deg * kRadPerDeg, {0.0, 0.0, height_m});
}

/// The cloud turned about the sensor; the method is not told.
PointCloud turned(const PointCloud& cloud, const Pose& turn) {
  const PointsView points = cloud.view();
  PointChannels channels;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Eigen::Vector3d p = turn * Eigen::Vector3d(points.x[i], points.y[i], points.z[i]);
    channels.x.push_back(static_cast<float>(p.x()));
    channels.y.push_back(static_cast<float>(p.y()));
    channels.z.push_back(static_cast<float>(p.z()));
  }
  return PointCloud(std::move(channels));
}

/// A copy in which one of `one_in` points below the sensor's waist lies farther out on its beam, and so below the
/// ground, as mirrored returns of wet asphalt do. Those points are left out of the truth.
Series with_reflections(const std::string& name, const Series& from, unsigned one_in) {
  Series series{name, false, {}};
  std::minstd_rand random(1);
  for (const LabelledScan& scan : from.scans) {
    const PointsView points = scan.cloud.view();
    PointChannels channels{{points.x.begin(), points.x.end()},
                           {points.y.begin(), points.y.end()},
                           {points.z.begin(), points.z.end()},
                           {},
                           {},
                           {},
                           {}};
    std::vector<std::uint32_t> truth = scan.truth;
    for (std::size_t i = 0; i < points.size(); ++i) {
      if (points.z[i] < -1.0F && random() % one_in == 0) {
        const float farther = 1.1F + 0.0004F * static_cast<float>(random() % 1000);
        channels.x[i] *= farther;
        channels.y[i] *= farther;
        channels.z[i] *= farther;
        truth[i] = 0;
      }
    }
    series.scans.push_back({PointCloud(std::move(channels)), scan.T_base_sensor, std::move(truth)});
  }
  return series;
}

Series read_series(const std::string& name, const fs::path& folder, double height_m, double pitch_deg,
                   double roll_deg) {
  const Recording recording = Recording::open(folder);
  Series series{name, false, {}};
  for (std::size_t i = 0; i < recording.size(); ++i) {
    const ScanEntry entry = recording.scan(i);
    if (entry.truth_labels) {
      Scan scan;
      recording.read(i, scan);
      std::vector<std::uint32_t> truth = read_labels(*entry.truth_labels, scan.cloud.size());
      series.scans.push_back({turned(scan.cloud, mount(0.0, pitch_deg, roll_deg)), mount(height_m), std::move(truth)});
    }
  }
  return series;
}

Series make_series(const NamedSensor& sensor) {
  Series series{sensor.name, true, {}};
  for (const auto& [name, world] : made_terrains()) {
    test::MadeScan made =
        test::cast(world, sensor.beams, test::standing_at_origin(world, sensor.height_m, sensor.pitch_deg));
    std::vector<std::uint32_t> truth = truth_of(made);
    series.scans.push_back({std::move(made.cloud), mount_of(sensor), std::move(truth)});
  }
  return series;
}

std::vector<Series> collect_series() {
  std::vector<Series> all;
  const char* data = std::getenv("BERM_DATA");
  if (data != nullptr && fs::exists(fs::path(data) / "kitti00")) {
    const fs::path kitti = fs::path(data) / "kitti00";
    all.push_back(read_series("KITTI", kitti, 1.73, 0.0, 0.0));
    all.push_back(read_series("pitch 10", kitti, 1.73, 10.0, 0.0));
    all.push_back(read_series("pitch 20", kitti, 1.73, 20.0, 0.0));
    all.push_back(read_series("roll 15", kitti, 1.73, 0.0, 15.0));
    all.push_back(with_reflections("mirror .3", all.front(), 300));
    all.push_back(with_reflections("mirror 1", all.front(), 100));
  }
  if (data != nullptr && fs::exists(fs::path(data) / "wads36")) {
    all.push_back(read_series("WADS", fs::path(data) / "wads36", 2.0, 0.0, 0.0));
  }
  for (const NamedSensor& sensor : made_sensors()) {
    all.push_back(make_series(sensor));
  }
  return all;
}

/// F1 in percent.
double measure_f1(GroundSegmenter& ground, const Series& series) {
  BinaryCounts pooled;
  double sum = 0.0;
  for (const LabelledScan& scan : series.scans) {
    const GroundResult result = ground.process(scan.cloud.view(), scan.T_base_sensor);
    const BinaryCounts counts = judge_ground(labels_of(result), scan.truth);
    pooled += counts;
    sum += derive_metrics(counts).f1.value_or(0.0);
  }
  return 100.0 *
         (series.made ? sum / static_cast<double>(series.scans.size()) : derive_metrics(pooled).f1.value_or(0.0));
}

Method variant(const std::string& name, const std::function<void(TerrainGroundConfig&)>& change) {
  return {name, [change] {
            TerrainGroundConfig config;
            change(config);
            return std::make_unique<TerrainGround>(config);
          }};
}

std::vector<Method> methods() {
  using C = TerrainGroundConfig;
  return {
      variant("baseline: flat ground below the mount",
              [](C& c) { c.level = c.follow = c.strict_at_objects = c.smooth = false; }),
      {"reference: method G", [] { return std::make_unique<PolarGround>(PolarGroundConfig{}); }},
      variant("default", [](C&) {}),
      variant("  without level (the mount is trusted)", [](C& c) { c.level = false; }),
      variant("  without follow (the plane is the ground)", [](C& c) { c.follow = false; }),
      variant("  without smooth", [](C& c) { c.smooth = false; }),
      variant("  without strict_at_objects", [](C& c) { c.strict_at_objects = false; }),
      variant("  without reject_reflections", [](C& c) { c.reject_reflections = false; }),
      variant("  gate not widened (gate_sigmas 0)", [](C& c) { c.gate_sigmas = 0.0; }),
      variant("  no wandering slope (curvature 0)", [](C& c) { c.curvature = 0.0; }),
      variant("  no wandering height (roughness_m 0)", [](C& c) { c.roughness_m = 0.0; }),
      variant("  cells twice as long (cell_m 0.5)", [](C& c) { c.cell_m = 0.5; }),
      variant("  half the sectors (90)", [](C& c) { c.sectors = 90; }),
      variant("  twice the sectors (360)", [](C& c) { c.sectors = 360; }),
  };
}

void print_table() {
  const std::vector<Series> all = collect_series();
  fmt::print("{:<44}", "ground F1, %");
  for (const Series& series : all) {
    fmt::print("{:>10}", series.name);
  }
  fmt::print("\n");
  for (const Method& method : methods()) {
    fmt::print("{:<44}", method.name);
    for (const Series& series : all) {
      const std::unique_ptr<GroundSegmenter> ground = method.make();
      fmt::print("{:>10.2f}", measure_f1(*ground, series));
    }
    fmt::print("\n");
  }
}

}  // namespace
}  // namespace berm::bench

int main() {
  berm::bench::print_table();
  berm::bench::print_world_table();
  return 0;
}
