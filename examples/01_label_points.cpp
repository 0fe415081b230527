// Points that you have in memory in, ground or not per point out. Needs berm::ground, which needs Eigen alone.

#include <cmath>
#include <cstdio>
#include <numbers>
#include <utility>

#include "berm/ground/terrain_ground.hpp"

namespace {

constexpr double kSensorHeight_m = 2.0;
constexpr double kWallDistance_m = 15.0;
constexpr int kColumns = 900;
constexpr int kRings = 32;

// A spinning sensor on flat ground, with a wall across its way.
berm::PointCloud made_scan() {
  berm::PointChannels channels;
  for (int column = 0; column < kColumns; ++column) {
    const double azimuth_rad = 2.0 * std::numbers::pi * column / kColumns;
    for (int ring = 0; ring < kRings; ++ring) {
      const double elevation_rad = (-24.0 + 0.8 * ring) * std::numbers::pi / 180.0;
      const double x = std::cos(elevation_rad) * std::cos(azimuth_rad);
      const double y = std::cos(elevation_rad) * std::sin(azimuth_rad);
      const double z = std::sin(elevation_rad);
      const double to_ground_m = z < 0.0 ? -kSensorHeight_m / z : 1e9;
      const double to_wall_m = x > 0.0 ? kWallDistance_m / x : 1e9;
      const double range_m = std::fmin(to_ground_m, to_wall_m);
      // Beams that meet nothing stay in the cloud, as (0, 0, 0).
      const double reach_m = range_m < 80.0 ? range_m : 0.0;
      channels.x.push_back(static_cast<float>(reach_m * x));
      channels.y.push_back(static_cast<float>(reach_m * y));
      channels.z.push_back(static_cast<float>(reach_m * z));
    }
  }
  return berm::PointCloud(std::move(channels));
}

}  // namespace

int main() {
  const berm::PointCloud cloud = made_scan();
  const berm::Pose T_base_sensor = berm::Pose::from_yaw_pitch_roll(0.0, 0.0, 0.0, {0.0, 0.0, kSensorHeight_m});

  // Keep the object from scan to scan: it reuses its memory. The result is valid until the next call.
  berm::TerrainGround ground{berm::TerrainGroundConfig{}};
  const berm::GroundResult result = ground.process(cloud.view(), T_base_sensor);

  std::printf("%zu points: %zu ground, %zu not ground, %zu without return, %zu invalid\n", cloud.size(),
              result.counts.ground, result.counts.not_ground, result.counts.no_return, result.counts.invalid);
  const bool plausible = result.counts.ground > result.counts.not_ground && result.counts.not_ground > 0;
  return plausible ? 0 : 1;
}
