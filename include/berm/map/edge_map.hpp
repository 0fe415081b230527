#pragma once

#include <array>
#include <cstddef>
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

/// What the settings are as natural logarithms of odds.
struct EdgeOdds {
  double hit = 0.0;
  double miss = 0.0;
  double min = 0.0;
  double max = 0.0;
  double edge = 0.0;
};
[[nodiscard]] EdgeOdds edge_odds(const EdgeMapConfig& config);

/// An edge point in the world frame.
struct MappedEdge {
  Eigen::Vector3d position_m;
  EdgeSide side = EdgeSide::left;
};

/// In how many scans an edge was seen in a voxel, and plain road; 255 stands for more, too.
struct EdgeVoxel {
  std::uint8_t left = 0;
  std::uint8_t right = 0;
  std::uint8_t miss = 0;

  friend bool operator==(const EdgeVoxel&, const EdgeVoxel&) = default;
  [[nodiscard]] bool is_seen() const { return left != 0 || right != 0 || miss != 0; }
};

/// Where road edges were seen, and where they were not: counts per voxel, left and right apart. A scan counts once
/// per voxel. Counts only add up, each to 255 at most, so that maps of parts of a drive, merged in any order, are the
/// map of the whole, byte for byte. Probabilities follow from the counts.
///
/// Voxels are those of a lattice that starts at the origin of the world frame, wherever the map lies: maps of one
/// world fit together without being moved, and coordinates of a UTM grid (5e6 m) lose nothing.
class EdgeMap {
 public:
  using Voxel = EdgeVoxel;

  /// `world` names the frame that positions are in, for instance its datum: one line of at most `kMaxWorldName`
  /// printable characters of ASCII, without blanks at its ends; empty where it is not known. Throws ConfigError as
  /// `EdgeMapConfig::check`, Error(invalid_argument) for another `world`.
  explicit EdgeMap(const EdgeMapConfig& config, std::string world = {});

  static constexpr std::size_t kMaxWorldName = 200;

  /// `plain_m`: places in the world frame that were seen to be plain road. A voxel with an edge in this scan takes no
  /// miss from it. Points that are not finite or too far out to be counted are left out; returns how many these were.
  std::size_t add_scan(std::span<const MappedEdge> edges, std::span<const Eigen::Vector3d> plain_m);

  /// Adds the counts of another map. Throws Error(invalid_argument) if its voxels are of another size or its world has
  /// another name, and leaves this map as it was.
  void merge(const EdgeMap& other);

  [[nodiscard]] const EdgeMapConfig& config() const { return config_; }
  [[nodiscard]] const std::string& world() const { return world_; }

  /// Voxels that were seen.
  [[nodiscard]] std::size_t size() const { return size_; }
  [[nodiscard]] bool empty() const { return size_ == 0; }
  /// Counts of a voxel; all 0 where it was not seen.
  [[nodiscard]] Voxel at(const VoxelKey& key) const;
  /// Calls `visit(const VoxelKey&, const Voxel&)` for every seen voxel, always in the same order for the same map.
  template <typename Visit>
  void for_each(Visit&& visit) const;
  /// Memory that the map holds.
  [[nodiscard]] std::size_t memory_bytes() const;

  /// Natural logarithm of the odds of an edge on `side`, clamped as E asks.
  [[nodiscard]] double log_odds(const Voxel& voxel, EdgeSide side) const;
  /// The same for an edge on either side.
  [[nodiscard]] double log_odds(const Voxel& voxel) const;
  [[nodiscard]] bool is_edge(const Voxel& voxel, EdgeSide side) const;

  /// The map as an OctoMap file (.ot) of a ColorOcTree: occupancy is the probability of an edge on either side, the
  /// colour holds the three counts: red left, green right, blue misses. OctoMap counts 32768 voxels from its origin in
  /// every direction; a map that does not lie within these has its origin at whole voxels near its middle, told in
  /// the comments of the file. Throws Error(invalid_argument) for a map that is wider than that. Same counts, same
  /// bytes.
  [[nodiscard]] std::string to_octomap() const;

  /// Reads what `to_octomap` wrote. Every count is checked against the bytes that are there before anything is
  /// allocated. The size of the voxels and the name of the world are the file's, all other settings `config`'s. Throws
  /// FileError naming `name` and the offset for anything else, an OctoMap of something else included; ConfigError as
  /// `EdgeMapConfig::check`.
  [[nodiscard]] static EdgeMap from_octomap(std::string_view bytes, const std::string& name,
                                            const EdgeMapConfig& config);

 private:
  /// Roads are flat: voxels are kept in slabs of 4 x 4 x 1, which a road fills, at a fifth of the memory of single
  /// ones.
  static constexpr int kSlabShift = 2;
  static constexpr std::int32_t kSlabSide = 1 << kSlabShift;
  using Slab = std::array<Voxel, std::size_t{kSlabSide} * kSlabSide>;

  static VoxelKey slab_of(const VoxelKey& key) { return {key.x >> kSlabShift, key.y >> kSlabShift, key.z}; }
  static std::size_t place_in_slab(const VoxelKey& key) {
    return static_cast<std::size_t>(((key.y & (kSlabSide - 1)) << kSlabShift) | (key.x & (kSlabSide - 1)));
  }
  /// Adds counts to a voxel.
  void add(const VoxelKey& key, const Voxel& counts);

  EdgeMapConfig config_;
  EdgeOdds odds_;
  std::string world_;
  VoxelHash<Slab> slabs_;
  std::size_t size_ = 0;
  // Scratch of add_scan.
  std::array<std::vector<VoxelKey>, 3> keys_;
};

template <typename Visit>
void EdgeMap::for_each(Visit&& visit) const {
  for (const VoxelKey& key : slabs_.sorted_keys()) {
    const Slab& slab = *slabs_.find(key);
    for (std::int32_t i = 0; i < kSlabSide * kSlabSide; ++i) {
      const Voxel& voxel = slab[static_cast<std::size_t>(i)];
      if (voxel.is_seen()) {
        visit(VoxelKey{(key.x << kSlabShift) + (i & (kSlabSide - 1)), (key.y << kSlabShift) + (i >> kSlabShift), key.z},
              voxel);
      }
    }
  }
}

}  // namespace berm
