#include "berm/render/image.hpp"

#include <limits>

#include <gtest/gtest.h>

#include "berm/core/error.hpp"

namespace berm {
namespace {

constexpr Rgb kWhite{255, 255, 255};
constexpr Rgb kRed{255, 0, 0};

TEST(Image, StartsWithOneColour) {
  const Image image(3, 2, kRed);
  EXPECT_EQ(image.width_px(), 3);
  EXPECT_EQ(image.height_px(), 2);
  ASSERT_EQ(image.pixels().size(), 6U);
  for (const Rgb pixel : image.pixels()) {
    EXPECT_EQ(pixel, kRed);
  }
}

TEST(Image, HasRowsFromTheTop) {
  Image image(3, 2, kWhite);
  image.set(2, 1, kRed);
  EXPECT_EQ(image.pixels()[5], kRed);
  EXPECT_EQ(*image.find(2, 1), kRed);
  image.blend(0, 0, {0, 0, 0}, 0.5);
  EXPECT_EQ(*image.find(0, 0), (Rgb{128, 128, 128}));
}

TEST(Image, IgnoresWhatIsOutside) {
  Image image(3, 2, kWhite);
  constexpr int kMax = std::numeric_limits<int>::max();
  constexpr int kMin = std::numeric_limits<int>::min();
  for (const auto& [column, row] : {std::pair{-1, 0}, {0, -1}, {3, 0}, {0, 2}, {kMax, kMax}, {kMin, kMin}}) {
    image.set(column, row, kRed);
    image.blend(column, row, kRed, 1.0);
    EXPECT_EQ(image.find(column, row), nullptr);
  }
  for (const Rgb pixel : image.pixels()) {
    EXPECT_EQ(pixel, kWhite);
  }
}

TEST(Image, RefusesSidesThatMakeNoPicture) {
  EXPECT_THROW(Image(0, 5, kRed), Error);
  EXPECT_THROW(Image(5, 0, kRed), Error);
  EXPECT_THROW(Image(-1, 5, kRed), Error);
  EXPECT_THROW(Image(Image::kMaxSide_px + 1, 1, kRed), Error);
  EXPECT_THROW(Image(1, std::numeric_limits<int>::max(), kRed), Error);
  EXPECT_NO_THROW(Image(Image::kMaxSide_px, 1, kRed));
}

TEST(Image, IsEmptyByDefault) {
  const Image image;
  EXPECT_TRUE(image.pixels().empty());
  EXPECT_EQ(image.find(0, 0), nullptr);
}

}  // namespace
}  // namespace berm
