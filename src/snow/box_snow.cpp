#include "berm/snow/box_snow.hpp"

#include <cstddef>

#include "berm/core/error.hpp"
#include "returns.hpp"

namespace berm {

void BoxSnowConfig::check() const {
  check_fields(*this, "snow_reference");
  if (!(min_x_m < max_x_m)) {
    throw ConfigError("snow_reference.min_x_m", "the box must begin before it ends at max_x_m");
  }
}

BoxSnow::BoxSnow(const BoxSnowConfig& config) : config_(config) {
  config_.check();
}

SnowResult BoxSnow::process(const PointsView& points, const Pose& T_base_sensor) {
  const Eigen::Vector3d forward = T_base_sensor.rotation().toRotationMatrix().row(0);
  const double mount_x_m = T_base_sensor.translation_m().x();
  falling_.assign(points.size(), 0);
  std::size_t count = 0;
  for (std::size_t i = 0; i < points.intensity.size(); ++i) {
    const Eigen::Vector3d p_sensor(points.x[i], points.y[i], points.z[i]);
    const double x_m = forward.dot(p_sensor) + mount_x_m;
    const double intensity = points.intensity[i];
    const bool dark = intensity >= 0.0 && intensity <= config_.max_intensity;
    if (dark && x_m > config_.min_x_m && x_m < config_.max_x_m && is_usable(points.x[i], points.y[i], points.z[i])) {
      falling_[i] = 1;
      ++count;
    }
  }
  return {.falling = falling_, .count = count, .limits = find_limits(points)};
}

}  // namespace berm
