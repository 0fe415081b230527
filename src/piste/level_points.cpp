#include "level_points.hpp"

#include <Eigen/Geometry>

namespace berm {

void LevelPoints::fill(const PointsView& points, const Pose& T_level_sensor) {
  const std::size_t size = points.size();
  x.resize(size);
  y.resize(size);
  z.resize(size);
  const Eigen::Matrix3f r = T_level_sensor.rotation().toRotationMatrix().cast<float>();
  // The frame of the ground is below the sensor already: only the height is left of the translation.
  const Eigen::Vector3f t = T_level_sensor.translation_m().cast<float>();
  sensor_height_m = t.z();
  for (std::size_t i = 0; i < size; ++i) {
    const float px = points.x[i];
    const float py = points.y[i];
    const float pz = points.z[i];
    x[i] = r(0, 0) * px + r(0, 1) * py + r(0, 2) * pz + t.x();
    y[i] = r(1, 0) * px + r(1, 1) * py + r(1, 2) * pz + t.y();
    z[i] = r(2, 0) * px + r(2, 1) * py + r(2, 2) * pz + t.z();
  }
}

}  // namespace berm
