#include "voxel_means.hpp"

namespace berm {

void VoxelMeans::add(const Eigen::Vector3d& point_m, double time_s, std::size_t scan) {
  const auto key = index_.key_of(point_m);
  if (!key) {
    return;
  }
  std::uint32_t& place = index_.at_or_new(*key);
  if (place == 0) {
    keys_.push_back(*key);
    means_.push_back({.mean_m = Eigen::Vector3d::Zero()});
    place = static_cast<std::uint32_t>(means_.size());
  }
  VoxelMean& voxel = means_[place - 1];
  voxel.count += 1.0;
  voxel.mean_m += (point_m - voxel.mean_m) / voxel.count;
  voxel.time_s += (time_s - voxel.time_s) / voxel.count;
  voxel.seen = scan;
}

void VoxelMeans::clear() {
  index_.clear();
  keys_.clear();
  means_.clear();
}

void VoxelMeans::cut(const Eigen::Vector3d& center_m, double radius_m, std::size_t scan) {
  std::size_t kept = 0;
  for (std::size_t i = 0; i < means_.size(); ++i) {
    if (means_[i].seen < scan || (means_[i].mean_m - center_m).norm() > radius_m) {
      index_.erase(keys_[i]);
      continue;
    }
    keys_[kept] = keys_[i];
    means_[kept] = means_[i];
    ++kept;
    index_.at_or_new(keys_[i]) = static_cast<std::uint32_t>(kept);
  }
  keys_.resize(kept);
  means_.resize(kept, VoxelMean{.mean_m = Eigen::Vector3d::Zero()});
}

}  // namespace berm
