#include "berm/render/png.hpp"

#include <cstring>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <png.h>

#include "berm/core/error.hpp"

namespace berm {
namespace {

/// Noise of a linear congruential generator: the same everywhere, and nothing that compresses.
Image made_image(int width_px, int height_px) {
  Image image(width_px, height_px, {0, 0, 0});
  unsigned state = 1;
  for (int row = 0; row < height_px; ++row) {
    for (int column = 0; column < width_px; ++column) {
      state = state * 1664525U + 1013904223U;
      image.set(column, row,
                {static_cast<std::uint8_t>(state >> 24U), static_cast<std::uint8_t>(state >> 16U),
                 static_cast<std::uint8_t>(state >> 8U)});
    }
  }
  return image;
}

std::vector<Rgb> decode(const std::vector<std::byte>& bytes, int& width_px, int& height_px) {
  png_image description{};
  description.version = PNG_IMAGE_VERSION;
  EXPECT_NE(png_image_begin_read_from_memory(&description, bytes.data(), bytes.size()), 0) << description.message;
  EXPECT_EQ(description.format & PNG_FORMAT_FLAG_ALPHA, 0U);
  description.format = PNG_FORMAT_RGB;
  width_px = static_cast<int>(description.width);
  height_px = static_cast<int>(description.height);
  std::vector<Rgb> pixels(static_cast<std::size_t>(width_px) * static_cast<std::size_t>(height_px));
  EXPECT_NE(png_image_finish_read(&description, nullptr, pixels.data(), 0, nullptr), 0) << description.message;
  return pixels;
}

TEST(EncodePng, DecodesToTheSamePixels) {
  for (const auto& [width, height] : {std::pair{1, 1}, {1, 97}, {97, 1}, {3, 5}, {640, 480}}) {
    const Image image = made_image(width, height);
    int decoded_width = 0;
    int decoded_height = 0;
    const std::vector<Rgb> pixels = decode(encode_png(image), decoded_width, decoded_height);
    EXPECT_EQ(decoded_width, width);
    EXPECT_EQ(decoded_height, height);
    EXPECT_TRUE(std::equal(pixels.begin(), pixels.end(), image.pixels().begin(), image.pixels().end()))
        << width << " x " << height;
  }
}

TEST(EncodePng, GivesTheSameBytesTwiceAndNoTime) {
  const std::vector<std::byte> bytes = encode_png(made_image(200, 100));
  EXPECT_EQ(bytes, encode_png(made_image(200, 100)));
  const std::string text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  EXPECT_EQ(text.find("tIME"), std::string::npos);
  EXPECT_EQ(text.substr(1, 3), "PNG");
}

TEST(EncodePng, CompressesPlainPictures) {
  EXPECT_LT(encode_png(Image(1000, 1000, {9, 9, 9})).size(), 10'000U);
}

TEST(EncodePng, RefusesAPictureWithoutPixels) {
  EXPECT_THROW((void)encode_png(Image()), Error);
}

}  // namespace
}  // namespace berm
