#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "berm/edge/edge.hpp"
#include "berm/io/edges_file.hpp"
#include "berm/sim/terrain.hpp"

namespace berm::bench {

/// An edge point in the world frame.
struct WorldEdge {
  EdgePoint point;
  Eigen::Vector3d place_m;
};

/// What is true of the roads of a recording.
struct RoadTruth {
  std::vector<Edge> edges;
  std::shared_ptr<const sim::Terrain> terrain;
  std::vector<Eigen::Vector3d> path_m;
};

/// How single edge points compare with the truth.
struct EdgeScore {
  std::size_t scans = 0;
  double points_a_scan = 0.0;    ///< within 25 m of the path
  double within = 0.0;           ///< share within 0.5 m of an edge
  double median_m = 0.0;         ///< distance of these
  double p95_m = 0.0;            ///< distance of all
  double wrong_side = 0.0;       ///< share of those within 0.5 m
  double seen = 0.0;             ///< share of the edges that have a point within 0.5 m
  double height_median_m = 0.0;  ///< of the error of the height, where one is given
};

[[nodiscard]] EdgeScore score(const std::vector<WorldEdge>& found, const RoadTruth& truth, std::size_t scans);

/// x, y, z, distance to the truth, height, width, confidence, side, kind: a line each.
void dump(const std::filesystem::path& file, const std::vector<WorldEdge>& found, const RoadTruth& truth);

}  // namespace berm::bench
