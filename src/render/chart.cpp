#include "chart.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "ticks.hpp"
#include "whole.hpp"

namespace berm {
namespace {

/// About this many pixels of a picture of 1600 lie between two ticks.
constexpr double kTickDistance_px = 110.0;

double share_of(const ChartAxis& axis, double value) {
  if (axis.logarithmic) {
    return std::log(std::max(value, axis.low) / axis.low) / std::log(axis.high / axis.low);
  }
  return (value - axis.low) / (axis.high - axis.low);
}

}  // namespace

Chart::Chart(Image& image, const DrawOptions& options, const PixelBox& box, ChartAxis across, ChartAxis up)
    : image_(image),
      sizes_(options),
      colors_(frame_colors(options.background)),
      box_(box),
      across_(std::move(across)),
      up_(std::move(up)) {}

PixelPoint Chart::pixel(double across, double up) const {
  return {box_.left + share_of(across_, across) * box_.width(), box_.bottom - share_of(up_, up) * box_.height()};
}

std::vector<double> Chart::ticks(const ChartAxis& axis, double length_px) const {
  if (!axis.logarithmic) {
    const int at_most = std::max(whole(length_px / (kTickDistance_px * sizes_.unit_px)), 2);
    return multiples(axis.low, axis.high, nice_step(axis.high - axis.low, at_most));
  }
  std::vector<double> powers;
  for (double power = std::pow(10.0, std::ceil(std::log10(axis.low))); power <= axis.high; power *= 10.0) {
    powers.push_back(power);
  }
  return powers;
}

std::string Chart::tick_text(const ChartAxis& axis, double value, double length_px) const {
  if (axis.logarithmic) {
    return value >= 1.0 ? count_text(static_cast<std::size_t>(value)) : number_text(value, value);
  }
  const int at_most = std::max(whole(length_px / (kTickDistance_px * sizes_.unit_px)), 2);
  return number_text(value, nice_step(axis.high - axis.low, at_most));
}

void Chart::draw_grid() const {
  const double width_px = 1.2 * sizes_.unit_px;
  for (const double value : ticks(across_, box_.width())) {
    const double u = pixel(value, up_.low).u;
    draw_line({u, double(box_.top)}, {u, double(box_.bottom)}, width_px, colors_.grid);
  }
  for (const double value : ticks(up_, 2.0 * box_.height())) {
    const double v = pixel(across_.low, value).v;
    draw_line({double(box_.left), v}, {double(box_.right), v}, width_px, colors_.grid);
  }
}

void Chart::draw_axes(bool label_across) const {
  const PixelBox all{0, 0, image_.width_px(), image_.height_px()};
  const double line_px = 1.2 * sizes_.unit_px;
  const double mark_px = 6.0 * sizes_.unit_px;
  const PixelPoint corners[] = {{double(box_.left), double(box_.top)},
                                {double(box_.right), double(box_.top)},
                                {double(box_.right), double(box_.bottom)},
                                {double(box_.left), double(box_.bottom)},
                                {double(box_.left), double(box_.top)}};
  for (int i = 0; i < 4; ++i) {
    berm::draw_line(image_, corners[i], corners[i + 1], line_px, colors_.border, all);
  }
  for (const double value : ticks(across_, box_.width())) {
    const PixelPoint foot{pixel(value, up_.low).u, double(box_.bottom)};
    berm::draw_line(image_, foot, {foot.u, foot.v + mark_px}, line_px, colors_.border, all);
    if (label_across) {
      draw_text(image_, {foot.u, foot.v + mark_px + sizes_.text_px}, tick_text(across_, value, box_.width()),
                sizes_.text_px, TextAnchor::center, colors_.faint_text);
    }
  }
  for (const double value : ticks(up_, 2.0 * box_.height())) {
    const double v = pixel(across_.low, value).v;
    berm::draw_line(image_, {box_.left - mark_px, v}, {double(box_.left), v}, line_px, colors_.border, all);
    draw_text(image_, {box_.left - 1.8 * mark_px, v}, tick_text(up_, value, 2.0 * box_.height()), sizes_.text_px,
              TextAnchor::right, colors_.faint_text);
  }
  // Titles of vertical axes lie flat inside of the box: nobody likes to read sideways.
  draw_text(image_, {box_.left + 14.0 * sizes_.unit_px, box_.top + 1.4 * sizes_.text_px}, up_.title, sizes_.text_px,
            TextAnchor::left, colors_.text);
  if (label_across) {
    draw_text(image_, {double(box_.right), box_.bottom + mark_px + 2.9 * sizes_.text_px}, across_.title, sizes_.text_px,
              TextAnchor::right, colors_.faint_text);
  }
}

void Chart::fill_stretch(double first, double last, Rgb color) const {
  const int left = std::clamp(whole(pixel(first, up_.low).u), box_.left, box_.right);
  const int right = std::clamp(std::max(whole(pixel(last, up_.low).u), left + 1), box_.left, box_.right);
  fill_box(image_, {left, box_.top, right, box_.bottom}, color);
}

void Chart::draw_line(PixelPoint from, PixelPoint to, double width_px, Rgb color) const {
  berm::draw_line(image_, from, to, width_px, color, box_);
}

void Chart::draw_dot(PixelPoint at, double size_px, Rgb color) const {
  if (at.u < box_.left || at.u > box_.right || at.v < box_.top || at.v > box_.bottom) {
    return;
  }
  const double half_px = 0.5 * size_px;
  const int left = whole(at.u - half_px);
  const int top = whole(at.v - half_px);
  const int side = std::max(whole(size_px), 1);
  fill_box(image_, {left, top, left + side, top + side}, color);
}

}  // namespace berm
