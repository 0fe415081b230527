#include "plot_frame.hpp"

#include <algorithm>
#include <cmath>

#include "ticks.hpp"
#include "whole.hpp"

namespace berm {
namespace {

constexpr double kPi = 3.14159265358979323846;
/// About this many pixels of a picture of 1600 lie between two ticks.
constexpr double kFrameTickDistance_px = 150.0;

int tick_count(double length_px, const FrameSizes& sizes) {
  return std::max(whole(length_px / (kFrameTickDistance_px * sizes.unit_px)), 2);
}

/// One step for both axes where they share a scale, so that the grid is of squares.
double tick_step(const Window& window, const FrameSizes& sizes) {
  return nice_step(window.h_max - window.h_min, tick_count(window.box.width(), sizes));
}

double vertical_tick_step(const DrawOptions& options, const Window& window, const FrameSizes& sizes) {
  if (options.view == DrawView::top) {
    return tick_step(window, sizes);
  }
  return nice_step(window.v_max - window.v_min, tick_count(2.0 * window.box.height(), sizes));
}

std::string axes_text(const DrawOptions& options, const Window& window) {
  switch (options.view) {
    case DrawView::top:
      return "x up, y to the left, in m";
    case DrawView::front:
      return "azimuth to the left, elevation up, in deg";
    case DrawView::perspective:
      return "";
    case DrawView::side:
      break;
  }
  const double exaggeration = window.v_scale_px() / window.h_scale_px();
  const std::string times = exaggeration > 1.05 ? " (drawn " + number_text(exaggeration, 0.1) + " x)" : "";
  return "x to the right, z up" + times + ", in m";
}

/// Rings of the perspective view.
constexpr double kRingStep_m = 10.0;
constexpr double kLastRing_m = 50.0;

/// The middle of the rings: where the ground is if the base lies on it.
Eigen::Vector3d below_sensor_m(const DrawOptions& options) {
  return {options.T_base_sensor.translation_m().x(), options.T_base_sensor.translation_m().y(), 0.0};
}

void draw_rings(Image& image, const DrawOptions& options, const Window& window, const Flattening& flattening) {
  constexpr int kPieces = 256;
  const FrameSizes sizes(options);
  const FrameColors colors = frame_colors(options.background);
  const bool top = options.view == DrawView::top;
  const double step_m = top ? tick_step(window, sizes) : kRingStep_m;
  const double reach_m = top ? std::hypot(std::max(std::abs(window.h_min), std::abs(window.h_max)),
                                          std::max(std::abs(window.v_min), std::abs(window.v_max)))
                             : kLastRing_m;
  const Eigen::Vector3d center_m = below_sensor_m(options);
  for (double radius_m = step_m; radius_m <= reach_m; radius_m += step_m) {
    std::optional<FlatPoint> last;
    for (int piece = 0; piece <= kPieces; ++piece) {
      const double angle = 2.0 * kPi * piece / kPieces;
      const Eigen::Vector3d place_m = center_m + radius_m * Eigen::Vector3d{std::cos(angle), std::sin(angle), 0.0};
      const std::optional<FlatPoint> flat = flattening.from_base(place_m);
      if (last && flat) {
        draw_line(image, window.pixel(last->h, last->v), window.pixel(flat->h, flat->v), 1.2 * sizes.unit_px,
                  colors.grid, window.box);
      }
      last = flat;
    }
  }
}

/// Text with a rim in the colour of the ground, readable in the middle of points.
void draw_text_apart(Image& image, PixelPoint place, const std::string& text, const FrameSizes& sizes,
                     Background background) {
  const FrameColors colors = frame_colors(background);
  const double rim_px = 1.6 * sizes.unit_px;
  for (const double du : {-rim_px, 0.0, rim_px}) {
    for (const double dv : {-rim_px, 0.0, rim_px}) {
      draw_text(image, {place.u + du, place.v + dv}, text, sizes.text_px, TextAnchor::center, colors.ground);
    }
  }
  draw_text(image, place, text, sizes.text_px, TextAnchor::center, colors.faint_text);
}

/// Written at the rings to both sides of straight ahead, where fewer points lie than on the road.
void draw_ring_distances(Image& image, const DrawOptions& options, const Window& window, const Flattening& flattening) {
  const FrameSizes sizes(options);
  for (double radius_m = kRingStep_m; radius_m <= kLastRing_m; radius_m += kRingStep_m) {
    for (const double angle : {0.18 * kPi, -0.18 * kPi}) {
      const Eigen::Vector3d place_m =
          below_sensor_m(options) + radius_m * Eigen::Vector3d{std::cos(angle), std::sin(angle), 0.0};
      const std::optional<FlatPoint> flat = flattening.from_base(place_m);
      if (!flat) {
        continue;
      }
      const PixelPoint place = window.pixel(flat->h, flat->v);
      if (place.v > window.box.top + sizes.text_px) {
        draw_text_apart(image, place, number_text(radius_m, 1.0) + " m", sizes, options.background);
      }
    }
  }
}

void draw_lattice(Image& image, const DrawOptions& options, const Window& window) {
  const FrameSizes sizes(options);
  const Rgb color = frame_colors(options.background).grid;
  const PixelBox& box = window.box;
  for (const double h : multiples(window.h_min, window.h_max, tick_step(window, sizes))) {
    const double u = window.pixel(h, 0.0).u;
    draw_line(image, {u, double(box.top)}, {u, double(box.bottom)}, 1.2 * sizes.unit_px, color, box);
  }
  for (const double v : multiples(window.v_min, window.v_max, vertical_tick_step(options, window, sizes))) {
    const double y = window.pixel(0.0, v).v;
    draw_line(image, {double(box.left), y}, {double(box.right), y}, 1.2 * sizes.unit_px, color, box);
  }
}

void draw_border(Image& image, const Window& window, const FrameColors& colors, double width_px) {
  const PixelBox all{0, 0, image.width_px(), image.height_px()};
  const PixelBox& b = window.box;
  const PixelPoint corners[] = {{double(b.left), double(b.top)},
                                {double(b.right), double(b.top)},
                                {double(b.right), double(b.bottom)},
                                {double(b.left), double(b.bottom)},
                                {double(b.left), double(b.top)}};
  for (int i = 0; i < 4; ++i) {
    draw_line(image, corners[i], corners[i + 1], width_px, colors.border, all);
  }
}

void draw_ticks(Image& image, const DrawOptions& options, const Window& window) {
  const FrameSizes sizes(options);
  const FrameColors colors = frame_colors(options.background);
  const PixelBox all{0, 0, image.width_px(), image.height_px()};
  const PixelBox& box = window.box;
  const double mark_px = 6.0 * sizes.unit_px;
  const double line_px = 1.2 * sizes.unit_px;
  // To the left is positive in the views from above and from the sensor.
  const double sign = options.view == DrawView::side ? 1.0 : -1.0;
  const double h_step = tick_step(window, sizes);
  for (const double h : multiples(window.h_min, window.h_max, h_step)) {
    const double u = window.pixel(h, 0.0).u;
    draw_line(image, {u, double(box.bottom)}, {u, box.bottom + mark_px}, line_px, colors.border, all);
    draw_text(image, {u, box.bottom + mark_px + sizes.text_px}, number_text(sign * h, h_step), sizes.text_px,
              TextAnchor::center, colors.faint_text);
  }
  const double v_step = vertical_tick_step(options, window, sizes);
  for (const double v : multiples(window.v_min, window.v_max, v_step)) {
    const double y = window.pixel(0.0, v).v;
    draw_line(image, {box.left - mark_px, y}, {double(box.left), y}, line_px, colors.border, all);
    draw_text(image, {box.left - 1.8 * mark_px, y}, number_text(v, v_step), sizes.text_px, TextAnchor::right,
              colors.faint_text);
  }
}

void draw_scale_bar(Image& image, const DrawOptions& options, const Window& window) {
  const FrameSizes sizes(options);
  const FrameColors colors = frame_colors(options.background);
  const double length_m = nice_step(0.25 * (window.h_max - window.h_min), 2);
  const double length_px = length_m * window.h_scale_px();
  const std::string text = number_text(length_m, length_m) + " m";
  const double inset_px = 18.0 * sizes.unit_px;
  // The lower corner of a view from the side is where the ground lies.
  const bool top = options.view == DrawView::top;
  const double y = top ? window.box.bottom - inset_px : window.box.top + inset_px + 2.0 * sizes.text_px;
  const double left = window.box.left + inset_px;
  const double panel_px = 10.0 * sizes.unit_px;
  fill_box(
      image,
      {whole(left - panel_px), whole(y - 2.6 * sizes.text_px), whole(left + length_px + panel_px), whole(y + panel_px)},
      colors.ground);
  for (const double u : {left, left + length_px}) {
    draw_line(image, {u, y - 5.0 * sizes.unit_px}, {u, y + 5.0 * sizes.unit_px}, 2.0 * sizes.unit_px, colors.text,
              window.box);
  }
  draw_line(image, {left, y}, {left + length_px, y}, 2.0 * sizes.unit_px, colors.text, window.box);
  draw_text(image, {left + 0.5 * length_px, y - 1.3 * sizes.text_px}, text, sizes.text_px, TextAnchor::center,
            colors.text);
}

/// An arrow head at the sensor, pointing along its x.
void draw_sensor(Image& image, const DrawOptions& options, const Window& window) {
  const FrameSizes sizes(options);
  const Rgb color = frame_colors(options.background).text;
  const Eigen::Vector3d sensor_m = options.T_base_sensor.translation_m();
  const bool top = options.view == DrawView::top;
  const PixelPoint at = top ? window.pixel(-sensor_m.y(), sensor_m.x()) : window.pixel(sensor_m.x(), sensor_m.z());
  const double size_px = 9.0 * sizes.unit_px;
  const auto corner = [&](double along, double across) {
    return top ? PixelPoint{at.u + across * size_px, at.v - along * size_px}
               : PixelPoint{at.u + along * size_px, at.v + across * size_px};
  };
  const PixelPoint corners[] = {corner(1.2, 0.0), corner(-1.0, 0.8), corner(-0.5, 0.0), corner(-1.0, -0.8),
                                corner(1.2, 0.0)};
  for (int i = 0; i < 4; ++i) {
    draw_line(image, corners[i], corners[i + 1], 2.2 * sizes.unit_px, color, window.box);
  }
}

}  // namespace

FrameColors frame_colors(Background background) {
  if (background == Background::dark) {
    return {{14, 17, 22}, {38, 44, 54}, {84, 94, 108}, {232, 236, 240}, {160, 168, 178}};
  }
  return {{255, 255, 255}, {226, 229, 233}, {140, 146, 154}, {24, 28, 34}, {90, 96, 104}};
}

FrameSizes::FrameSizes(const DrawOptions& options)
    : unit_px(std::clamp(options.width_px / 1600.0, 0.5, 8.0)), text_px(13.0 * unit_px), title_px(19.0 * unit_px) {}

int draw_header(Image& image, const DrawOptions& options, const std::vector<LegendEntry>& entries,
                const LegendScale* scale) {
  const FrameSizes sizes(options);
  const FrameColors colors = frame_colors(options.background);
  const double margin_px = 24.0 * sizes.unit_px;
  const double gap_px = 8.0 * sizes.unit_px;
  double y = margin_px;
  if (!options.title.empty()) {
    y += 0.5 * sizes.title_px;
    draw_text(image, {margin_px, y}, options.title, sizes.title_px, TextAnchor::left, colors.text);
    y += 0.5 * sizes.title_px + 1.1 * margin_px;
  }
  y += 0.5 * sizes.text_px;
  double u = margin_px;
  if (scale != nullptr) {
    draw_text(image, {u, y}, scale->low, sizes.text_px, TextAnchor::left, colors.text);
    u += text_width_px(scale->low, sizes.text_px) + gap_px;
    const int columns = whole(180.0 * sizes.unit_px);
    for (int i = 0; i < columns; ++i) {
      fill_box(image, {whole(u) + i, whole(y - 0.5 * sizes.text_px), whole(u) + i + 1, whole(y + 0.5 * sizes.text_px)},
               scale_color(static_cast<double>(i) / columns, options.background));
    }
    u += columns + gap_px;
    draw_text(image, {u, y}, scale->high, sizes.text_px, TextAnchor::left, colors.text);
    u += text_width_px(scale->high, sizes.text_px) + 1.6 * margin_px;
  }
  for (const LegendEntry& entry : entries) {
    const double width_px = sizes.text_px + gap_px + text_width_px(entry.text, sizes.text_px);
    if (u > margin_px && u + width_px > options.width_px - margin_px) {
      u = margin_px;
      y += 2.0 * sizes.text_px;
    }
    fill_box(image,
             {whole(u), whole(y - 0.5 * sizes.text_px), whole(u + sizes.text_px), whole(y + 0.5 * sizes.text_px)},
             entry.color);
    draw_text(image, {u + sizes.text_px + gap_px, y}, entry.text, sizes.text_px, TextAnchor::left, colors.text);
    u += width_px + 1.4 * margin_px;
  }
  return whole(y + 0.5 * sizes.text_px + 0.7 * margin_px);
}

PixelBox plot_box(const DrawOptions& options, int header_bottom) {
  const FrameSizes sizes(options);
  const int edge_px = whole(24.0 * sizes.unit_px);
  if (options.view == DrawView::perspective) {
    return {0, header_bottom, options.width_px, options.height_px};
  }
  return {whole(76.0 * sizes.unit_px), header_bottom, options.width_px - edge_px,
          options.height_px - whole(6.0 * sizes.unit_px + 4.6 * sizes.text_px)};
}

void draw_grid(Image& image, const DrawOptions& options, const Window& window, const Flattening& flattening) {
  if (options.view == DrawView::top || options.view == DrawView::perspective) {
    draw_rings(image, options, window, flattening);
  } else {
    draw_lattice(image, options, window);
  }
}

void draw_axes(Image& image, const DrawOptions& options, const Window& window, const Flattening& flattening) {
  if (options.view == DrawView::perspective) {
    draw_ring_distances(image, options, window, flattening);
    return;
  }
  const FrameSizes sizes(options);
  const FrameColors colors = frame_colors(options.background);
  draw_border(image, window, colors, 1.2 * sizes.unit_px);
  draw_ticks(image, options, window);
  if (options.view != DrawView::front) {
    draw_sensor(image, options, window);
    draw_scale_bar(image, options, window);
  }
  draw_text(image, {static_cast<double>(window.box.right), options.height_px - 1.4 * sizes.text_px},
            axes_text(options, window), sizes.text_px, TextAnchor::right, colors.faint_text);
}

}  // namespace berm
