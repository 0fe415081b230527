#pragma once

#include <cstddef>
#include <vector>

#include "berm/render/image.hpp"
#include "berm/render/paint.hpp"

namespace berm {

/// Points as little rectangles with a depth, finer than the picture by kFine in both directions, so that laying them
/// into it smooths their edges.
class SplatCanvas {
 public:
  /// Subpixels of a pixel in each direction.
  static constexpr int kFine = 2;

  explicit SplatCanvas(const PixelBox& box);

  /// Paints a rectangle around `place` (pixels of the whole picture) unless something at least as near is there.
  void add(PixelPoint place, double width_px, double height_px, float depth, Rgb color);

  /// Darkens what lies behind the edge of something nearer, by `strength` for each unit of depth between them.
  void shade(double strength);

  /// Lays all that was painted over `image`, at the box of the constructor.
  void lay_over(Image& image) const;

 private:
  [[nodiscard]] std::size_t index(int column, int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(column);
  }

  PixelBox box_;
  int width_;
  int height_;
  std::vector<float> depth_;  ///< infinite where nothing was painted
  std::vector<Rgb> color_;
};

}  // namespace berm
