#pragma once

#include <cstdint>
#include <random>
#include <vector>

#include <Eigen/Core>

#include "berm/core/edge.hpp"
#include "berm/map/edge_map.hpp"

namespace berm::test {

/// What one scan tells a map.
struct MadeScan {
  std::vector<MappedEdge> edges;
  std::vector<Eigen::Vector3d> plain_m;
};

/// A road as the points of its middle, a small step apart.
using Course = std::vector<Eigen::Vector3d>;

[[nodiscard]] Course straight_course(const Eigen::Vector3d& from_m, double heading_rad, double length_m);
/// Of a circle around `center_m`, counterclockwise from `from_rad`, for `turn_rad`.
[[nodiscard]] Course arc_course(const Eigen::Vector3d& center_m, double radius_m, double from_rad, double turn_rad);
/// Two bends of that radius, left then right, a quarter turn each.
[[nodiscard]] Course s_bend_course(double radius_m);

/// The course moved to its left.
[[nodiscard]] Course beside(const Course& course, double left_m);

struct MadeDrive {
  double half_width_m = 7.0;
  double scatter_m = 0.1;      ///< of edge points, along and across; a third of it upwards
  double hits_per_m = 20.0;    ///< of each edge, over the whole drive
  double outlier_share = 0.0;  ///< of the scans with a truck beside the road: 12 m of its side, seen once
  std::uint64_t seed = 1;
};

/// A drive along `course`, a scan every metre, each with what lies 15 m before and behind.
[[nodiscard]] std::vector<MadeScan> drive(const Course& course, const MadeDrive& how);

[[nodiscard]] EdgeMap map_of(const std::vector<MadeScan>& scans, const EdgeMapConfig& config = {});

/// How far `place_m` is from the course, horizontally.
[[nodiscard]] double distance_m(const Course& course, const Eigen::Vector3d& place_m);

/// Normally distributed enough, the same with every library.
[[nodiscard]] double made_noise(std::mt19937_64& random);
[[nodiscard]] double made_uniform(std::mt19937_64& random);

}  // namespace berm::test
