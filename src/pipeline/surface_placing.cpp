#include "surface_placing.hpp"

#include <algorithm>
#include <cmath>

namespace berm {
namespace {

/// Beams that left places no farther apart than this are taken to come from one.
constexpr double kOneOrigin_m = 0.2;
constexpr double kMostOrigins = 8.0;

bool is_return(Label label) {
  return label != Label::unlabeled && label != Label::no_return;
}

bool is_surface(Label label) {
  return label == Label::drivable || label == Label::terrain || label == Label::obstacle;
}

/// Parts of the time of the scan within which the sensor hardly moved.
std::size_t count_origins(const ScanMotion& motion, double span_s) {
  const double way_m =
      (motion.to_world_m(Eigen::Vector3d::Zero(), span_s) - motion.to_world_m(Eigen::Vector3d::Zero(), 0.0)).norm();
  return static_cast<std::size_t>(std::clamp(std::ceil(way_m / kOneOrigin_m), 1.0, kMostOrigins));
}

double span_s(const PointsView& points, double first_s) {
  double last_s = first_s;
  for (const float time_s : points.time) {
    last_s = std::isfinite(time_s) ? std::max(last_s, double{time_s}) : last_s;
  }
  return last_s - first_s;
}

}  // namespace

void place_surface(const Scan& scan, std::span<const Label> labels, double first_s, double max_range_m,
                   PlacedSurface& placed) {
  const PointsView points = scan.cloud.view();
  const double whole_s = span_s(points, first_s);
  const std::size_t origins = count_origins(placed.motion, whole_s);
  SurfaceScan& result = placed.scan;
  result.sensor_m = placed.motion.to_world_m(Eigen::Vector3d::Zero(), 0.5 * whole_s);
  result.samples.clear();
  result.beams.resize(origins);
  placed.left_out = 0;
  for (std::size_t part = 0; part < origins; ++part) {
    placed.ends_m.clear();
    for (std::size_t i = 0; i < labels.size(); ++i) {
      const double since_s = points.time.empty() ? 0.0 : double{points.time[i]} - first_s;
      if (!is_return(labels[i])) {
        continue;
      }
      if (!std::isfinite(since_s)) {
        placed.left_out += part == 0 && is_surface(labels[i]) ? 1U : 0U;
        continue;
      }
      const double share = whole_s > 0.0 ? since_s / whole_s : 0.0;
      if (std::min(static_cast<std::size_t>(share * static_cast<double>(origins)), origins - 1) != part) {
        continue;
      }
      const Eigen::Vector3d in_sensor_m(points.x[i], points.y[i], points.z[i]);
      placed.ends_m.push_back(placed.motion.to_world_m(in_sensor_m, since_s));
      if (is_surface(labels[i]) && in_sensor_m.norm() <= max_range_m) {
        result.samples.push_back(
            {placed.ends_m.back(), points.intensity.empty() ? 0.0F : points.intensity[i], labels[i]});
      }
    }
    const double middle_s = whole_s * (static_cast<double>(part) + 0.5) / static_cast<double>(origins);
    result.beams[part].set(placed.motion.to_world_m(Eigen::Vector3d::Zero(), middle_s), placed.ends_m);
  }
}

}  // namespace berm
