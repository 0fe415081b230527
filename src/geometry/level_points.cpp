#include "berm/geometry/level_points.hpp"

#include <array>
#include <cstddef>

#include <Eigen/Geometry>

#include "berm/core/multiversion.hpp"
#include "berm/geometry/bearing_grid.hpp"

namespace berm {
namespace {

struct Matrix {
  std::array<std::array<float, 3>, 3> r;
  std::array<float, 3> t;
};

BERM_MULTIVERSION void turn_points(const float* __restrict px, const float* __restrict py, const float* __restrict pz,
                                   std::size_t size, const Matrix& matrix, float* __restrict x, float* __restrict y,
                                   float* __restrict z) {
  const Matrix m = matrix;
  for (std::size_t i = 0; i < size; ++i) {
    x[i] = m.r[0][0] * px[i] + m.r[0][1] * py[i] + m.r[0][2] * pz[i] + m.t[0];
    y[i] = m.r[1][0] * px[i] + m.r[1][1] * py[i] + m.r[1][2] * pz[i] + m.t[1];
    z[i] = m.r[2][0] * px[i] + m.r[2][1] * py[i] + m.r[2][2] * pz[i] + m.t[2];
  }
}

BERM_MULTIVERSION void find_places(const float* __restrict x, const float* __restrict y, std::size_t size,
                                   float* __restrict range2, std::uint16_t* __restrict turn) {
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
  const Eigen::Matrix3f r = T_level_sensor.rotation().toRotationMatrix().cast<float>();
  const Eigen::Vector3f t = T_level_sensor.translation_m().cast<float>();
  const Matrix matrix = {.r = {{{r(0, 0), r(0, 1), r(0, 2)}, {r(1, 0), r(1, 1), r(1, 2)}, {r(2, 0), r(2, 1), r(2, 2)}}},
                         .t = {t.x(), t.y(), t.z()}};
  turn_points(points.x.data(), points.y.data(), points.z.data(), size, matrix, x.data(), y.data(), z.data());
  find_places(x.data(), y.data(), size, range2.data(), turn.data());
}

}  // namespace berm
