#include "place_surfaces.hpp"

#include <algorithm>

#include <Eigen/Eigenvalues>
#include <Eigen/LU>

namespace berm {
namespace {

constexpr double kFine_m = 0.6;
constexpr double kCoarse_m = 1.8;
constexpr double kGround_m = 1.5;
constexpr double kFewestOfVoxel = 6.0;
/// Noise of a point across its surface, and of one in a crown or a net.
constexpr double kPlaneNoise_m = 0.03;
constexpr double kCloudSigma_m = 0.1;
/// A plane is so wide, in shares of the voxel, and so thin, in shares of its width; one sigma each.
constexpr double kLeastPlaneWidth = 0.12;
constexpr double kMostPlaneThickness = 0.25;

PlaceSurface surface_of(const Eigen::Vector3d& mean_m, const Eigen::Matrix3d& covariance_m2, double voxel_m) {
  PlaceSurface surface;
  surface.mean_m = mean_m;
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes;
  axes.computeDirect(covariance_m2);
  const double thin_m2 = std::max(axes.eigenvalues()[0], 0.0);
  const double wide_m2 = axes.eigenvalues()[1];
  const bool is_plane = wide_m2 > kLeastPlaneWidth * kLeastPlaneWidth * voxel_m * voxel_m &&
                        thin_m2 < kMostPlaneThickness * kMostPlaneThickness * wide_m2;
  if (is_plane) {
    surface.normal = axes.eigenvectors().col(0);
    surface.information = surface.normal * surface.normal.transpose() / (thin_m2 + kPlaneNoise_m * kPlaneNoise_m);
  } else {
    surface.information = (covariance_m2 + kCloudSigma_m * kCloudSigma_m * Eigen::Matrix3d::Identity()).inverse();
  }
  return surface;
}

}  // namespace

PlaceSurfaces::PlaceSurfaces() : fine_(kFine_m), coarse_(kCoarse_m), ground_(kGround_m) {}

void PlaceSurfaces::add_to(VoxelHash<Cell>& voxels, const Eigen::Vector3d& point_m) {
  const auto key = voxels.key_of(point_m);
  if (!key) {
    return;
  }
  Cell& cell = voxels.at_or_new(*key);
  const Eigen::Vector3d from_middle_m = point_m - voxel_center_m(*key, voxels.voxel_m());
  cell.count += 1.0;
  cell.sum_m += from_middle_m;
  cell.squares_m2 += from_middle_m * from_middle_m.transpose();
}

void PlaceSurfaces::add(const Eigen::Vector3d& point_m) {
  add_to(fine_, point_m);
  add_to(coarse_, point_m);
  const auto key = ground_.key_of({point_m.x(), point_m.y(), 0.0});
  if (key) {
    Lowest& lowest = ground_.at_or_new(*key);
    lowest.height_m = lowest.is_seen ? std::min(lowest.height_m, point_m.z()) : point_m.z();
    lowest.is_seen = true;
  }
}

void PlaceSurfaces::fit_all(VoxelHash<Cell>& voxels) {
  for (const VoxelKey& key : voxels.sorted_keys()) {
    Cell& cell = *voxels.find(key);
    if (cell.count < kFewestOfVoxel) {
      continue;
    }
    const Eigen::Vector3d mean_m = cell.sum_m / cell.count;
    const Eigen::Matrix3d covariance_m2 = cell.squares_m2 / cell.count - mean_m * mean_m.transpose();
    cell.surface = surface_of(voxel_center_m(key, voxels.voxel_m()) + mean_m, covariance_m2, voxels.voxel_m());
    cell.is_known = true;
  }
}

void PlaceSurfaces::fit() {
  fit_all(fine_);
  fit_all(coarse_);
}

const PlaceSurface* PlaceSurfaces::find(const Eigen::Vector3d& point_m) const {
  for (const auto* voxels : {&fine_, &coarse_}) {
    const auto key = voxels->key_of(point_m);
    const Cell* cell = key ? voxels->find(*key) : nullptr;
    if (cell != nullptr && cell->is_known) {
      return &cell->surface;
    }
  }
  return nullptr;
}

std::optional<double> PlaceSurfaces::ground_m(double x_m, double y_m) const {
  const auto key = ground_.key_of({x_m, y_m, 0.0});
  const Lowest* lowest = key ? ground_.find(*key) : nullptr;
  return lowest != nullptr ? std::optional(lowest->height_m) : std::nullopt;
}

}  // namespace berm
