#include <algorithm>
#include <cmath>

#include "berm/core/error.hpp"
#include "berm/render/draw_figure.hpp"
#include "chart.hpp"

namespace berm {
namespace {

/// Of the highest value, so that no line runs along the border.
constexpr double kHeadroom = 1.06;

struct CurveRange {
  double first = 0.0;
  double last = 0.0;
  double highest = 0.0;
};

CurveRange range_of(std::span<const Curve> curves) {
  CurveRange range;
  bool any = false;
  for (const Curve& curve : curves) {
    for (const Eigen::Vector2d& point : curve.points) {
      if (point.allFinite()) {
        range.first = any ? std::min(range.first, point.x()) : point.x();
        range.last = any ? std::max(range.last, point.x()) : point.x();
        range.highest = std::max(range.highest, point.y());
        any = true;
      }
    }
  }
  if (!any) {
    throw Error(ErrorCode::invalid_argument, "draw: the curves hold no finite value");
  }
  range.last = std::max(range.last, range.first + 1e-9);
  return range;
}

void paint_curve(const Chart& chart, const Curve& curve, double width_px) {
  for (std::size_t i = 0; i < curve.points.size(); ++i) {
    const Eigen::Vector2d& here = curve.points[i];
    const Eigen::Vector2d& before = curve.points[i == 0 ? 0 : i - 1];
    if (here.allFinite() && before.allFinite()) {
      chart.draw_line(chart.pixel(before.x(), before.y()), chart.pixel(here.x(), here.y()), width_px, curve.color);
    }
  }
}

}  // namespace

Image draw_curves(std::span<const Curve> curves, const CurveAxes& axes, const DrawOptions& options) {
  options.check();
  const CurveRange range = range_of(curves);
  const FrameColors colors = frame_colors(options.background);
  Image image(options.width_px, options.height_px, colors.ground);
  std::vector<LegendEntry> legend;
  for (const Curve& curve : curves) {
    legend.push_back({curve.name, curve.color});
  }
  const int header = draw_header(image, options, legend, nullptr);
  const double unit_px = FrameSizes(options).unit_px;
  const PixelBox box{static_cast<int>(Chart::left_margin_px(options)), header,
                     options.width_px - static_cast<int>(24.0 * unit_px),
                     options.height_px - static_cast<int>(Chart::bottom_margin_px(options))};
  if (box.width() < 16 || box.height() < 16) {
    return image;
  }
  const double highest = range.highest > 0.0 ? kHeadroom * range.highest : 1.0;
  const Chart chart(image, options, box, {range.first, range.last, axes.across}, {0.0, highest, axes.up});
  chart.draw_grid();
  for (const Curve& curve : curves) {
    paint_curve(chart, curve, 2.0 * unit_px);
  }
  chart.draw_axes(true);
  return image;
}

}  // namespace berm
