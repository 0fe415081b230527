#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include <Eigen/Core>

#include "berm/geometry/voxel_hash.hpp"

namespace berm {

/// What the points of a voxel look like together.
enum class SurfaceShape : std::uint8_t {
  unknown,  ///< too few points
  plane,
  cloud,  ///< anything else: a trunk, a crown, a net, an edge
};

/// The points of a voxel: their number, mean and scatter, and what follows from them.
class SurfaceCell {
 public:
  /// `offset_m`: from the middle of the voxel.
  void add(const Eigen::Vector3f& offset_m);
  /// Whether something stands here.
  [[nodiscard]] bool stands() const { return stands_; }
  /// Remembers that something does; false if that was known.
  bool note_standing() { return !std::exchange(stands_, true); }
  /// Whether so many points came since the last `fit` that it is worth another.
  [[nodiscard]] bool wants_fit() const;
  void fit(float voxel_m);

  [[nodiscard]] SurfaceShape shape() const { return shape_; }
  [[nodiscard]] const Eigen::Vector3f& mean_m() const { return mean_m_; }  ///< from the middle of the voxel
  [[nodiscard]] const Eigen::Vector3f& normal() const { return normal_; }  ///< of a plane
  [[nodiscard]] float thickness_m2() const { return thickness_m2_; }       ///< variance along the normal
  [[nodiscard]] Eigen::Matrix3f information_per_m2() const;                ///< of a cloud

 private:
  /// A symmetric matrix: xx, xy, xz, yy, yz, zz.
  using Symmetric = Eigen::Matrix<float, 6, 1>;

  bool stands_ = false;
  SurfaceShape shape_ = SurfaceShape::unknown;
  float count_ = 0.0F;
  float fitted_ = 0.0F;  ///< `count_` at the last fit
  float thickness_m2_ = 0.0F;
  Eigen::Vector3f mean_m_ = Eigen::Vector3f::Zero();
  Eigen::Vector3f normal_ = Eigen::Vector3f::Zero();
  Symmetric scatter_m2_ = Symmetric::Zero();
  Symmetric information_per_m2_ = Symmetric::Zero();
};

/// A cell, and where its points lie on average in the world.
struct SurfaceHit {
  const SurfaceCell* cell = nullptr;
  Eigen::Vector3d mean_m;
  double say = 1.0;  ///< of a point on it, as a share of a point on a fine one
};

/// Cells of one size. They lie one behind the other: a hash of cells would move them whenever it grows.
class SurfaceVoxels {
 public:
  explicit SurfaceVoxels(double voxel_m) : index_(voxel_m) {}

  /// The cell that got the point, null for a place that has none. Valid until the next `add` or `cut`.
  SurfaceCell* add(const Eigen::Vector3d& world_m);
  /// The cell of a place if its shape is known. Valid as above.
  [[nodiscard]] SurfaceHit find(const Eigen::Vector3d& world_m) const;
  /// Takes away what is farther from `center_m`; returns in how many of those voxels something stands.
  std::size_t cut(const Eigen::Vector3d& center_m, double radius_m);
  void clear();

  [[nodiscard]] std::size_t size() const { return cells_.size(); }

 private:
  VoxelHash<std::uint32_t> index_;  ///< of a voxel's cell
  std::vector<SurfaceCell> cells_;
  std::vector<VoxelKey> keys_;  ///< of the cells
};

}  // namespace berm
