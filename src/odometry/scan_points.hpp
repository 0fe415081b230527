#pragma once

#include <cstdint>
#include <vector>

#include <Eigen/Core>

#include "berm/geometry/voxel_hash.hpp"
#include "berm/odometry/odometry.hpp"
#include "berm/odometry/surface_odometry.hpp"

namespace berm {

/// A point of a scan, and when it was taken: 0 at the stamp of the scan, 1 at its last point. Without times all are
/// taken at the stamp.
struct ScanPoint {
  Eigen::Vector3d base_m;  ///< frame base, at its time
  double share = 0.0;
  bool is_ground = false;
};

/// Which voxels of a scan were met already. Keeps its memory.
class MetVoxels {
 public:
  void clear();
  /// Whether the voxel is met for the first time.
  bool insert(const VoxelKey& key);

 private:
  struct Slot {
    VoxelKey key;
    std::uint32_t round = 0;  ///< in which it was filled; others are empty
  };
  void grow();

  std::vector<Slot> slots_;
  std::size_t filled_ = 0;
  std::uint32_t round_ = 0;
};

/// Keeps `count` of the points at most, leaving out evenly: points are in firing order, so that every part of the view
/// keeps its share.
void limit_points(std::vector<ScanPoint>& points, std::size_t count);

/// Thins a scan evenly in space: what goes into the map, and what is matched.
class ScanThinner {
 public:
  void process(const OdometryInput& input, const SurfaceOdometryConfig& config);

  [[nodiscard]] const std::vector<ScanPoint>& for_map() const { return for_map_; }
  [[nodiscard]] const std::vector<ScanPoint>& samples() const { return samples_; }
  /// From the stamp of the scan to its last point; 0 where points have no times.
  [[nodiscard]] double duration_s() const { return duration_s_; }

 private:
  std::vector<ScanPoint> for_map_;
  std::vector<ScanPoint> samples_;
  MetVoxels met_;
  MetVoxels met_coarse_;
  double duration_s_ = 0.0;
};

}  // namespace berm
