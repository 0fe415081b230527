#include "berm/map/reference_edge_map.hpp"

#include <algorithm>
#include <set>

namespace berm {

ReferenceEdgeMap::ReferenceEdgeMap(const EdgeMapConfig& config)
    : config_((config.check(), config)), odds_(edge_odds(config)), voxels_(config.voxel_m) {}

void ReferenceEdgeMap::add_scan(std::span<const MappedEdge> edges, std::span<const Eigen::Vector3d> plain_m) {
  const auto move = [&](float& log_odds, double by) {
    log_odds = static_cast<float>(std::clamp(log_odds + by, odds_.min, odds_.max));
  };
  std::set<VoxelKey> left;
  std::set<VoxelKey> right;
  std::set<VoxelKey> plain;
  for (const MappedEdge& edge : edges) {
    if (const auto key = voxels_.key_of(edge.position_m)) {
      (edge.side == EdgeSide::left ? left : right).insert(*key);
    }
  }
  for (const Eigen::Vector3d& position_m : plain_m) {
    if (const auto key = voxels_.key_of(position_m); key && !left.contains(*key) && !right.contains(*key)) {
      plain.insert(*key);
    }
  }
  for (const VoxelKey& key : left) {
    move(voxels_.at_or_new(key).left, odds_.hit);
  }
  for (const VoxelKey& key : right) {
    move(voxels_.at_or_new(key).right, odds_.hit);
  }
  for (const VoxelKey& key : plain) {
    LogOdds& voxel = voxels_.at_or_new(key);
    move(voxel.left, odds_.miss);
    move(voxel.right, odds_.miss);
  }
}

double ReferenceEdgeMap::log_odds(const VoxelKey& key, EdgeSide side) const {
  const LogOdds* voxel = voxels_.find(key);
  if (voxel == nullptr) {
    return 0.0;
  }
  return side == EdgeSide::left ? voxel->left : voxel->right;
}

bool ReferenceEdgeMap::is_edge(const VoxelKey& key, EdgeSide side) const {
  return log_odds(key, side) >= static_cast<float>(odds_.edge);
}

EdgeMap ReferenceEdgeMap::edges() const {
  EdgeMap map(config_);
  for (const VoxelKey& key : voxels_.sorted_keys()) {
    for (const EdgeSide side : {EdgeSide::left, EdgeSide::right}) {
      const MappedEdge edge{voxel_center_m(key, config_.voxel_m), side};
      for (double rest = is_edge(key, side) ? log_odds(key, side) : 0.0; rest > 0.0; rest -= odds_.hit) {
        map.add_scan(std::span(&edge, 1), {});
      }
    }
  }
  return map;
}

}  // namespace berm
