#include "made_terrains.hpp"

#include <cmath>
#include <functional>
#include <numbers>
#include <random>
#include <utility>

namespace berm::bench {
namespace {

using Terrain = std::function<double(double, double)>;

/// Gravel and tussocks: a few centimetres over a metre or less.
double rough(double x, double y) {
  return 0.04 * std::sin(5.0 * x + 1.0) * std::sin(4.3 * y) + 0.03 * std::sin(11.0 * x + 7.0 * y);
}

/// Steeper and steeper up to 30 degrees at `steepest_m` from the middle, and no steeper beyond.
Terrain bowl(double steepest_m) {
  return [steepest_m](double x, double y) {
    constexpr double kSteepest = 0.577;
    const double r = std::hypot(x, y);
    return r < steepest_m ? kSteepest * r * r / (2.0 * steepest_m) : kSteepest * (r - 0.5 * steepest_m);
  };
}

/// Sixty boxes and poles within 5 .. 40 m.
test::World with_things(Terrain terrain, std::uint32_t seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  test::World world;
  world.terrain_m = std::move(terrain);
  for (int i = 0; i < 60; ++i) {
    const double azimuth = 2.0 * std::numbers::pi * unit(random);
    const double range = 5.0 + 35.0 * unit(random);
    const bool pole = i % 2 == 1;
    world.things.push_back({.x_m = range * std::cos(azimuth),
                            .y_m = range * std::sin(azimuth),
                            .half_length_m = pole ? 0.2 : 1.0 + 2.0 * unit(random),
                            .half_width_m = 1.0,
                            .height_m = pole ? 6.0 : 1.8,
                            .round = pole});
  }
  return world;
}

}  // namespace

std::vector<NamedWorld> made_terrains() {
  const std::pair<const char*, Terrain> terrains[] = {
      {"slope_30_deg_up", [](double x, double) { return 0.577 * x; }},
      {"slope_30_deg_across", [](double, double y) { return -0.577 * y; }},
      {"wide_bowl", bowl(46.0)},
      {"deep_bowl", bowl(20.0)},
      {"round_crest", [](double x, double) { return -x * x / 120.0; }},
      {"sharp_crest", [](double x, double) { return x < 15.0 ? 0.0 : -0.4 * (x - 15.0); }},
      {"hills", [](double x, double y) { return 2.5 * std::sin(x / 7.0) * std::cos(y / 9.0); }},
      {"rough", [](double x, double y) { return 2.0 * rough(x, y); }},
      {"rough_slope", [](double x, double y) { return 0.4 * x + rough(x, y); }},
      {"rough_waves", [](double x, double y) { return 0.5 * std::sin(x / 6.0) + rough(x, y); }},
      {"ditch", [](double, double y) { return std::fmin(0.0, std::fabs(y - 7.0) / 1.5 - 1.0); }},
  };
  std::vector<NamedWorld> worlds = {{"street_1", test::made_street(1)}, {"street_2", test::made_street(2)}};
  std::uint32_t seed = 2;
  for (const auto& [name, terrain] : terrains) {
    worlds.push_back({name, with_things(terrain, seed++)});
  }
  return worlds;
}

std::vector<NamedSensor> made_sensors() {
  return {{"64 rings", test::spinning_beams(64, -25.0, 3.0, 1024), 1.8, 0.0},
          {"16 rings", test::spinning_beams(16, -15.0, 15.0, 1800), 3.0, 3.0},
          {"rosette", test::rosette_beams(70.4, 10000), 2.3, 11.0}};
}

Pose mount_of(const NamedSensor& sensor) {
  return Pose::from_yaw_pitch_roll(0.0, sensor.pitch_deg * std::numbers::pi / 180.0, 0.0, {0.0, 0.0, sensor.height_m});
}

std::vector<std::uint32_t> truth_of(const test::MadeScan& scan) {
  const PointsView points = scan.cloud.view();
  std::vector<std::uint32_t> truth;
  for (std::size_t i = 0; i < points.size(); ++i) {
    truth.push_back(is_no_return(points.x[i], points.y[i], points.z[i]) ? 0 : scan.is_terrain[i] ? 72 : 99);
  }
  return truth;
}

std::vector<std::uint32_t> labels_of(const GroundResult& result) {
  std::vector<std::uint32_t> labels;
  for (const GroundClass c : result.classes) {
    labels.push_back(c == GroundClass::ground ? 40 : 99);
  }
  return labels;
}

}  // namespace berm::bench
