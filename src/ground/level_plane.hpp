#pragma once

#include <vector>

#include <Eigen/Core>

#include "berm/core/point_cloud.hpp"
#include "berm/core/pose.hpp"
#include "berm/ground/terrain_ground.hpp"

namespace berm {

/// The plane of the ground around the sensor.
struct LevelPlane {
  Pose T_level_sensor;     ///< origin below the sensor on the plane, z along its normal, x towards the sensor's x
  double rms_m = 0.0;      ///< of the low points that belong to it
  double nearest_m = 0.0;  ///< range of the nearest of them: the ground nearer than that is in the blind spot
  bool found = false;      ///< else the plane is what the mount says
};

/// Finds the plane; keeps scratch memory between calls.
class LevelPlaneFinder {
 public:
  [[nodiscard]] LevelPlane find(const PointsView& points, const Pose& T_base_sensor, const TerrainGroundConfig& config);

 private:
  struct Plane {
    Eigen::Vector3f normal;  ///< in the base frame, unit length, upward
    float height_m;          ///< of the sensor above it
  };

  struct LowPoints {
    Eigen::Vector3f first;   ///< the lowest
    Eigen::Vector3f second;  ///< the next
  };

  void collect_low_points(const PointsView& points, const Eigen::Matrix3f& R_base_sensor, float min_range_m);
  [[nodiscard]] Plane best_plane(float mount_height_m, float min_up) const;
  [[nodiscard]] float score(const Plane& plane) const;
  void refine(Plane& plane, float min_up) const;
  [[nodiscard]] LevelPlane judge(const Plane& plane, const Eigen::Matrix3d& R_base_sensor) const;

  std::vector<LowPoints> lowest_;  ///< per cell of a square grid
  // The low points, base axes, origin in the sensor.
  std::vector<float> x_;
  std::vector<float> y_;
  std::vector<float> z_;
  std::vector<float> tolerance_m_;  ///< how far off the plane a low point may lie
  std::vector<float> weight_;       ///< near ones count more
  float weight_sum_ = 0.0F;
};

}  // namespace berm
