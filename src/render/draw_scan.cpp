#include "berm/render/draw_scan.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>
#include <vector>

#include "berm/core/config.hpp"
#include "berm/core/error.hpp"
#include "plot_frame.hpp"
#include "projection.hpp"
#include "splat_canvas.hpp"
#include "ticks.hpp"

namespace berm {
namespace {

constexpr std::array kLabels = {Label::drivable,     Label::terrain,   Label::obstacle,
                                Label::falling_snow, Label::unlabeled, Label::no_return};
constexpr std::uint8_t kNotDrawn = 255;
/// Room for our own classes behind those of a caller.
constexpr std::size_t kMostClasses = 250;

/// A scan with one class per point, ready to be drawn.
struct ClassedScan {
  PointsView points;
  std::vector<std::uint8_t> class_of_point;
  std::vector<PointClass> classes;
  std::vector<std::size_t> counts;
  std::uint8_t no_return = 0;  ///< classes of points that have no place
  std::uint8_t invalid = 0;
};

/// Points that made it onto the plane of the picture.
struct FlatScan {
  std::vector<FlatPoint> points;
  std::vector<std::size_t> sources;  ///< index in the scan
};

bool has_place(const PointsView& points, std::size_t i) {
  const auto near_enough = [](float value) { return std::abs(value) <= static_cast<float>(kFarthest_m); };
  return near_enough(points.x[i]) && near_enough(points.y[i]) && near_enough(points.z[i]);
}

/// Points without a place change to the classes for such, whatever their class was; all are counted.
void sort_out_and_count(ClassedScan& scan) {
  scan.counts.assign(scan.classes.size(), 0);
  const PointsView& points = scan.points;
  for (std::size_t i = 0; i < points.size(); ++i) {
    std::uint8_t& its_class = scan.class_of_point[i];
    if (is_no_return(points.x[i], points.y[i], points.z[i])) {
      its_class = scan.no_return;
    } else if (!has_place(points, i)) {
      its_class = scan.invalid;
    }
    if (its_class < scan.counts.size()) {
      ++scan.counts[its_class];
    } else {
      its_class = kNotDrawn;
    }
  }
}

ClassedScan classed_by_label(const PointsView& points, std::span<const Label> labels, Background background) {
  ClassedScan scan;
  scan.points = points;
  std::array<std::uint8_t, 256> class_of_label{};
  class_of_label.fill(kNotDrawn);
  for (const Label label : kLabels) {
    class_of_label[static_cast<std::uint8_t>(label)] = static_cast<std::uint8_t>(scan.classes.size());
    scan.classes.push_back({label_name(label), label_color(label, background)});
  }
  scan.no_return = class_of_label[static_cast<std::uint8_t>(Label::no_return)];
  scan.invalid = static_cast<std::uint8_t>(scan.classes.size());
  scan.classes.push_back({"invalid", label_color(Label::no_return, background)});
  scan.class_of_point.assign(points.size(), class_of_label[static_cast<std::uint8_t>(Label::unlabeled)]);
  std::transform(labels.begin(), labels.end(), scan.class_of_point.begin(),
                 [&](Label label) { return class_of_label[static_cast<std::uint8_t>(label)]; });
  sort_out_and_count(scan);
  return scan;
}

FlatScan flatten(const ClassedScan& scan, const Flattening& flattening) {
  FlatScan flat;
  flat.points.reserve(scan.points.size());
  flat.sources.reserve(scan.points.size());
  for (std::size_t i = 0; i < scan.points.size(); ++i) {
    const std::uint8_t its_class = scan.class_of_point[i];
    if (its_class == kNotDrawn || its_class == scan.invalid ||
        is_no_return(scan.points.x[i], scan.points.y[i], scan.points.z[i])) {
      continue;
    }
    const auto point = flattening.from_sensor({scan.points.x[i], scan.points.y[i], scan.points.z[i]});
    if (point) {
      flat.points.push_back(*point);
      flat.sources.push_back(i);
    }
  }
  return flat;
}

/// What the colour scale says of each flat point, and its ends: without the 2 % at each, which would dull the rest.
struct ScaledValues {
  std::vector<float> values;
  double low = 0.0;
  double high = 1.0;

  [[nodiscard]] double share(std::size_t i) const { return (values[i] - low) / (high - low); }
};

ScaledValues scaled_values(const ClassedScan& scan, const FlatScan& flat, const Flattening& flattening,
                           bool by_intensity) {
  ScaledValues scaled;
  scaled.values.reserve(flat.sources.size());
  for (const std::size_t i : flat.sources) {
    const double value = by_intensity ? static_cast<double>(scan.points.intensity[i])
                                      : flattening.height_m({scan.points.x[i], scan.points.y[i], scan.points.z[i]});
    scaled.values.push_back(std::isfinite(value) ? static_cast<float>(value) : 0.0F);
  }
  if (scaled.values.empty()) {
    return scaled;
  }
  std::vector<float> sorted = scaled.values;
  const auto stray = static_cast<std::ptrdiff_t>(0.02 * static_cast<double>(sorted.size() - 1));
  std::nth_element(sorted.begin(), sorted.begin() + stray, sorted.end());
  scaled.low = by_intensity ? 0.0 : static_cast<double>(sorted[static_cast<std::size_t>(stray)]);
  const auto high = sorted.end() - 1 - stray;
  std::nth_element(sorted.begin(), high, sorted.end());
  scaled.high = std::max(static_cast<double>(*high), scaled.low + 1e-3);
  return scaled;
}

struct PointSize {
  double width_px;
  double height_px;
};

/// Such that the points about cover the box if they lay evenly in it, but never specks nor blots.
PointSize point_size(const DrawOptions& options, const Window& window, std::size_t points) {
  double size_px = options.point_size_px;
  if (size_px <= 0.0) {
    const double area_px = static_cast<double>(window.box.width()) * window.box.height();
    const double largest_px = 4.0 * std::max(options.width_px / 1600.0, 0.5);
    // In perspective much of the picture is sky, and points crowd on the rest.
    const double cover = options.view == DrawView::perspective ? 0.5 : 0.25;
    size_px = std::clamp(std::sqrt(cover * area_px / std::max<double>(1.0, static_cast<double>(points))),
                         0.4 * largest_px, largest_px);
  }
  if (options.view == DrawView::front) {
    const double stretch = std::max(window.v_scale_px() / window.h_scale_px(), 1.0);
    return {size_px, size_px * stretch};
  }
  return {size_px, size_px};
}

/// Darkness per unit of depth behind an edge: metres for top and side, logarithm of the distance for the others.
double shade_strength(DrawView view) {
  switch (view) {
    case DrawView::top:
      return 0.12;
    case DrawView::side:
      return 0.02;
    case DrawView::front:
      return 1.0;
    case DrawView::perspective:
      break;
  }
  return 2.0;
}

void paint_points(Image& image, const ClassedScan& scan, const FlatScan& flat, const Window& window,
                  const DrawOptions& options, const ScaledValues* scaled) {
  SplatCanvas canvas(window.box);
  const PointSize size = point_size(options, window, flat.points.size());
  // In perspective the size belongs to points at the place looked at; nearer ones are larger, within reason.
  const bool perspective = options.view == DrawView::perspective;
  const double log_distance = std::log(std::max((options.target_m - options.eye_m).norm(), 1e-3));
  for (std::size_t i = 0; i < flat.points.size(); ++i) {
    const FlatPoint& point = flat.points[i];
    const double zoom = perspective ? std::clamp(std::exp(log_distance - point.depth), 0.8, 2.0) : 1.0;
    const Rgb color = scaled != nullptr ? scale_color(scaled->share(i), options.background)
                                        : scan.classes[scan.class_of_point[flat.sources[i]]].color;
    canvas.add(window.pixel(point.h, point.v), size.width_px * zoom, size.height_px * zoom, point.depth, color);
  }
  if (options.shading) {
    canvas.shade(shade_strength(options.view));
  }
  canvas.lay_over(image);
}

void paint_lines(Image& image, const Window& window, const DrawOptions& options, const Flattening& flattening) {
  const double width_px = 3.5 * FrameSizes(options).unit_px;
  for (const DrawnLine& line : options.lines) {
    std::optional<FlatPoint> last;
    for (const Eigen::Vector3d& vertex_m : line.vertices_m) {
      const std::optional<FlatPoint> flat = flattening.from_base(vertex_m);
      if (last && flat) {
        draw_line(image, window.pixel(last->h, last->v), window.pixel(flat->h, flat->v), width_px, line.color,
                  window.box);
      }
      last = flat;
    }
  }
}

std::vector<LegendEntry> legend(const ClassedScan& scan, const ScaledValues* scaled, const DrawOptions& options) {
  std::vector<LegendEntry> entries;
  for (std::size_t k = 0; k < scan.classes.size(); ++k) {
    const bool has_place = k != scan.no_return && k != scan.invalid;
    if (scan.counts[k] > 0 && (scaled == nullptr || !has_place)) {
      entries.push_back({scan.classes[k].name + " " + count_text(scan.counts[k]), scan.classes[k].color});
    }
  }
  for (const DrawnLine& line : options.lines) {
    const bool known = std::any_of(entries.begin(), entries.end(),
                                   [&line](const LegendEntry& entry) { return entry.text == line.name; });
    if (!known && !line.vertices_m.empty()) {
      entries.push_back({line.name, line.color});
    }
  }
  return entries;
}

LegendScale scale_ends(const ScaledValues& scaled, bool by_intensity) {
  const double step = nice_step(scaled.high - scaled.low, 100);
  return {(by_intensity ? "intensity " : "height ") + number_text(scaled.low, step),
          number_text(scaled.high, step) + (by_intensity ? "" : " m")};
}

Image draw(const ClassedScan& scan, const DrawOptions& options, bool by_class) {
  Image image(options.width_px, options.height_px, frame_colors(options.background).ground);
  const Flattening flattening(options);
  const FlatScan flat = flatten(scan, flattening);
  const bool by_intensity = options.color == DrawColor::intensity && !scan.points.intensity.empty();
  ScaledValues values;
  const ScaledValues* scaled = nullptr;
  if (!by_class) {
    values = scaled_values(scan, flat, flattening, by_intensity);
    scaled = &values;
  }

  PixelBox box{0, 0, options.width_px, options.height_px};
  bool frame = options.frame;
  if (frame) {
    const LegendScale ends = scale_ends(values, by_intensity);
    const PixelBox inner =
        plot_box(options, draw_header(image, options, legend(scan, scaled, options), by_class ? nullptr : &ends));
    // In a picture of a thumb's size nothing is left beside the frame: then only the header is kept.
    constexpr int kSmallest_px = 32;
    frame = inner.width() >= kSmallest_px && inner.height() >= kSmallest_px;
    box = frame ? inner : box;
  }
  const Window window = choose_window(flat.points, options, box);
  if (frame) {
    draw_grid(image, options, window, flattening);
  }
  paint_points(image, scan, flat, window, options, scaled);
  paint_lines(image, window, options, flattening);
  if (frame) {
    draw_axes(image, options, window, flattening);
  }
  return image;
}

void check_points(const PointsView& points) {
  const std::size_t n = points.size();
  const bool right = points.y.size() == n && points.z.size() == n &&
                     (points.intensity.empty() || points.intensity.size() == n) &&
                     (points.label.empty() || points.label.size() == n);
  if (!right) {
    throw Error(ErrorCode::invalid_argument, "draw: the channels of the cloud differ in length");
  }
}

void check_number(std::string_view key, double value, const Range& range) {
  check_problem("draw", key, find_problem(value, range));
}

void check_length(std::size_t length, std::size_t points) {
  if (length != points) {
    throw Error(ErrorCode::invalid_argument,
                "draw: " + std::to_string(length) + " classes for " + std::to_string(points) + " points");
  }
}

}  // namespace

void DrawOptions::check() const {
  check_number("width_px", width_px, {64, Image::kMaxSide_px});
  check_number("height_px", height_px, {64, Image::kMaxSide_px});
  check_number("range_m", range_m, {0.0, kFarthest_m});
  check_number("point_size_px", point_size_px, {0.0, 256.0});
  check_number("field_of_view_rad", field_of_view_rad, {0.05, 2.6});
  for (int axis = 0; axis < 3; ++axis) {
    check_number("eye_m", eye_m[axis], {-kFarthest_m, kFarthest_m});
    check_number("target_m", target_m[axis], {-kFarthest_m, kFarthest_m});
    check_number("T_base_sensor", T_base_sensor.translation_m()[axis], {-kFarthest_m, kFarthest_m});
  }
  check_number("T_base_sensor", T_base_sensor.rotation().norm(), {0.999, 1.001});
  if ((target_m - eye_m).norm() < 1e-3) {
    throw ConfigError("draw.target_m", "is the same place as draw.eye_m, expected another");
  }
}

Image draw_scan(const PointsView& points, std::span<const Label> labels, const DrawOptions& options) {
  options.check();
  check_points(points);
  const std::span<const Label> used = labels.empty() ? points.label : labels;
  if (!used.empty()) {
    check_length(used.size(), points.size());
  }
  return draw(classed_by_label(points, used, options.background), options, options.color == DrawColor::label);
}

Image draw_classes(const PointsView& points, std::span<const std::uint8_t> class_of_point,
                   std::span<const PointClass> classes, const DrawOptions& options) {
  options.check();
  check_points(points);
  check_length(class_of_point.size(), points.size());
  if (classes.size() > kMostClasses) {
    throw Error(ErrorCode::invalid_argument, "draw: " + std::to_string(classes.size()) + " classes, expected at most " +
                                                 std::to_string(kMostClasses));
  }
  ClassedScan scan;
  scan.points = points;
  scan.classes.assign(classes.begin(), classes.end());
  scan.no_return = static_cast<std::uint8_t>(scan.classes.size());
  scan.classes.push_back({label_name(Label::no_return), label_color(Label::no_return, options.background)});
  scan.invalid = static_cast<std::uint8_t>(scan.classes.size());
  scan.classes.push_back({"invalid", label_color(Label::no_return, options.background)});
  scan.class_of_point.assign(class_of_point.begin(), class_of_point.end());
  // Ours lie behind those of the caller and are not for indices that are too large.
  std::replace_if(
      scan.class_of_point.begin(), scan.class_of_point.end(), [&](std::uint8_t k) { return k >= classes.size(); },
      kNotDrawn);
  sort_out_and_count(scan);
  return draw(scan, options, true);
}

}  // namespace berm
