#include "recording_writer.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "berm/core/angle.hpp"
#include "berm/core/version.hpp"
#include "berm/io/atomic_file.hpp"
#include "berm/io/edges_file.hpp"
#include "berm/io/height_raster.hpp"
#include "berm/io/label_file.hpp"
#include "berm/io/pcd.hpp"
#include "berm/io/sensor_sheet.hpp"
#include "berm/io/settings.hpp"
#include "berm/io/settings_folders.hpp"
#include "berm/io/times_file.hpp"
#include "berm/io/trajectory_file.hpp"

namespace berm::sim {
namespace {

/// How far around the way the true terrain is written, and its cells.
constexpr double kTerrainMargin_m = 50.0;
constexpr double kTerrainCell_m = 0.5;
/// 4 million heights are 35 MB of text: a longer way gets larger cells.
constexpr double kMaxTerrainCells = 4e6;

PointsView view_of(const PointChannels& points) {
  PointsView view;
  view.x = points.x;
  view.y = points.y;
  view.z = points.z;
  view.intensity = points.intensity;
  view.time = points.time;
  view.ring = points.ring;
  return view;
}

Area area_around(const Trajectory& driven, const Area& limits) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  Area area{kInfinity, kInfinity, -kInfinity, -kInfinity};
  for (const StampedPose& pose : driven.poses()) {
    const Eigen::Vector3d& p = pose.T_world_base.translation_m();
    area.min_x_m = std::min(area.min_x_m, p.x());
    area.min_y_m = std::min(area.min_y_m, p.y());
    area.max_x_m = std::max(area.max_x_m, p.x());
    area.max_y_m = std::max(area.max_y_m, p.y());
  }
  area.min_x_m = std::max(limits.min_x_m, area.min_x_m - kTerrainMargin_m);
  area.min_y_m = std::max(limits.min_y_m, area.min_y_m - kTerrainMargin_m);
  area.max_x_m = std::min(limits.max_x_m, area.max_x_m + kTerrainMargin_m);
  area.max_y_m = std::min(limits.max_y_m, area.max_y_m + kTerrainMargin_m);
  return area;
}

HeightRaster sample_terrain(const Terrain& terrain, const Area& area) {
  HeightRaster raster;
  const double width_m = area.max_x_m - area.min_x_m;
  const double height_m = area.max_y_m - area.min_y_m;
  raster.cell_m = kTerrainCell_m;
  while (width_m * height_m > kMaxTerrainCells * raster.cell_m * raster.cell_m) {
    raster.cell_m *= 2.0;
  }
  raster.origin_x_m = std::floor(area.min_x_m / raster.cell_m) * raster.cell_m;
  raster.origin_y_m = std::floor(area.min_y_m / raster.cell_m) * raster.cell_m;
  raster.columns = std::max<std::size_t>(2, static_cast<std::size_t>(width_m / raster.cell_m));
  raster.rows = std::max<std::size_t>(2, static_cast<std::size_t>(height_m / raster.cell_m));
  raster.heights_m.reserve(raster.columns * raster.rows);
  for (std::size_t row = 0; row < raster.rows; ++row) {
    const double y_m = raster.origin_y_m + (static_cast<double>(row) + 0.5) * raster.cell_m;
    for (std::size_t column = 0; column < raster.columns; ++column) {
      const double x_m = raster.origin_x_m + (static_cast<double>(column) + 0.5) * raster.cell_m;
      raster.heights_m.push_back(static_cast<float>(terrain.at(x_m, y_m).height_m));
    }
  }
  return raster;
}

SensorSheet sheet_of(const Scenario& scenario, const Sensor& sensor, std::uint64_t seed, const World& world) {
  SensorSheet sheet;
  sheet.sensor = sensor.sensor.name;
  sheet.height_m = scenario.mount.height_m;
  sheet.pitch_rad = scenario.mount.pitch_deg * kRadPerDeg;
  if (scenario.mount.roll_deg != 0.0) {
    sheet.roll_rad = scenario.mount.roll_deg * kRadPerDeg;
  }
  if (scenario.mount.yaw_deg != 0.0) {
    sheet.yaw_rad = scenario.mount.yaw_deg * kRadPerDeg;
  }
  sheet.scan_hz = sensor.pattern.scan_hz;
  sheet.scenario = scenario.scenario.name;
  sheet.seed = seed;
  sheet.program = "berm " + std::string(version());
  sheet.world_origin_m = {world.origin_m.x(), world.origin_m.y(), world.origin_m.z()};
  return sheet;
}

/// The scenario as it can be made again from the folder of the recording.
Scenario to_be_kept(Scenario scenario) {
  if (is_settings_file(scenario.scenario.sensor)) {
    scenario.scenario.sensor = "sensor.yaml";
  }
  if (!scenario.world.elevation.empty()) {
    scenario.world.elevation = std::filesystem::absolute(scenario.world.elevation).string();
  }
  return scenario;
}

}  // namespace

OutputResults recording_results() {
  return {"simulation",
          "sequence.json",
          "\"program\": \"berm ",
          {"times.txt", "gnss.tum", "truth.tum", "edges.csv", "terrain.asc", "scenario.yaml", "sensor.yaml"},
          {{"scans", ".pcd"}, {"labels", ".label"}}};
}

void RecordingWriter::write_scan(std::size_t index, const MadeScan& scan) const {
  const std::string name = fmt::format("{:06}", index);
  write_pcd(folder_ / "scans" / (name + ".pcd"), view_of(scan.points));
  write_labels(folder_ / "labels" / (name + ".label"), scan.labels);
}

void RecordingWriter::write_poses(const Trajectory& truth, const Trajectory& measured) const {
  write_tum(folder_ / "truth.tum", truth);
  if (!measured.empty()) {
    write_tum(folder_ / "gnss.tum", measured);
  }
}

void RecordingWriter::write_scan_times(std::span<const Stamp> stamps) const {
  write_times(folder_ / "times.txt", stamps);
}

void RecordingWriter::write_world(const World& world, const Trajectory& driven) const {
  std::vector<Edge> edges;
  for (const EdgeLine& line : world.edges) {
    if (line.vertices_m.size() >= 2) {
      edges.push_back({line.left, line.vertices_m});
    }
  }
  write_edges(folder_ / "edges.csv", edges);
  write_ascii_grid(folder_ / "terrain.asc", sample_terrain(*world.terrain, area_around(driven, world.area)));
}

void RecordingWriter::write_settings(const Scenario& scenario, const Sensor& sensor, std::uint64_t seed,
                                     const World& world) const {
  write_file_atomically(folder_ / "scenario.yaml", to_yaml(to_be_kept(scenario)));
  write_file_atomically(folder_ / "sensor.yaml", to_yaml(sensor));
  write_sensor_sheet(folder_ / "sequence.json", sheet_of(scenario, sensor, seed, world));
}

}  // namespace berm::sim
