#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "berm/core/label.hpp"
#include "berm/core/point_cloud.hpp"
#include "berm/core/pose.hpp"
#include "berm/render/color.hpp"
#include "berm/render/image.hpp"

namespace berm {

/// From where a scan is looked at.
enum class DrawView : std::uint8_t {
  top,          ///< from above: x up, y to the left, the highest point on top
  side,         ///< from the right of the machine: x to the right, z up, heights exaggerated where that helps
  front,        ///< from the sensor, as a range image: azimuth across (left is left), elevation up, the nearest on top
  perspective,  ///< from `DrawOptions::eye_m`
};

/// What the colour of a point says.
enum class DrawColor : std::uint8_t {
  label,      ///< its label; what has none is drawn as unlabeled
  intensity,  ///< its intensity; without that channel as `height`
  height,     ///< its z after `T_base_sensor`
};

/// A line over the points, in the frame of the base; not in the front view.
struct DrawnLine {
  std::string name;  ///< for the legend; lines of one name stand there once
  Rgb color;
  std::vector<Eigen::Vector3d> vertices_m;
};

struct DrawOptions {
  DrawView view = DrawView::top;
  DrawColor color = DrawColor::label;
  Background background = Background::dark;
  int width_px = 1600;
  int height_px = 1000;
  std::string title;           ///< ASCII; anything else is drawn as '?'
  Pose T_base_sensor;          ///< levels the picture; the mount of the sensor. The front view does without.
  double range_m = 0.0;        ///< top, side: how far from the sensor is shown; 0: as far as most points are
  bool ahead = false;          ///< top, side: nothing behind the sensor is shown
  double point_size_px = 0.0;  ///< side of a point's square; 0: by the number of points and the zoom
  Eigen::Vector3d eye_m{-14.0, 0.0, 9.0};    ///< perspective: place of the eye, frame of the base
  Eigen::Vector3d target_m{12.0, 0.0, 0.0};  ///< perspective: what it looks at, frame of the base
  double field_of_view_rad = 1.0;            ///< perspective: across the width of the picture
  std::vector<DrawnLine> lines;
  bool shading = true;  ///< darkens a point behind the edge of a nearer one, so that shapes stand out
  bool frame = true;    ///< title, legend, axes, scale bar; without: the points alone fill the picture

  /// Throws ConfigError naming the option, its value and what is allowed.
  void check() const;
};

/// One class of points for `draw_classes`.
struct PointClass {
  std::string name;
  Rgb color;
};

/// A picture of a scan. `points` in the frame of the sensor; `labels` one per point, or empty: then the cloud's own
/// label channel, or none. Points that are NaN or no return are counted in the legend and not drawn.
/// Throws Error(invalid_argument) if `labels` has another length, ConfigError as `DrawOptions::check`.
[[nodiscard]] Image draw_scan(const PointsView& points, std::span<const Label> labels, const DrawOptions& options);

/// The same with classes of the caller's own, e.g. right and wrong against truth: `class_of_point` holds one index
/// into `classes` per point; an index beyond them is not drawn. `options.color` counts as label.
/// Throws Error(invalid_argument) if `class_of_point` has another length than `points`.
[[nodiscard]] Image draw_classes(const PointsView& points, std::span<const std::uint8_t> class_of_point,
                                 std::span<const PointClass> classes, const DrawOptions& options);

}  // namespace berm
