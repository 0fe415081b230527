#include "berm/render/image.hpp"

#include <string>

#include "berm/core/error.hpp"

namespace berm {

Image::Image(int width_px, int height_px, Rgb color) : width_px_(width_px), height_px_(height_px) {
  if (width_px < 1 || width_px > kMaxSide_px || height_px < 1 || height_px > kMaxSide_px) {
    throw Error(ErrorCode::invalid_argument, "image: " + std::to_string(width_px) + " x " + std::to_string(height_px) +
                                                 " pixels, expected 1 to " + std::to_string(kMaxSide_px) +
                                                 " for both sides");
  }
  pixels_.assign(static_cast<std::size_t>(width_px) * static_cast<std::size_t>(height_px), color);
}

void Image::blend(int column, int row, Rgb color, double share) {
  if (contains(column, row)) {
    Rgb& pixel = pixels_[index(column, row)];
    pixel = mix(pixel, color, share);
  }
}

}  // namespace berm
