#include "support/made_scan.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>
#include <utility>

#include "berm/core/angle.hpp"

namespace berm::test {
namespace {

using Eigen::Vector3d;

constexpr double kNothing = std::numeric_limits<double>::infinity();

/// Range to the terrain: steps no longer than the height above it allows for slopes up to 60 deg, then bisection.
double range_to_terrain(const World& world, const Vector3d& origin, const Vector3d& direction, double max_range_m) {
  const auto clearance = [&](double range) {
    const Vector3d p = origin + range * direction;
    return p.z() - world.terrain_m(p.x(), p.y());
  };
  double above = 0.0;
  for (double range = 0.0; range < max_range_m;) {
    const double height = clearance(range);
    if (height <= 0.0) {
      double below = range;
      for (int i = 0; i < 40; ++i) {
        const double middle = 0.5 * (above + below);
        (clearance(middle) > 0.0 ? above : below) = middle;
      }
      return below;
    }
    above = range;
    range += std::max(0.02, 0.5 * height);
  }
  return kNothing;
}

/// Nearest positive range at which the ray enters the slab lo..hi of every axis of a box.
double range_to_box(const Vector3d& lo, const Vector3d& hi, const Vector3d& origin, const Vector3d& direction) {
  double enter = 0.0;
  double leave = kNothing;
  for (int axis = 0; axis < 3; ++axis) {
    const double inverse = 1.0 / direction[axis];
    const double a = (lo[axis] - origin[axis]) * inverse;
    const double b = (hi[axis] - origin[axis]) * inverse;
    enter = std::max(enter, std::min(a, b));
    leave = std::min(leave, std::max(a, b));
  }
  return enter < leave && enter > 0.0 ? enter : kNothing;
}

double range_to_cylinder(const Thing& thing, double bottom_m, double top_m, const Vector3d& origin,
                         const Vector3d& direction) {
  const double ox = origin.x() - thing.x_m;
  const double oy = origin.y() - thing.y_m;
  const double a = direction.x() * direction.x() + direction.y() * direction.y();
  const double b = ox * direction.x() + oy * direction.y();
  const double c = ox * ox + oy * oy - thing.half_length_m * thing.half_length_m;
  const double root = b * b - a * c;
  if (a == 0.0 || root < 0.0) {
    return kNothing;
  }
  const double range = (-b - std::sqrt(root)) / a;
  const double z = origin.z() + range * direction.z();
  return range > 0.0 && z >= bottom_m && z <= top_m ? range : kNothing;
}

double range_to_thing(const World& world, const Thing& thing, const Vector3d& origin, const Vector3d& direction) {
  const double foot = world.terrain_m(thing.x_m, thing.y_m);
  const double top = foot + thing.height_m;
  if (thing.round) {
    return range_to_cylinder(thing, foot + thing.clearance_m, top, origin, direction);
  }
  // Down into the terrain, so that nothing shines through below a box on a slope.
  const double bottom = thing.clearance_m > 0.0 ? foot + thing.clearance_m : foot - 5.0;
  return range_to_box({thing.x_m - thing.half_length_m, thing.y_m - thing.half_width_m, bottom},
                      {thing.x_m + thing.half_length_m, thing.y_m + thing.half_width_m, top}, origin, direction);
}

}  // namespace

Beams spinning_beams(int rings, double min_elevation_deg, double max_elevation_deg, int columns) {
  Beams beams;
  for (int column = 0; column < columns; ++column) {
    const double azimuth = -2.0 * std::numbers::pi * column / columns;
    for (int ring = 0; ring < rings; ++ring) {
      const double share = rings > 1 ? static_cast<double>(ring) / (rings - 1) : 0.5;
      const double elevation = (min_elevation_deg + share * (max_elevation_deg - min_elevation_deg)) * kRadPerDeg;
      beams.directions.emplace_back(std::cos(elevation) * std::cos(azimuth), std::cos(elevation) * std::sin(azimuth),
                                    std::sin(elevation));
      beams.rings.push_back(static_cast<std::uint16_t>(ring));
    }
  }
  return beams;
}

Beams rosette_beams(double field_of_view_deg, int count) {
  Beams beams;
  const double half = 0.25 * field_of_view_deg * kRadPerDeg;
  for (int i = 0; i < count; ++i) {
    // Two prisms of equal deflection; the ratio of their speeds makes the petals and their slow turning.
    const double a = 2.0 * std::numbers::pi * i / 700.0;
    const double b = -a * 0.6178;
    const double y = half * (std::cos(a) + std::cos(b));
    const double z = half * (std::sin(a) + std::sin(b));
    beams.directions.push_back(Vector3d(1.0, std::tan(y), std::tan(z)).normalized());
  }
  return beams;
}

MadeScan cast(const World& world, const Beams& beams, const Pose& T_world_sensor, const CastOptions& options) {
  PointChannels channels;
  MadeScan scan;
  std::mt19937 random(options.seed);
  std::normal_distribution<double> noise(0.0, options.range_noise_m);
  const Vector3d origin = T_world_sensor.translation_m();
  const auto push = [&channels](const Vector3d& p) {
    channels.x.push_back(static_cast<float>(p.x()));
    channels.y.push_back(static_cast<float>(p.y()));
    channels.z.push_back(static_cast<float>(p.z()));
  };
  for (const Vector3d& beam : beams.directions) {
    const Vector3d direction = T_world_sensor.rotation() * beam;
    double range = range_to_terrain(world, origin, direction, options.max_range_m);
    bool terrain = true;
    for (const Thing& thing : world.things) {
      const double to_thing = range_to_thing(world, thing, origin, direction);
      if (to_thing < range) {
        range = to_thing;
        terrain = false;
      }
    }
    const bool met = range < options.max_range_m;
    push(met ? Vector3d((range + noise(random)) * beam) : Vector3d::Zero());
    scan.is_terrain.push_back(met && terrain);
  }
  channels.ring = beams.rings;
  scan.cloud = PointCloud(std::move(channels));
  return scan;
}

Pose standing_at_origin(const World& world, double height_m, double pitch_deg, double roll_deg) {
  return Pose::from_yaw_pitch_roll(0.0, pitch_deg * kRadPerDeg, roll_deg * kRadPerDeg,
                                   {0.0, 0.0, world.terrain_m(0.0, 0.0) + height_m});
}

World made_street(std::uint32_t seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  World world;
  const double phase = 6.0 * unit(random);
  world.terrain_m = [phase](double x, double y) {
    return 0.12 * std::sin(0.11 * x + phase) + 0.08 * std::sin(0.17 * y) + 0.004 * x;
  };
  for (int side = -1; side <= 1; side += 2) {
    for (double x = -60.0; x < 60.0; x += 14.0) {
      world.things.push_back({x + 6.0 * unit(random), side * (14.0 + 4.0 * unit(random)), 5.0, 2.0, 6.0, 0.0, false});
      world.things.push_back({x + 9.0 * unit(random), side * 5.5, 2.1, 0.9, 1.5, 0.25, false});
      world.things.push_back({x + 3.0 * unit(random), side * 8.0, 0.12, 0.12, 5.0, 0.0, true});
    }
  }
  return world;
}

}  // namespace berm::test
