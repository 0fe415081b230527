#include "projection.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <vector>

#include <Eigen/Geometry>

#include "berm/core/angle.hpp"

namespace berm {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

/// Nearer to the eye nothing is drawn in perspective: a single point would hide the picture.
constexpr double kNearest_m = 0.3;
/// Without a range the picture leaves out this share of the points at each end: stray ones would make all else small.
constexpr double kStrayShare = 0.015;
/// How much larger than lengths the heights may be drawn. LiDAR scans are flat.
constexpr double kMostExaggeration = 5.0;
/// Looking ahead, this much of what is shown lies behind the origin, so that the sensor is seen.
constexpr double kBehindShare = 0.05;

Matrix3d look_at(const Vector3d& eye_m, const Vector3d& target_m) {
  const Vector3d ahead = (target_m - eye_m).normalized();
  Vector3d right = ahead.cross(Vector3d::UnitZ());
  if (right.norm() < 1e-6) {
    // Straight down or up: then x is up in the picture, as in the view from above.
    right = -Vector3d::UnitY();
  }
  right.normalize();
  Matrix3d rotation;
  rotation << right.transpose(), right.cross(ahead).transpose(), ahead.transpose();
  return rotation;
}

struct Interval {
  double low = 0.0;
  double high = 0.0;

  [[nodiscard]] double length() const { return high - low; }
  [[nodiscard]] double middle() const { return 0.5 * (low + high); }
  void set_length(double length) { *this = {middle() - 0.5 * length, middle() + 0.5 * length}; }
  void include(double value) { *this = {std::min(low, value), std::max(high, value)}; }
};

Interval spread(std::span<const FlatPoint> points, float FlatPoint::*member) {
  std::vector<float> values(points.size());
  std::transform(points.begin(), points.end(), values.begin(), [member](const FlatPoint& p) { return p.*member; });
  if (values.empty()) {
    return {};
  }
  const auto rank = static_cast<std::ptrdiff_t>(kStrayShare * static_cast<double>(values.size() - 1));
  const auto low = values.begin() + rank;
  const auto high = values.end() - 1 - rank;
  std::nth_element(values.begin(), low, values.end());
  const double low_value = *low;
  std::nth_element(low, high, values.end());
  return {low_value, *high};
}

/// Spread of the heights of what the window shows.
Interval heights_within(std::span<const FlatPoint> points, const Interval& h) {
  std::vector<FlatPoint> shown;
  std::copy_if(points.begin(), points.end(), std::back_inserter(shown), [&h](const FlatPoint& point) {
    return static_cast<double>(point.h) >= h.low && static_cast<double>(point.h) <= h.high;
  });
  return spread(shown, &FlatPoint::v);
}

/// Widens the shorter of the two until a unit of v is as long as one of h, or up to `most` times longer.
void match_scales(Interval& h, Interval& v, const PixelBox& box, double most) {
  const double aspect = static_cast<double>(box.width()) / box.height();
  const double v_length = std::clamp(v.length(), h.length() / (aspect * most), std::max(h.length() / aspect, 0.0));
  if (v.length() <= v_length) {
    v.set_length(v_length);
    return;
  }
  h.set_length(v.length() * aspect);
}

}  // namespace

Flattening::Flattening(const DrawOptions& options)
    : view_(options.view),
      rotation_base_sensor_(options.T_base_sensor.rotation().toRotationMatrix()),
      sensor_m_(options.T_base_sensor.translation_m()),
      eye_m_(options.eye_m),
      rotation_eye_base_(look_at(options.eye_m, options.target_m)) {}

std::optional<FlatPoint> Flattening::from_sensor(const Vector3d& point_m) const {
  if (view_ != DrawView::front) {
    return from_base(rotation_base_sensor_ * point_m + sensor_m_);
  }
  const double across_m = std::hypot(point_m.x(), point_m.y());
  const double range_m = std::hypot(across_m, point_m.z());
  if (range_m <= 0.0) {
    return std::nullopt;
  }
  return FlatPoint{static_cast<float>(-kDegPerRad * std::atan2(point_m.y(), point_m.x())),
                   static_cast<float>(kDegPerRad * std::atan2(point_m.z(), across_m)),
                   static_cast<float>(std::log(range_m))};
}

std::optional<FlatPoint> Flattening::from_base(const Vector3d& point_m) const {
  const Eigen::Vector3f p = point_m.cast<float>();
  switch (view_) {
    case DrawView::top:
      return FlatPoint{-p.y(), p.x(), -p.z()};
    case DrawView::side:
      return FlatPoint{p.x(), p.z(), p.y()};
    case DrawView::front:
      return std::nullopt;
    case DrawView::perspective:
      break;
  }
  const Vector3d seen = rotation_eye_base_ * (point_m - eye_m_);
  if (!(seen.z() > kNearest_m)) {
    return std::nullopt;
  }
  return FlatPoint{static_cast<float>(seen.x() / seen.z()), static_cast<float>(seen.y() / seen.z()),
                   static_cast<float>(std::log(seen.z()))};
}

double Flattening::height_m(const Vector3d& point_m) const {
  return rotation_base_sensor_.row(2).dot(point_m) + sensor_m_.z();
}

Window choose_window(std::span<const FlatPoint> points, const DrawOptions& options, const PixelBox& box) {
  const double aspect = static_cast<double>(box.width()) / box.height();
  Interval h;
  Interval v;
  if (options.view == DrawView::perspective) {
    const double half = std::tan(0.5 * options.field_of_view_rad);
    h = {-half, half};
    v = {-half / aspect, half / aspect};
    return {h.low, h.high, v.low, v.high, box};
  }
  h = spread(points, &FlatPoint::h);
  v = spread(points, &FlatPoint::v);
  const bool metric = options.view != DrawView::front;
  if (metric) {
    // The sensor belongs into the picture.
    h.include(options.view == DrawView::top ? -options.T_base_sensor.translation_m().y()
                                            : options.T_base_sensor.translation_m().x());
    v.include(options.view == DrawView::top ? options.T_base_sensor.translation_m().x()
                                            : options.T_base_sensor.translation_m().z());
    if (options.range_m > 0.0) {
      h = {-options.range_m, options.range_m};
      if (options.view == DrawView::top) {
        v = h;
      }
    }
    Interval& along = options.view == DrawView::top ? v : h;
    if (options.ahead && along.high > 0.0) {
      along.low = -kBehindShare * along.high;
    }
    if (options.view == DrawView::side) {
      v = heights_within(points, h);
      v.include(options.T_base_sensor.translation_m().z());
    }
  }
  constexpr double kMargin = 1.06;
  const double shortest = metric ? 2.0 : 1.0;
  const double margin = options.range_m > 0.0 && metric ? 1.0 : kMargin;
  h.set_length(std::max(h.length() * margin, shortest));
  v.set_length(std::max(v.length() * (options.view == DrawView::top ? margin : kMargin), shortest));
  match_scales(h, v, box, options.view == DrawView::top ? 1.0 : kMostExaggeration);
  return {h.low, h.high, v.low, v.high, box};
}

}  // namespace berm
