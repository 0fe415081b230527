#pragma once

#include <string>
#include <vector>

#include "berm/render/draw_scan.hpp"
#include "berm/render/image.hpp"
#include "berm/render/paint.hpp"
#include "projection.hpp"

namespace berm {

/// Colours of everything that is not a point.
struct FrameColors {
  Rgb ground;
  Rgb grid;
  Rgb border;
  Rgb text;
  Rgb faint_text;
};

[[nodiscard]] FrameColors frame_colors(Background background);

/// One entry of a legend.
struct LegendEntry {
  std::string text;
  Rgb color;
};

/// A scale of colours with its ends, drawn in front of the entries of a legend.
struct LegendScale {
  std::string low;
  std::string high;
};

/// Sizes of letters and gaps, in proportion to the picture.
struct FrameSizes {
  explicit FrameSizes(const DrawOptions& options);

  double unit_px;  ///< 1 at 1600 pixels of width
  double text_px;  ///< height of a capital letter
  double title_px;
};

/// Title and legend at the top of a picture, as many lines as they need. Returns the row where they end.
[[nodiscard]] int draw_header(Image& image, const DrawOptions& options, const std::vector<LegendEntry>& entries,
                              const LegendScale* scale);

/// The box that is left for the points below `header_bottom`.
[[nodiscard]] PixelBox plot_box(const DrawOptions& options, int header_bottom);

/// Lines behind the points: rings of equal distance from the sensor (top, perspective) or a grid (side, front).
void draw_grid(Image& image, const DrawOptions& options, const Window& window, const Flattening& flattening);

/// What lies over and beside the points: border, ticks, scale bar, sensor, what the axes are; in perspective how far
/// the rings are.
void draw_axes(Image& image, const DrawOptions& options, const Window& window, const Flattening& flattening);

}  // namespace berm
