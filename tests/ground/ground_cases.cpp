#include "ground/ground_cases.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "berm/core/angle.hpp"

namespace berm::test {
namespace {

/// A parabola around the origin that goes on straight where it has become 30 deg steep, at 25 m.
double dome_m(double distance_m) {
  constexpr double kEdge_m = 25.0;
  const double slope = std::tan(30.0 * kRadPerDeg);
  const double inner_m = std::min(distance_m, kEdge_m);
  return 0.5 * slope * inner_m * inner_m / kEdge_m + slope * (distance_m - inner_m);
}

World street_on(std::function<double(double, double)> terrain_m) {
  World world = made_street(7);
  world.terrain_m = std::move(terrain_m);
  return world;
}

}  // namespace

PointCloud cloud_of(const std::vector<Eigen::Vector3f>& points) {
  PointChannels channels;
  for (const Eigen::Vector3f& p : points) {
    channels.x.push_back(p.x());
    channels.y.push_back(p.y());
    channels.z.push_back(p.z());
  }
  return PointCloud(std::move(channels));
}

std::vector<Eigen::Vector3f> points_of(const PointsView& view) {
  std::vector<Eigen::Vector3f> points;
  for (std::size_t i = 0; i < view.size(); ++i) {
    points.emplace_back(view.x[i], view.y[i], view.z[i]);
  }
  return points;
}

PointCloud turned(const PointsView& view, double yaw_deg, double pitch_deg, double roll_deg) {
  const Pose turn = Pose::from_yaw_pitch_roll(yaw_deg * kRadPerDeg, pitch_deg * kRadPerDeg, roll_deg * kRadPerDeg,
                                              Eigen::Vector3d::Zero());
  std::vector<Eigen::Vector3f> points = points_of(view);
  for (Eigen::Vector3f& p : points) {
    p = (turn * p.cast<double>()).cast<float>();
  }
  return cloud_of(points);
}

Pose mount(double height_m) {
  return Pose::from_yaw_pitch_roll(0.0, 0.0, 0.0, {0.0, 0.0, height_m});
}

std::vector<GroundClass> classes_of(const GroundResult& result) {
  return {result.classes.begin(), result.classes.end()};
}

double ground_f1(const GroundResult& result, const MadeScan& scan) {
  double hits = 0.0;
  double errors = 0.0;
  for (std::size_t i = 0; i < scan.is_terrain.size(); ++i) {
    const bool ground = result.classes[i] == GroundClass::ground;
    hits += ground && scan.is_terrain[i] ? 1.0 : 0.0;
    errors += ground != scan.is_terrain[i] ? 1.0 : 0.0;
  }
  return hits / (hits + 0.5 * errors);
}

bool counts_add_up(const GroundResult& result, std::size_t points) {
  const auto count = [&result](GroundClass wanted) {
    return static_cast<std::size_t>(std::count(result.classes.begin(), result.classes.end(), wanted));
  };
  const GroundCounts& counts = result.counts;
  return result.classes.size() == points && counts.ground == count(GroundClass::ground) &&
         counts.not_ground == count(GroundClass::not_ground) && counts.no_return == count(GroundClass::no_return) &&
         counts.invalid == count(GroundClass::invalid) &&
         counts.ground + counts.not_ground + counts.no_return + counts.invalid == points;
}

Terrain flat_street() {
  return {"flat street", street_on([](double, double) { return 0.0; })};
}

std::vector<Terrain> all_terrains() {
  const double slope = std::tan(30.0 * kRadPerDeg);
  return {
      flat_street(),
      {"slope along", street_on([slope](double x, double) { return slope * x; })},
      {"slope across", street_on([slope](double, double y) { return slope * y; })},
      {"bowl", street_on([](double x, double y) { return dome_m(std::hypot(x, y)); })},
      {"crest", street_on([](double x, double) { return -dome_m(std::fabs(x)); })},
      {"rolling hills", street_on([](double x, double y) {
         return 1.5 * std::sin(0.15 * x + 0.4) + 1.0 * std::sin(0.12 * y + 0.09 * x);
       })},
      {"ditch",
       street_on([](double, double y) { return -1.2 * std::exp(-(y - 7.0) * (y - 7.0) / (2.0 * 0.8 * 0.8)); })},
      {"rough ground", street_on([](double x, double y) {
         return 0.06 * std::sin(2.3 * x + 0.7 * y) + 0.06 * std::sin(1.9 * y - 0.8 * x) + 0.15 * std::sin(0.5 * x);
       })},
  };
}

Pose Sensor::T_world_sensor(const World& world) const {
  return standing_at_origin(world, height_m, pitch_deg);
}

Pose Sensor::T_base_sensor() const {
  return Pose::from_yaw_pitch_roll(0.0, pitch_deg * kRadPerDeg, 0.0, {0.0, 0.0, height_m});
}

MadeScan Sensor::look(const World& world, std::uint32_t seed) const {
  return cast(world, beams, T_world_sensor(world), {.seed = seed});
}

Sensor rings_64() {
  return {"64 rings", spinning_beams(64, -24.9, 2.0, 900), 1.73, 0.0};
}

Sensor rings_16() {
  return {"16 rings", spinning_beams(16, -15.0, 15.0, 1800), 1.73, 0.0};
}

Sensor rosette() {
  return {"rosette", rosette_beams(70.4, 20000), 2.3, 11.0};
}

}  // namespace berm::test
