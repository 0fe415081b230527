#pragma once

#include <string>

#include "berm/render/draw_scan.hpp"
#include "berm/render/image.hpp"
#include "berm/render/paint.hpp"
#include "plot_frame.hpp"

namespace berm {

/// What one direction of a chart shows.
struct ChartAxis {
  double low = 0.0;
  double high = 1.0;
  std::string title;
  bool logarithmic = false;  ///< then both ends are positive
};

/// A box with two axes in a picture.
class Chart {
 public:
  /// Width that numbers and title of the vertical axis take left of the box, and height below it.
  static double left_margin_px(const DrawOptions& options) { return 86.0 * FrameSizes(options).unit_px; }
  static double bottom_margin_px(const DrawOptions& options) { return 60.0 * FrameSizes(options).unit_px; }

  Chart(Image& image, const DrawOptions& options, const PixelBox& box, ChartAxis across, ChartAxis up);

  [[nodiscard]] const PixelBox& box() const { return box_; }
  [[nodiscard]] PixelPoint pixel(double across, double up) const;

  /// Lines behind the data.
  void draw_grid() const;
  /// Border, ticks and titles; the numbers and title across only where `label_across`.
  void draw_axes(bool label_across) const;

  /// Fills from `first` to `last` across, over the whole height.
  void fill_stretch(double first, double last, Rgb color) const;
  void draw_line(PixelPoint from, PixelPoint to, double width_px, Rgb color) const;
  /// A square dot; what is outside of the box is left out.
  void draw_dot(PixelPoint at, double size_px, Rgb color) const;

 private:
  [[nodiscard]] std::vector<double> ticks(const ChartAxis& axis, double length_px) const;
  [[nodiscard]] std::string tick_text(const ChartAxis& axis, double value, double length_px) const;

  Image& image_;
  FrameSizes sizes_;
  FrameColors colors_;
  PixelBox box_;
  ChartAxis across_;
  ChartAxis up_;
};

}  // namespace berm
