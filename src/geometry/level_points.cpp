#include "berm/geometry/level_points.hpp"

#include <array>
#include <cstddef>

#include <Eigen/Geometry>

#include "berm/core/multiversion.hpp"
#include "berm/geometry/bearing_grid.hpp"

namespace berm {
namespace {

/// Rows of the 3 x 4 matrix that takes a point to the level frame.
struct Row {
  float x, y, z, offset;
};

BERM_MULTIVERSION void turn_axis(const float* __restrict px, const float* __restrict py, const float* __restrict pz,
                                 std::size_t size, const Row& row, float* __restrict out) {
  const Row r = row;
  for (std::size_t i = 0; i < size; ++i) {
    out[i] = r.x * px[i] + r.y * py[i] + r.z * pz[i] + r.offset;
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
  const std::array<float*, 3> axes = {x.data(), y.data(), z.data()};
  for (Eigen::Index i = 0; i < 3; ++i) {
    turn_axis(points.x.data(), points.y.data(), points.z.data(), size, {r(i, 0), r(i, 1), r(i, 2), t[i]},
              axes[static_cast<std::size_t>(i)]);
  }
  find_places(x.data(), y.data(), size, range2.data(), turn.data());
}

}  // namespace berm
