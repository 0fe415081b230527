#pragma once

#include <string>
#include <vector>

#include <Eigen/Core>

#include "berm/core/point_cloud.hpp"
#include "berm/core/pose.hpp"
#include "berm/ground/ground.hpp"
#include "support/made_scan.hpp"

/// Clouds, worlds and sensors that the tests of the ground stage share.
namespace berm::test {

[[nodiscard]] PointCloud cloud_of(const std::vector<Eigen::Vector3f>& points);
[[nodiscard]] std::vector<Eigen::Vector3f> points_of(const PointsView& view);

/// The cloud turned about the sensor.
[[nodiscard]] PointCloud turned(const PointsView& view, double yaw_deg, double pitch_deg, double roll_deg);

/// A level mount.
[[nodiscard]] Pose mount(double height_m);

/// The labels as a copy that outlives the next scan.
[[nodiscard]] std::vector<GroundClass> classes_of(const GroundResult& result);

/// Agreement with the truth over all returns, 0..1.
[[nodiscard]] double ground_f1(const GroundResult& result, const MadeScan& scan);

/// Whether the counts are those of the labels, and as many as there are points.
[[nodiscard]] bool counts_add_up(const GroundResult& result, std::size_t points);

/// A named world; the sensor stands at its origin.
struct Terrain {
  std::string name;
  World world;
};

/// The things of a street on the plane z = 0.
[[nodiscard]] Terrain flat_street();
/// The same things on slopes of 30 deg along and across the street, in a bowl, on a crest, on rolling hills, beside a
/// ditch, and on rough ground.
[[nodiscard]] std::vector<Terrain> all_terrains();

/// A named sensor, and how it is mounted.
struct Sensor {
  std::string name;
  Beams beams;
  double height_m;
  double pitch_deg;

  /// The sensor at the origin, standing upright in the world.
  [[nodiscard]] MadeScan look(const World& world, std::uint32_t seed = 1) const;
  [[nodiscard]] Pose T_world_sensor(const World& world) const;
  [[nodiscard]] Pose T_base_sensor() const;
};

[[nodiscard]] Sensor rings_64();
[[nodiscard]] Sensor rings_16();
/// 70.4 deg around the boresight, 11 deg nose down, 2.3 m up: the groomer of P.
[[nodiscard]] Sensor rosette();

}  // namespace berm::test
