#include "world_table.hpp"

#include <cmath>
#include <cstdint>
#include <vector>

#include <fmt/core.h>

#include "berm/eval/label_metrics.hpp"
#include "berm/ground/terrain_ground.hpp"
#include "made_terrains.hpp"

namespace berm::bench {
namespace {

constexpr double kFarthest_m = 30.0;

struct Reached {
  double f1;
  double within_3_sigma;
};

/// Share of the measured cells whose height is within three sigmas of the terrain's, along the plane's normal.
double share_within_3_sigma(const HeightGrid& surface, const test::World& world, const Pose& T_world_sensor) {
  const Pose T_world_level = T_world_sensor * surface.T_level_sensor().inverse();
  const double upright = (T_world_level.rotation() * Eigen::Vector3d::UnitZ()).z();
  const PolarGrid& grid = surface.grid();
  int seen = 0;
  int within = 0;
  for (int bin = 0; bin < grid.bins() && grid.center_range_m(bin) < kFarthest_m; ++bin) {
    for (int sector = 0; sector < grid.sectors(); ++sector) {
      const double x_m = grid.center_range_m(bin) * std::cos(grid.center_azimuth_rad(sector));
      const double y_m = grid.center_range_m(bin) * std::sin(grid.center_azimuth_rad(sector));
      const auto height = surface.at(x_m, y_m);
      if (!height || !surface.cell({sector, bin}).measured) {
        continue;
      }
      const Eigen::Vector3d p = T_world_level * Eigen::Vector3d(x_m, y_m, height->height_m);
      const double error_m = (p.z() - world.terrain_m(p.x(), p.y())) * upright;
      ++seen;
      within += std::fabs(error_m) < 3.0 * height->sigma_m ? 1 : 0;
    }
  }
  return seen > 0 ? static_cast<double>(within) / seen : 0.0;
}

Reached measure(const test::World& world, const NamedSensor& sensor) {
  const Pose T_world_sensor = test::standing_at_origin(world, sensor.height_m, sensor.pitch_deg);
  const test::MadeScan scan = test::cast(world, sensor.beams, T_world_sensor);
  TerrainGround ground({});
  const GroundResult result = ground.process(scan.cloud.view(), mount_of(sensor));
  const BinaryCounts counts = judge_ground(labels_of(result), truth_of(scan));
  return {derive_metrics(counts).f1.value_or(0.0), share_within_3_sigma(*result.surface, world, T_world_sensor)};
}

}  // namespace

void print_world_table() {
  const std::vector<NamedSensor> sensors = made_sensors();
  fmt::print("\n{:<24}", "default, single worlds, %");
  for (const char* figure : {"F1", "3 sigma"}) {
    for (const NamedSensor& sensor : sensors) {
      fmt::print("{:>18}", fmt::format("{} {}", figure, sensor.name));
    }
  }
  fmt::print("\n");
  for (const auto& [name, world] : made_terrains()) {
    std::vector<Reached> reached;
    for (const NamedSensor& sensor : sensors) {
      reached.push_back(measure(world, sensor));
    }
    fmt::print("{:<24}", name);
    for (const Reached& r : reached) {
      fmt::print("{:>18.2f}", 100.0 * r.f1);
    }
    for (const Reached& r : reached) {
      fmt::print("{:>18.1f}", 100.0 * r.within_3_sigma);
    }
    fmt::print("\n");
  }
}

}  // namespace berm::bench
