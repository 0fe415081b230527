#pragma once

#include <optional>
#include <span>

#include <Eigen/Core>

#include "berm/render/draw_scan.hpp"
#include "berm/render/paint.hpp"

namespace berm {

/// A point on the plane of the picture: h to the right, v up, in the unit of the view (m; deg in the front view;
/// tangent of the angle off the line of sight in perspective). `depth` grows away from the eye: m for top and side,
/// the logarithm of the distance for the others.
struct FlatPoint {
  float h = 0.0F;
  float v = 0.0F;
  float depth = 0.0F;
};

/// Farther points, and such whose coordinates are no numbers, are not drawn: no LiDAR sees that far.
constexpr double kFarthest_m = 1e4;

/// How a view flattens space.
class Flattening {
 public:
  explicit Flattening(const DrawOptions& options);

  /// None where the view does not show the point: behind the eye, or at the sensor itself in the front view.
  [[nodiscard]] std::optional<FlatPoint> from_sensor(const Eigen::Vector3d& point_m) const;
  /// The same for a point in the frame of the base.
  [[nodiscard]] std::optional<FlatPoint> from_base(const Eigen::Vector3d& point_m) const;
  /// Height of a point of the sensor's frame, in the frame of the base.
  [[nodiscard]] double height_m(const Eigen::Vector3d& point_m) const;

 private:
  DrawView view_;
  Eigen::Matrix3d rotation_base_sensor_;
  Eigen::Vector3d sensor_m_;
  Eigen::Vector3d eye_m_;
  Eigen::Matrix3d rotation_eye_base_;  ///< rows: right, up, ahead
};

/// The part of the plane that is shown, and where in the picture.
struct Window {
  double h_min = -1.0;
  double h_max = 1.0;
  double v_min = -1.0;
  double v_max = 1.0;
  PixelBox box;

  [[nodiscard]] double h_scale_px() const { return box.width() / (h_max - h_min); }
  [[nodiscard]] double v_scale_px() const { return box.height() / (v_max - v_min); }
  [[nodiscard]] PixelPoint pixel(double h, double v) const {
    return {box.left + (h - h_min) * h_scale_px(), box.top + (v_max - v) * v_scale_px()};
  }
};

/// The window of `options`' view that shows `points` (finite) in `box`.
[[nodiscard]] Window choose_window(std::span<const FlatPoint> points, const DrawOptions& options, const PixelBox& box);

}  // namespace berm
