#include "surface_voxels.hpp"

#include <algorithm>

#include <Eigen/Eigenvalues>

namespace berm {
namespace {

/// Old points fade once a voxel holds so many: a map must be able to follow what it was told first.
constexpr float kMemory = 400.0F;
constexpr float kFewestPoints = 8.0F;
constexpr float kRefit = 1.2F;

/// A plane is at least so wide along its shorter side, in shares of the voxel, one sigma; an even cover has 0.29.
constexpr float kPlaneWidth = 0.12F;
/// and at most so thick, in shares of the variance along that side.
constexpr float kPlaneThickness = 0.08F;

/// A cloud is known no better than this, one sigma.
constexpr float kCloudNoise_m = 0.05F;

Eigen::Matrix3f matrix_of(const Eigen::Matrix<float, 6, 1>& symmetric) {
  Eigen::Matrix3f matrix;
  matrix << symmetric[0], symmetric[1], symmetric[2],  //
      symmetric[1], symmetric[3], symmetric[4],        //
      symmetric[2], symmetric[4], symmetric[5];
  return matrix;
}

}  // namespace

void SurfaceCell::add(const Eigen::Vector3f& offset_m) {
  if (count_ >= kMemory) {
    constexpr float kKept = (kMemory - 1.0F) / kMemory;
    scatter_m2_ *= kKept;
    count_ *= kKept;
    fitted_ *= kKept;  // so that the next fit comes once a sixth is new
  }
  const float share = count_ / (count_ + 1.0F);
  count_ += 1.0F;
  const Eigen::Vector3f off_m = offset_m - mean_m_;
  mean_m_ += off_m / count_;
  const float x_m = share * off_m.x();
  const float y_m = share * off_m.y();
  const float z_m = share * off_m.z();
  Symmetric scatter_m2;
  scatter_m2 << x_m * off_m.x(), x_m * off_m.y(), x_m * off_m.z(), y_m * off_m.y(), y_m * off_m.z(), z_m * off_m.z();
  scatter_m2_ += scatter_m2;
}

bool SurfaceCell::wants_fit() const {
  return count_ >= kFewestPoints && count_ > kRefit * fitted_;
}

void SurfaceCell::fit(float voxel_m) {
  fitted_ = count_;
  const Eigen::Matrix3f covariance_m2 = matrix_of(scatter_m2_) / count_;
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix3f> axes;
  axes.computeDirect(covariance_m2);
  thickness_m2_ = std::max(axes.eigenvalues()[0], 0.0F);
  const float width_m2 = axes.eigenvalues()[1];
  const float least_width_m = kPlaneWidth * voxel_m;
  if (width_m2 > least_width_m * least_width_m && thickness_m2_ < kPlaneThickness * width_m2) {
    shape_ = SurfaceShape::plane;
    normal_ = axes.eigenvectors().col(0);
  } else {
    shape_ = SurfaceShape::cloud;
    const Eigen::Matrix3f information =
        (covariance_m2 + kCloudNoise_m * kCloudNoise_m * Eigen::Matrix3f::Identity()).inverse();
    information_per_m2_ << information(0, 0), information(0, 1), information(0, 2), information(1, 1),
        information(1, 2), information(2, 2);
  }
}

Eigen::Matrix3f SurfaceCell::information_per_m2() const {
  return matrix_of(information_per_m2_);
}

SurfaceCell* SurfaceVoxels::add(const Eigen::Vector3d& world_m) {
  const auto key = index_.key_of(world_m);
  if (!key) {
    return nullptr;
  }
  // Cells are counted from 1: a voxel that is new to the index has 0.
  std::uint32_t& number = index_.at_or_new(*key);
  if (number == 0) {
    cells_.emplace_back();
    keys_.push_back(*key);
    number = static_cast<std::uint32_t>(cells_.size());
  }
  SurfaceCell& cell = cells_[number - 1];
  cell.add((world_m - voxel_center_m(*key, index_.voxel_m())).cast<float>());
  if (cell.wants_fit()) {
    cell.fit(static_cast<float>(index_.voxel_m()));
  }
  return &cell;
}

SurfaceHit SurfaceVoxels::find(const Eigen::Vector3d& world_m) const {
  const auto key = index_.key_of(world_m);
  const std::uint32_t* number = key ? index_.find(*key) : nullptr;
  if (number == nullptr) {
    return {};
  }
  const SurfaceCell& cell = cells_[*number - 1];
  if (cell.shape() == SurfaceShape::unknown) {
    return {};
  }
  return {&cell, voxel_center_m(*key, index_.voxel_m()) + cell.mean_m().cast<double>()};
}

std::size_t SurfaceVoxels::cut(const Eigen::Vector3d& center_m, double radius_m) {
  std::size_t standing = 0;
  for (std::size_t i = 0; i < cells_.size();) {
    if ((voxel_center_m(keys_[i], index_.voxel_m()) - center_m).norm() <= radius_m) {
      ++i;
      continue;
    }
    standing += cells_[i].stands() ? 1U : 0U;
    // The last one fills the gap.
    index_.erase(keys_[i]);
    if (i + 1 < cells_.size()) {
      cells_[i] = cells_.back();
      keys_[i] = keys_.back();
      index_.at_or_new(keys_[i]) = static_cast<std::uint32_t>(i + 1);
    }
    cells_.pop_back();
    keys_.pop_back();
  }
  return standing;
}

void SurfaceVoxels::clear() {
  index_.clear();
  cells_.clear();
  keys_.clear();
}

}  // namespace berm
