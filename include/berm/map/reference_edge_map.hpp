#pragma once

#include <cstddef>
#include <span>

#include <Eigen/Core>

#include "berm/geometry/voxel_hash.hpp"
#include "berm/map/edge_map.hpp"

namespace berm {

/// The edge map as document E has it: METHODS section 4, step 6. Every scan moves the log-odds of the voxels that it
/// saw and clamps them there and then, so the result depends on the order of scans, and parts of a drive cannot be
/// merged. For comparison with `EdgeMap`, which is what berm runs.
class ReferenceEdgeMap {
 public:
  /// Throws ConfigError as `EdgeMapConfig::check`.
  explicit ReferenceEdgeMap(const EdgeMapConfig& config);

  /// As `EdgeMap::add_scan`. An edge on one side says nothing of the other.
  void add_scan(std::span<const MappedEdge> edges, std::span<const Eigen::Vector3d> plain_m);

  /// Voxels that were seen.
  [[nodiscard]] std::size_t size() const { return voxels_.size(); }
  /// Natural logarithm of the odds of an edge on `side`; 0 where nothing was seen.
  [[nodiscard]] double log_odds(const VoxelKey& key, EdgeSide side) const;
  [[nodiscard]] bool is_edge(const VoxelKey& key, EdgeSide side) const;
  /// The voxels that are edges, each with as many hits as its log-odds are worth and no miss: what `extract_lines`
  /// takes.
  [[nodiscard]] EdgeMap edges() const;

 private:
  struct LogOdds {
    float left = 0.0F;
    float right = 0.0F;
  };

  EdgeMapConfig config_;
  EdgeOdds odds_;
  VoxelHash<LogOdds> voxels_;
};

}  // namespace berm
