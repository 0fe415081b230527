#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>

#include <Eigen/Core>

#include "berm/geometry/voxel_hash.hpp"
#include "berm/odometry/surface_odometry.hpp"

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
  /// Remembers that something stands here; false if that was known.
  bool note_standing() { return !std::exchange(stands_, true); }
  /// Whether so many points came since the last `fit` that it is worth another.
  [[nodiscard]] bool wants_fit() const;
  void fit(float voxel_m);

  [[nodiscard]] SurfaceShape shape() const { return shape_; }
  [[nodiscard]] const Eigen::Vector3f& mean_m() const { return mean_m_; }  ///< from the middle of the voxel
  [[nodiscard]] const Eigen::Vector3f& normal() const { return normal_; }  ///< of a plane
  [[nodiscard]] float thickness_m2() const { return thickness_m2_; }       ///< variance along the normal
  [[nodiscard]] const Eigen::Matrix3f& information_per_m2() const { return information_per_m2_; }  ///< of a cloud

 private:
  bool stands_ = false;
  float count_ = 0.0F;
  float fitted_ = 0.0F;  ///< `count_` at the last fit
  Eigen::Vector3f mean_m_ = Eigen::Vector3f::Zero();
  Eigen::Matrix3f scatter_m2_ = Eigen::Matrix3f::Zero();
  SurfaceShape shape_ = SurfaceShape::unknown;
  float thickness_m2_ = 0.0F;
  Eigen::Vector3f normal_ = Eigen::Vector3f::Zero();
  Eigen::Matrix3f information_per_m2_ = Eigen::Matrix3f::Zero();
};

/// A cell, and where its points lie on average in the world.
struct SurfaceHit {
  const SurfaceCell* cell = nullptr;
  Eigen::Vector3d mean_m;
};

/// What a scan is matched with.
class Surfaces {
 public:
  virtual ~Surfaces() = default;
  /// The surface at a place, for a point of the ground or for what stands on it. Valid until the map changes.
  [[nodiscard]] virtual SurfaceHit find(const Eigen::Vector3d& world_m, bool is_ground) const = 0;
};

/// The surfaces around the machine, in voxels of three sizes: fine ones for what has shape, coarse ones for planes
/// that are seen thinly, wide ones for ground between distant rings.
class SurfaceMap final : public Surfaces {
 public:
  explicit SurfaceMap(const SurfaceOdometryConfig& config);

  void add(const Eigen::Vector3d& world_m, bool is_ground);
  /// The surface at a place: the fine plane; else the fine cloud, but not for ground, of which rings draw clouds that
  /// come along with the machine; else the coarse plane; else, for ground, the wide one. Valid until the next `add` or
  /// `cut`.
  [[nodiscard]] SurfaceHit find(const Eigen::Vector3d& world_m, bool is_ground) const override;
  void clear();
  /// Takes away what is farther from `center_m`.
  void cut(const Eigen::Vector3d& center_m, double radius_m);

  /// Fine voxels.
  [[nodiscard]] std::size_t size() const { return fine_.size(); }
  /// Those into which anything but ground was put since the map is there: the fewer the same points fill, the sharper
  /// the map. Ground says nothing: rings fill the fewest voxels of it if they are taken not to move.
  [[nodiscard]] std::size_t standing() const { return standing_; }

 private:
  bool use_shapes_;
  VoxelHash<SurfaceCell> fine_;
  VoxelHash<SurfaceCell> coarse_;
  VoxelHash<SurfaceCell> wide_;  ///< of ground alone
  std::size_t standing_ = 0;
};

}  // namespace berm
