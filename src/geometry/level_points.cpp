#include "berm/geometry/level_points.hpp"

#include <cstddef>

#include <Eigen/Geometry>

#include "berm/core/multiversion.hpp"
#include "berm/geometry/bearing_grid.hpp"

namespace berm {
namespace {

BERM_MULTIVERSION void turn_points(const PointsView& points, const Eigen::Matrix3f& r, const Eigen::Vector3f& t,
                                   LevelPoints& out) {
  const std::size_t size = points.size();
  const float* px = points.x.data();
  const float* py = points.y.data();
  const float* pz = points.z.data();
  float* x = out.x.data();
  float* y = out.y.data();
  float* z = out.z.data();
  float* range2 = out.range2.data();
  std::uint16_t* turn = out.turn.data();
  const float r00 = r(0, 0), r01 = r(0, 1), r02 = r(0, 2), t0 = t.x();
  const float r10 = r(1, 0), r11 = r(1, 1), r12 = r(1, 2), t1 = t.y();
  const float r20 = r(2, 0), r21 = r(2, 1), r22 = r(2, 2), t2 = t.z();
  for (std::size_t i = 0; i < size; ++i) {
    x[i] = r00 * px[i] + r01 * py[i] + r02 * pz[i] + t0;
    y[i] = r10 * px[i] + r11 * py[i] + r12 * pz[i] + t1;
    z[i] = r20 * px[i] + r21 * py[i] + r22 * pz[i] + t2;
  }
  for (std::size_t i = 0; i < size; ++i) {
    range2[i] = x[i] * x[i] + y[i] * y[i];
    turn[i] = bearing_grid::turn_of(x[i], y[i]);
  }
}

}  // namespace

void LevelPoints::fill(const PointsView& points, const Pose& T_level_sensor) {
  const std::size_t size = points.size();
  for (auto* channel : {&x, &y, &z, &range2}) {
    channel->resize(size);
  }
  turn.resize(size);
  sensor_height_m = static_cast<float>(T_level_sensor.translation_m().z());
  turn_points(points, T_level_sensor.rotation().toRotationMatrix().cast<float>(),
              T_level_sensor.translation_m().cast<float>(), *this);
}

}  // namespace berm
