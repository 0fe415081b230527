#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <Eigen/Core>

#include "berm/core/config.hpp"
#include "berm/core/edge.hpp"
#include "berm/geometry/voxel_hash.hpp"

namespace berm {

/// Settings of the edge map: METHODS section 4, step 6; the sensor model is OctoMap's.
struct EdgeMapConfig {
  double voxel_m = 0.2;
  double hit_probability = 0.7;
  double miss_probability = 0.4;
  double min_probability = 0.12;
  double max_probability = 0.97;
  double edge_probability = 0.7;

  static void fields(auto&& field) {
    field("voxel_m", &EdgeMapConfig::voxel_m, Range{0.02, 5.0}, "side of a voxel");
    field("hit_probability", &EdgeMapConfig::hit_probability, Range{0.5, 0.999}, "of an edge where one was seen");
    field("miss_probability", &EdgeMapConfig::miss_probability, Range{0.001, 0.5}, "of an edge where plain road was");
    field("min_probability", &EdgeMapConfig::min_probability, Range{0.0001, 0.5}, "no voxel falls below");
    field("max_probability", &EdgeMapConfig::max_probability, Range{0.5, 0.9999}, "no voxel rises above");
    field("edge_probability", &EdgeMapConfig::edge_probability, Range{0.01, 0.99}, "voxels from here on are edge");
  }
  void check() const { check_fields(*this, "map"); }
};

/// An edge point in the world frame.
struct MappedEdge {
  Eigen::Vector3d position_m;
  EdgeSide side = EdgeSide::left;
};

/// Where road edges were seen, and where they were not: counts per voxel, left and right apart. A scan counts once
/// per voxel. Counts only add up, each to 255 at most, so that maps of parts of a drive, merged in any order, are the
/// map of the whole, byte for byte. Probabilities follow from the counts.
class EdgeMap {
 public:
  struct Voxel {
    std::uint8_t left = 0;
    std::uint8_t right = 0;
    std::uint8_t miss = 0;
  };

  /// Throws ConfigError as `EdgeMapConfig::check`.
  explicit EdgeMap(const EdgeMapConfig& config);

  /// `plain_m`: places in the world frame that were seen to be plain road. A voxel with an edge in this scan takes no
  /// miss from it. Points too far out to be counted are left out.
  void add_scan(std::span<const MappedEdge> edges, std::span<const Eigen::Vector3d> plain_m);
  /// Adds the counts of another map. Throws Error(invalid_argument) if its voxels are of another size.
  void merge(const EdgeMap& other);

  [[nodiscard]] const EdgeMapConfig& config() const { return config_; }
  [[nodiscard]] const VoxelHash<Voxel>& voxels() const { return voxels_; }
  /// Log-odds of an edge on `side`, clamped as E asks.
  [[nodiscard]] double log_odds(const Voxel& voxel, EdgeSide side) const;
  [[nodiscard]] bool is_edge(const Voxel& voxel, EdgeSide side) const;

  /// The map as an OctoMap file (.ot) of a ColorOcTree: occupancy is the probability of an edge on either side, the
  /// colour holds the three counts: red left, green right, blue misses. Throws Error(invalid_argument) if it reaches
  /// farther than OctoMap's 32768 voxels from the origin. Same counts, same bytes.
  [[nodiscard]] std::string to_octomap() const;
  /// Reads what `to_octomap` wrote. Every count is checked against the bytes that are there before OctoMap sees them.
  /// Throws FileError naming `name` and the offset.
  [[nodiscard]] static EdgeMap from_octomap(std::string_view bytes, const std::string& name,
                                            const EdgeMapConfig& config);

 private:
  EdgeMapConfig config_;
  VoxelHash<Voxel> voxels_;
};

}  // namespace berm
