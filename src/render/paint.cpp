#include "berm/render/paint.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "font.hpp"

namespace berm {
namespace {

/// Width of a stroke of text in columns of the font's raster: neither thin nor clotted.
constexpr double kStrokeColumns = 1.05;

struct Segment {
  PixelPoint from;
  PixelPoint to;
};

bool is_finite(PixelPoint p) {
  return std::isfinite(p.u) && std::isfinite(p.v);
}

double distance_px(PixelPoint p, const Segment& segment) {
  const double du = segment.to.u - segment.from.u;
  const double dv = segment.to.v - segment.from.v;
  const double length_squared = du * du + dv * dv;
  double share = 0.0;
  if (length_squared > 0.0) {
    share = std::clamp(((p.u - segment.from.u) * du + (p.v - segment.from.v) * dv) / length_squared, 0.0, 1.0);
  }
  return std::hypot(p.u - segment.from.u - share * du, p.v - segment.from.v - share * dv);
}

/// Share of a pixel that a stroke covers whose middle line passes at `distance`.
double coverage(double distance_px, double width_px) {
  return std::clamp(0.5 * width_px + 0.5 - distance_px, 0.0, 1.0);
}

/// The first and the last whole pixel + 1 of [low, high], inside of [first, last].
std::array<int, 2> pixel_span(double low, double high, int first, int last) {
  const double from = std::clamp(std::floor(low), static_cast<double>(first), static_cast<double>(last));
  const double to = std::clamp(std::ceil(high), static_cast<double>(first), static_cast<double>(last));
  return {static_cast<int>(from), static_cast<int>(to)};
}

PixelBox inside(const Image& image, const PixelBox& box) {
  return {std::max(box.left, 0), std::max(box.top, 0), std::min(box.right, image.width_px()),
          std::min(box.bottom, image.height_px())};
}

/// Strokes of a letter: neighbouring nodes of its raster joined, diagonally only where no straight way leads.
std::vector<Segment> strokes(std::string_view rows, PixelPoint corner, double unit_px) {
  const auto place = [&](int column, int row) {
    return PixelPoint{corner.u + (column + 0.5) * unit_px, corner.v + (row + 0.5) * unit_px};
  };
  std::vector<Segment> result;
  for (int row = 0; row < font::kRows; ++row) {
    for (int column = 0; column < font::kColumns; ++column) {
      if (!font::has_node(rows, column, row)) {
        continue;
      }
      const bool right = font::has_node(rows, column + 1, row);
      const bool left = font::has_node(rows, column - 1, row);
      const bool below = font::has_node(rows, column, row + 1);
      result.push_back({place(column, row), place(column, row)});
      if (right) {
        result.push_back({place(column, row), place(column + 1, row)});
      }
      if (below) {
        result.push_back({place(column, row), place(column, row + 1)});
      }
      if (!right && !below && font::has_node(rows, column + 1, row + 1)) {
        result.push_back({place(column, row), place(column + 1, row + 1)});
      }
      if (!left && !below && font::has_node(rows, column - 1, row + 1)) {
        result.push_back({place(column, row), place(column - 1, row + 1)});
      }
    }
  }
  return result;
}

void draw_glyph(Image& image, char character, PixelPoint corner, double unit_px, Rgb color) {
  const std::vector<Segment> segments = strokes(font::glyph(character), corner, unit_px);
  const double width_px = std::max(kStrokeColumns * unit_px, 1.0);
  const auto columns = pixel_span(corner.u - 1.0, corner.u + font::kAdvance * unit_px + 1.0, 0, image.width_px());
  const auto rows = pixel_span(corner.v - 1.0, corner.v + font::kRows * unit_px + 1.0, 0, image.height_px());
  for (int row = rows[0]; row < rows[1]; ++row) {
    for (int column = columns[0]; column < columns[1]; ++column) {
      double share = 0.0;
      for (const Segment& segment : segments) {
        share = std::max(share, coverage(distance_px({column + 0.5, row + 0.5}, segment), width_px));
      }
      image.blend(column, row, color, share);
    }
  }
}

}  // namespace

void fill_box(Image& image, const PixelBox& box, Rgb color) {
  const PixelBox visible = inside(image, box);
  for (int row = visible.top; row < visible.bottom; ++row) {
    for (int column = visible.left; column < visible.right; ++column) {
      image.set(column, row, color);
    }
  }
}

void draw_line(Image& image, PixelPoint from, PixelPoint to, double width_px, Rgb color, const PixelBox& clip) {
  if (!is_finite(from) || !is_finite(to)) {
    return;
  }
  const PixelBox visible = inside(image, clip);
  const double reach = 0.5 * width_px + 1.0;
  const Segment segment{from, to};
  const auto rows =
      pixel_span(std::min(from.v, to.v) - reach, std::max(from.v, to.v) + reach, visible.top, visible.bottom);
  for (int row = rows[0]; row < rows[1]; ++row) {
    // Only the part of the line beside this row can reach it.
    double low = std::min(from.u, to.u);
    double high = std::max(from.u, to.u);
    const double dv = to.v - from.v;
    if (std::abs(dv) > 1e-9) {
      const double a = std::clamp((row + 0.5 - reach - from.v) / dv, 0.0, 1.0);
      const double b = std::clamp((row + 0.5 + reach - from.v) / dv, 0.0, 1.0);
      const double u_a = from.u + a * (to.u - from.u);
      const double u_b = from.u + b * (to.u - from.u);
      low = std::min(u_a, u_b);
      high = std::max(u_a, u_b);
    }
    const auto columns = pixel_span(low - reach, high + reach, visible.left, visible.right);
    for (int column = columns[0]; column < columns[1]; ++column) {
      image.blend(column, row, color, coverage(distance_px({column + 0.5, row + 0.5}, segment), width_px));
    }
  }
}

void draw_text(Image& image, PixelPoint place, std::string_view text, double size_px, TextAnchor anchor, Rgb color) {
  if (!is_finite(place) || !std::isfinite(size_px) || size_px <= 0.0) {
    return;
  }
  const double unit_px = size_px / font::kCapitalRows;
  const double width_px = text_width_px(text, size_px);
  double left = place.u;
  if (anchor == TextAnchor::center) {
    left -= 0.5 * width_px;
  } else if (anchor == TextAnchor::right) {
    left -= width_px;
  }
  for (std::size_t i = 0; i < text.size(); ++i) {
    const double u = left + static_cast<double>(i) * font::kAdvance * unit_px;
    draw_glyph(image, text[i], {u, place.v - 0.5 * size_px}, unit_px, color);
  }
}

double text_width_px(std::string_view text, double size_px) {
  if (text.empty()) {
    return 0.0;
  }
  const double columns = static_cast<double>(text.size()) * font::kAdvance - (font::kAdvance - font::kColumns);
  return columns * size_px / font::kCapitalRows;
}

}  // namespace berm
