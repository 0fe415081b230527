#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "berm/render/color.hpp"

namespace berm {

/// A picture in memory, 8 bits RGB, rows from the top. Looking outside gives nothing, drawing outside does nothing.
class Image {
 public:
  /// Largest width and height, in pixels.
  static constexpr int kMaxSide_px = 16384;

  Image() = default;
  /// Filled with `color`. Throws Error(invalid_argument) unless both sides are 1..kMaxSide_px.
  Image(int width_px, int height_px, Rgb color);

  [[nodiscard]] int width_px() const { return width_px_; }
  [[nodiscard]] int height_px() const { return height_px_; }
  [[nodiscard]] bool contains(int column, int row) const {
    return column >= 0 && column < width_px_ && row >= 0 && row < height_px_;
  }

  /// The pixel, or null outside. Column 0 is left, row 0 is on top.
  [[nodiscard]] const Rgb* find(int column, int row) const {
    return contains(column, row) ? &pixels_[index(column, row)] : nullptr;
  }
  /// Sets a pixel; does nothing outside.
  void set(int column, int row, Rgb color) {
    if (contains(column, row)) {
      pixels_[index(column, row)] = color;
    }
  }
  /// Lays `share` (0..1) of `color` over a pixel; does nothing outside.
  void blend(int column, int row, Rgb color, double share);

  /// All pixels, row by row from the top.
  [[nodiscard]] std::span<const Rgb> pixels() const { return pixels_; }

 private:
  [[nodiscard]] std::size_t index(int column, int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(width_px_) + static_cast<std::size_t>(column);
  }

  int width_px_ = 0;
  int height_px_ = 0;
  std::vector<Rgb> pixels_;
};

}  // namespace berm
