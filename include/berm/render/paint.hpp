#pragma once

#include <cstdint>
#include <string_view>

#include "berm/render/image.hpp"

namespace berm {

/// Place in a picture: u to the right, v down, in pixels. A pixel is one unit wide; (0.5, 0.5) is the middle of the
/// one in the left upper corner.
struct PixelPoint {
  double u = 0.0;
  double v = 0.0;
};

/// A rectangle of whole pixels: `right` and `bottom` are no longer part of it.
struct PixelBox {
  int left = 0;
  int top = 0;
  int right = 0;
  int bottom = 0;

  [[nodiscard]] int width() const { return right - left; }
  [[nodiscard]] int height() const { return bottom - top; }
};

/// Which part of a text lies at the place that is given for it.
enum class TextAnchor : std::uint8_t { left, center, right };

/// Fills what of `box` lies inside the picture.
void fill_box(Image& image, const PixelBox& box, Rgb color);

/// A straight stroke with round ends and soft edges. What is outside of `clip` is left out; so is everything if a
/// coordinate is not finite.
void draw_line(Image& image, PixelPoint from, PixelPoint to, double width_px, Rgb color, const PixelBox& clip);

/// Writes one line of ASCII; other characters appear as '?'. `place` is where the text is anchored across and its
/// middle (of a capital letter) in height. `size_px` is the height of a capital letter.
void draw_text(Image& image, PixelPoint place, std::string_view text, double size_px, TextAnchor anchor, Rgb color);

/// Width of `text` as `draw_text` writes it.
[[nodiscard]] double text_width_px(std::string_view text, double size_px);

}  // namespace berm
