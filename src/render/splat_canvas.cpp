#include "splat_canvas.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace berm {
namespace {

constexpr float kNothing = std::numeric_limits<float>::infinity();
/// However far it lies behind, a point keeps this share of its colour: labels stay readable.
constexpr double kDarkest = 0.45;

}  // namespace

SplatCanvas::SplatCanvas(const PixelBox& box)
    : box_(box),
      width_(std::max(box.width(), 0) * kFine),
      height_(std::max(box.height(), 0) * kFine),
      depth_(static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_), kNothing),
      color_(depth_.size()) {}

void SplatCanvas::add(PixelPoint place, double width_px, double height_px, float depth, Rgb color) {
  const double left = std::round((place.u - box_.left - 0.5 * width_px) * kFine);
  const double top = std::round((place.v - box_.top - 0.5 * height_px) * kFine);
  const double columns = std::max(std::round(width_px * kFine), 1.0);
  const double rows = std::max(std::round(height_px * kFine), 1.0);
  // Negated, so that NaN is outside.
  if (!(left < width_ && top < height_ && left + columns > 0.0 && top + rows > 0.0)) {
    return;
  }
  const int first_column = static_cast<int>(std::max(left, 0.0));
  const int last_column = static_cast<int>(std::min(left + columns, static_cast<double>(width_)));
  const int first_row = static_cast<int>(std::max(top, 0.0));
  const int last_row = static_cast<int>(std::min(top + rows, static_cast<double>(height_)));
  for (int row = first_row; row < last_row; ++row) {
    for (int column = first_column; column < last_column; ++column) {
      const std::size_t i = index(column, row);
      if (depth < depth_[i]) {
        depth_[i] = depth;
        color_[i] = color;
      }
    }
  }
}

void SplatCanvas::shade(double strength) {
  constexpr int kReach = 2;
  constexpr std::array<std::array<int, 2>, 4> kNeighbours = {{{-kReach, 0}, {kReach, 0}, {0, -kReach}, {0, kReach}}};
  for (int row = 0; row < height_; ++row) {
    for (int column = 0; column < width_; ++column) {
      const std::size_t i = index(column, row);
      if (depth_[i] == kNothing) {
        continue;
      }
      double behind = 0.0;
      for (const auto& [dc, dr] : kNeighbours) {
        const int c = column + dc;
        const int r = row + dr;
        if (c >= 0 && c < width_ && r >= 0 && r < height_) {
          behind += std::max(static_cast<double>(depth_[i]) - depth_[index(c, r)], 0.0);
        }
      }
      if (behind > 0.0) {
        const double kept = kDarkest + (1.0 - kDarkest) * std::exp(-strength * behind);
        color_[i] = mix({}, color_[i], kept);
      }
    }
  }
}

void SplatCanvas::lay_over(Image& image) const {
  constexpr int kAll = kFine * kFine;
  for (int row = 0; row < box_.height(); ++row) {
    for (int column = 0; column < box_.width(); ++column) {
      int painted = 0;
      int r = 0;
      int g = 0;
      int b = 0;
      for (int k = 0; k < kAll; ++k) {
        const std::size_t i = index(column * kFine + k % kFine, row * kFine + k / kFine);
        if (depth_[i] == kNothing) {
          continue;
        }
        ++painted;
        r += color_[i].r;
        g += color_[i].g;
        b += color_[i].b;
      }
      if (painted > 0) {
        const auto mean = [painted](int sum) { return static_cast<std::uint8_t>((sum + painted / 2) / painted); };
        image.blend(box_.left + column, box_.top + row, {mean(r), mean(g), mean(b)},
                    static_cast<double>(painted) / kAll);
      }
    }
  }
}

}  // namespace berm
