#include "berm/render/png.hpp"

#include <string>

#include <png.h>

#include "berm/core/error.hpp"

namespace berm {

static_assert(sizeof(Rgb) == 3, "libpng reads the pixels as packed triples");

std::vector<std::byte> encode_png(const Image& image) {
  if (image.pixels().empty()) {
    throw Error(ErrorCode::invalid_argument, "png: the image has no pixels");
  }
  png_image description{};
  description.version = PNG_IMAGE_VERSION;
  description.width = static_cast<png_uint_32>(image.width_px());
  description.height = static_cast<png_uint_32>(image.height_px());
  description.format = PNG_FORMAT_RGB;

  // The largest size that the picture can need: asking libpng for the true one would compress everything twice.
  png_alloc_size_t size = PNG_IMAGE_PNG_SIZE_MAX(description);
  std::vector<std::byte> bytes(size);
  const int written =
      png_image_write_to_memory(&description, bytes.data(), &size, 0, image.pixels().data(), 0, nullptr);
  if (written == 0) {
    const std::string reason = description.message;
    png_image_free(&description);
    throw Error(ErrorCode::invalid_argument, "png: " + reason);
  }
  bytes.resize(size);
  bytes.shrink_to_fit();
  return bytes;
}

}  // namespace berm
