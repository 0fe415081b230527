#pragma once

#include <cstddef>

#include <Eigen/Core>

#include "berm/odometry/surface_odometry.hpp"
#include "surface_voxels.hpp"

namespace berm {

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
  /// Those into which anything but ground was put: the fewer the same points fill, the sharper the map. Ground says
  /// nothing: rings fill the fewest voxels of it if they are taken not to move.
  [[nodiscard]] std::size_t standing() const { return standing_; }

 private:
  bool use_shapes_;
  SurfaceVoxels fine_;
  SurfaceVoxels coarse_;
  SurfaceVoxels wide_;  ///< of ground alone
  std::size_t standing_ = 0;
};

}  // namespace berm
