#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <Eigen/Core>

#include "berm/geometry/voxel_hash.hpp"

namespace berm {

/// The points of a voxel as one.
struct VoxelMean {
  Eigen::Vector3d mean_m;
  double time_s = 0.0;  ///< mean of their times
  double count = 0.0;
  std::size_t seen = 0;  ///< last scan that put a point here
};

/// Points thinned to the means of the voxels of a lattice, in the order in which the voxels were met.
class VoxelMeans {
 public:
  explicit VoxelMeans(double voxel_m) : index_(voxel_m) {}

  void add(const Eigen::Vector3d& point_m, double time_s, std::size_t scan);
  void clear();
  /// Takes away what is farther from `center_m`, and what was last seen before `scan`.
  void cut(const Eigen::Vector3d& center_m, double radius_m, std::size_t scan);

  [[nodiscard]] const std::vector<VoxelMean>& means() const { return means_; }
  [[nodiscard]] std::size_t size() const { return means_.size(); }

 private:
  VoxelHash<std::uint32_t> index_;  ///< place in `keys_` and `means_`, plus 1
  std::vector<VoxelKey> keys_;
  std::vector<VoxelMean> means_;
};

}  // namespace berm
