#include "surface_map.hpp"

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

/// The cell that got the point; null for a place that has none.
SurfaceCell* add_to(VoxelHash<SurfaceCell>& voxels, const Eigen::Vector3d& world_m) {
  const auto key = voxels.key_of(world_m);
  if (!key) {
    return nullptr;
  }
  SurfaceCell& cell = voxels.at_or_new(*key);
  cell.add((world_m - voxel_center_m(*key, voxels.voxel_m())).cast<float>());
  if (cell.wants_fit()) {
    cell.fit(static_cast<float>(voxels.voxel_m()));
  }
  return &cell;
}

SurfaceHit find_in(const VoxelHash<SurfaceCell>& voxels, const Eigen::Vector3d& world_m) {
  const auto key = voxels.key_of(world_m);
  const SurfaceCell* cell = key ? voxels.find(*key) : nullptr;
  if (cell == nullptr || cell->shape() == SurfaceShape::unknown) {
    return {};
  }
  return {cell, voxel_center_m(*key, voxels.voxel_m()) + cell->mean_m().cast<double>()};
}

}  // namespace

void SurfaceCell::add(const Eigen::Vector3f& offset_m) {
  if (count_ >= kMemory) {
    constexpr float kKept = (kMemory - 1.0F) / kMemory;
    scatter_m2_ *= kKept;
    count_ *= kKept;
    fitted_ *= kKept;  // so that the next fit comes once a sixth is new
  }
  count_ += 1.0F;
  const Eigen::Vector3f before_m = offset_m - mean_m_;
  mean_m_ += before_m / count_;
  scatter_m2_ += before_m * (offset_m - mean_m_).transpose();
}

bool SurfaceCell::wants_fit() const {
  return count_ >= kFewestPoints && count_ > kRefit * fitted_;
}

void SurfaceCell::fit(float voxel_m) {
  fitted_ = count_;
  const Eigen::Matrix3f covariance_m2 = 0.5F * (scatter_m2_ + scatter_m2_.transpose()) / count_;
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
    information_per_m2_ = (covariance_m2 + kCloudNoise_m * kCloudNoise_m * Eigen::Matrix3f::Identity()).inverse();
  }
}

SurfaceMap::SurfaceMap(const SurfaceOdometryConfig& config)
    : use_shapes_(config.use_shapes),
      fine_(config.fine_voxel_m),
      coarse_(config.coarse_voxel_m),
      wide_(config.wide_voxel_m) {}

void SurfaceMap::add(const Eigen::Vector3d& world_m, bool is_ground) {
  SurfaceCell* fine = add_to(fine_, world_m);
  standing_ += fine != nullptr && !is_ground && fine->note_standing() ? 1U : 0U;
  add_to(coarse_, world_m);
  if (is_ground) {
    add_to(wide_, world_m);
  }
}

SurfaceHit SurfaceMap::find(const Eigen::Vector3d& world_m, bool is_ground) const {
  const SurfaceHit fine = find_in(fine_, world_m);
  if (fine.cell != nullptr && ((use_shapes_ && !is_ground) || fine.cell->shape() == SurfaceShape::plane)) {
    return fine;
  }
  const SurfaceHit coarse = find_in(coarse_, world_m);
  if (coarse.cell != nullptr && coarse.cell->shape() == SurfaceShape::plane) {
    return coarse;
  }
  const SurfaceHit wide = is_ground ? find_in(wide_, world_m) : SurfaceHit{};
  return wide.cell != nullptr && wide.cell->shape() == SurfaceShape::plane ? wide : SurfaceHit{};
}

void SurfaceMap::clear() {
  fine_.clear();
  coarse_.clear();
  wide_.clear();
  standing_ = 0;
}

void SurfaceMap::cut(const Eigen::Vector3d& center_m, double radius_m) {
  fine_.erase_beyond(center_m, radius_m);
  coarse_.erase_beyond(center_m, radius_m);
  wide_.erase_beyond(center_m, radius_m);
}

}  // namespace berm
