#pragma once

#include <cstdint>
#include <vector>

#include <Eigen/Core>

#include "berm/geometry/voxel_hash.hpp"
#include "berm/odometry/odometry.hpp"
#include "berm/odometry/surface_odometry.hpp"

namespace berm {

/// A point of a scan, and when it was taken: 0 at the stamp of the scan, 1 at its last point, or at begin and end of
/// its part. Without times all are taken at the stamp.
struct ScanPoint {
  Eigen::Vector3d base_m;  ///< frame base, at its time
  double share = 0.0;
  bool is_ground = false;
  bool is_on_ring = false;                        ///< of a sensor that turns
  Eigen::Vector3f ray = Eigen::Vector3f::Zero();  ///< from the sensor to the point, length 1, frame base
};

/// A stretch of a scan's time, one of `count` equal ones.
struct ScanPart {
  std::size_t index = 0;
  std::size_t count = 1;
};

/// Into how many parts a scan is cut so that the motion within each is a screw: a groomer heaves and pitches at 1 Hz.
[[nodiscard]] std::size_t count_parts(const OdometryInput& input, const SurfaceOdometryConfig& config);

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

/// Thins a scan, or a part of it, evenly in space: what goes into the map, and what is matched.
class ScanThinner {
 public:
  void process(const OdometryInput& input, const SurfaceOdometryConfig& config, const ScanPart& part = {});

  [[nodiscard]] const std::vector<ScanPoint>& for_map() const { return for_map_; }
  [[nodiscard]] const std::vector<ScanPoint>& samples() const { return samples_; }
  /// Of the part; of a whole scan from its stamp to its last point. 0 where points have no times.
  [[nodiscard]] double duration_s() const { return duration_s_; }

 private:
  std::vector<ScanPoint> for_map_;
  std::vector<ScanPoint> samples_;
  MetVoxels met_;
  MetVoxels met_coarse_;
  double duration_s_ = 0.0;
};

}  // namespace berm
