#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include <Eigen/Core>

#include "berm/core/stamp.hpp"
#include "berm/sim/scan_maker.hpp"
#include "sim/caster_worlds.hpp"

namespace berm::sim {

using Eigen::Vector3d;

/// A rosette that sees and hits whatever there is: no noise, no losses, a beam without width.
inline Sensor clean_sensor() {
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
inline Trajectory shaky_drive(const Terrain& terrain, double seconds) {
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

inline Trajectory standing(const Vector3d& place_m) {
  Trajectory trajectory;
  trajectory.append(0, Pose::from_yaw_pitch_roll(0.0, 0.0, 0.0, place_m));
  trajectory.append(100'000'000'000, Pose::from_yaw_pitch_roll(0.0, 0.0, 0.0, place_m));
  return trajectory;
}

inline const Pose kMount = Pose::from_yaw_pitch_roll(0.0, 0.2, 0.01, {0.5, 0.1, 2.3});

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

inline Vector3d point(const MadeScan& scan, std::size_t i) {
  return Eigen::Vector3f{scan.points.x[i], scan.points.y[i], scan.points.z[i]}.cast<double>();
}

inline bool is_return(const MadeScan& scan, std::size_t i) {
  return point(scan, i).squaredNorm() > 0.0;
}

/// An upright wall of one surface that fills the view, `range_m` ahead of a standing sensor at the origin.
inline World wall_world(double range_m, Surface surface, std::uint16_t truth_id = truth::kBuilding) {
  World world = world_of(plane_terrain(0.0, 0.0), 1.0);
  const auto x = static_cast<float>(range_m);
  add_quad(world.things, {x, 500.0F, -400.0F}, {x, -500.0F, -400.0F}, {x, -500.0F, 600.0F}, {x, 500.0F, 600.0F},
           {surface, truth_id});
  return world;
}

inline const Pose kHigh = Pose::from_yaw_pitch_roll(0.0, 0.0, 0.0, {0.0, 0.0, 100.0});

struct Statistics {
  double mean = 0.0;
  double sigma = 0.0;
  double count = 0.0;
};

inline Statistics statistics(const std::vector<double>& values) {
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
inline std::vector<double> range_errors(const Rig& rig, double range_m, std::size_t scans) {
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

}  // namespace berm::sim
