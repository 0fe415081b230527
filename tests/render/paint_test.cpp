#include "berm/render/paint.hpp"

#include <limits>
#include <set>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace berm {
namespace {

constexpr Rgb kBlack{0, 0, 0};
constexpr Rgb kWhitePaint{255, 255, 255};
constexpr double kNanPixel = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfPixel = std::numeric_limits<double>::infinity();

Image canvas() {
  return Image(100, 60, kBlack);
}

/// The smallest box around all that is not black; empty without.
PixelBox painted(const Image& image) {
  PixelBox box{image.width_px(), image.height_px(), 0, 0};
  for (int row = 0; row < image.height_px(); ++row) {
    for (int column = 0; column < image.width_px(); ++column) {
      if (*image.find(column, row) != kBlack) {
        box = {std::min(box.left, column), std::min(box.top, row), std::max(box.right, column + 1),
               std::max(box.bottom, row + 1)};
      }
    }
  }
  return box.left < box.right ? box : PixelBox{};
}

std::vector<Rgb> pixels(const Image& image) {
  return {image.pixels().begin(), image.pixels().end()};
}

PixelBox everything(const Image& image) {
  return {0, 0, image.width_px(), image.height_px()};
}

TEST(FillBox, FillsWhatIsInside) {
  Image image = canvas();
  fill_box(image, {10, 20, 30, 25}, kWhitePaint);
  const PixelBox box = painted(image);
  EXPECT_EQ(box.left, 10);
  EXPECT_EQ(box.top, 20);
  EXPECT_EQ(box.right, 30);
  EXPECT_EQ(box.bottom, 25);
  constexpr int kMax = std::numeric_limits<int>::max();
  constexpr int kMin = std::numeric_limits<int>::min();
  fill_box(image, {kMin, kMin, kMax, kMax}, kWhitePaint);
  EXPECT_EQ(painted(image).width(), 100);
  EXPECT_EQ(painted(image).height(), 60);
}

TEST(FillBox, DoesNothingForBoxesInsideOut) {
  Image image = canvas();
  fill_box(image, {30, 25, 10, 20}, kWhitePaint);
  EXPECT_EQ(painted(image).width(), 0);
}

TEST(DrawLine, CoversItsPixelsFully) {
  Image image = canvas();
  draw_line(image, {10.0, 30.5}, {90.0, 30.5}, 1.0, kWhitePaint, everything(image));
  EXPECT_EQ(*image.find(50, 30), kWhitePaint);
  EXPECT_EQ(*image.find(50, 28), kBlack);
  EXPECT_EQ(*image.find(50, 32), kBlack);
  EXPECT_EQ(*image.find(5, 30), kBlack);
  Image steep = canvas();
  draw_line(steep, {50.5, 5.0}, {50.5, 55.0}, 3.0, kWhitePaint, everything(steep));
  EXPECT_EQ(*steep.find(49, 20), kWhitePaint);
  EXPECT_EQ(*steep.find(51, 40), kWhitePaint);
  EXPECT_EQ(*steep.find(53, 40), kBlack);
}

TEST(DrawLine, IsTheSameFromBothEnds) {
  Image there = canvas();
  Image back = canvas();
  draw_line(there, {3.2, 4.1}, {88.0, 51.7}, 2.5, kWhitePaint, everything(there));
  draw_line(back, {88.0, 51.7}, {3.2, 4.1}, 2.5, kWhitePaint, everything(back));
  int different = 0;
  for (std::size_t i = 0; i < there.pixels().size(); ++i) {
    different += std::abs(there.pixels()[i].r - back.pixels()[i].r) > 1 ? 1 : 0;
  }
  EXPECT_EQ(different, 0);
}

TEST(DrawLine, StaysInsideItsClip) {
  Image image = canvas();
  draw_line(image, {-1e6, -1e6}, {1e6, 1e6}, 8.0, kWhitePaint, {20, 10, 40, 45});
  const PixelBox box = painted(image);
  EXPECT_GE(box.left, 20);
  EXPECT_GE(box.top, 10);
  EXPECT_LE(box.right, 40);
  EXPECT_LE(box.bottom, 45);
  EXPECT_GT(box.width(), 10);
}

TEST(DrawLine, LeavesOutWhatIsNoNumber) {
  Image image = canvas();
  for (const double odd : {kNanPixel, kInfPixel, -kInfPixel}) {
    draw_line(image, {odd, 1.0}, {50.0, 50.0}, 1.0, kWhitePaint, everything(image));
    draw_line(image, {1.0, 1.0}, {50.0, odd}, 1.0, kWhitePaint, everything(image));
  }
  EXPECT_EQ(painted(image).width(), 0);
}

TEST(DrawText, HasAGlyphOfItsOwnForEveryCharacter) {
  std::set<std::string> glyphs;
  for (char c = '!'; c <= '~'; ++c) {
    Image image(16, 24, kBlack);
    draw_text(image, {2.0, 10.0}, std::string(1, c), 14.0, TextAnchor::left, kWhitePaint);
    EXPECT_GT(painted(image).width(), 0) << c;
    std::string content;
    for (const Rgb pixel : image.pixels()) {
      content.push_back(static_cast<char>(pixel.r));
    }
    // O and 0 differ by their place in a word only, as in many fonts.
    EXPECT_TRUE(glyphs.insert(content).second || c == 'O') << c;
  }
}

TEST(DrawText, DrawsAQuestionMarkForWhatItDoesNotKnow) {
  Image question = canvas();
  draw_text(question, {5.0, 20.0}, "??", 14.0, TextAnchor::left, kWhitePaint);
  Image unknown = canvas();
  draw_text(unknown, {5.0, 20.0}, "\xc3\xa4", 14.0, TextAnchor::left, kWhitePaint);
  EXPECT_EQ(pixels(question), pixels(unknown));
  Image space = canvas();
  draw_text(space, {5.0, 20.0}, "  ", 14.0, TextAnchor::left, kWhitePaint);
  EXPECT_EQ(painted(space).width(), 0);
}

TEST(DrawText, LiesWhereItIsAnchored) {
  const std::string text = "HHHH";
  const double width = text_width_px(text, 14.0);
  Image left = canvas();
  Image center = canvas();
  Image right = canvas();
  draw_text(left, {30.0, 30.0}, text, 14.0, TextAnchor::left, kWhitePaint);
  draw_text(center, {50.0, 30.0}, text, 14.0, TextAnchor::center, kWhitePaint);
  draw_text(right, {80.0, 30.0}, text, 14.0, TextAnchor::right, kWhitePaint);
  EXPECT_NEAR(painted(left).left, 30, 1);
  EXPECT_NEAR(painted(left).right, 30 + width, 1.5);
  EXPECT_NEAR(0.5 * (painted(center).left + painted(center).right), 50, 1);
  EXPECT_NEAR(painted(right).right, 80, 1.5);
  EXPECT_NEAR(painted(left).height(), 14, 2);
  EXPECT_NEAR(0.5 * (painted(left).top + painted(left).bottom), 30, 1);
}

TEST(DrawText, DoesNothingWhereItCannot) {
  Image image = canvas();
  draw_text(image, {kNanPixel, 10.0}, "text", 14.0, TextAnchor::left, kWhitePaint);
  draw_text(image, {10.0, kInfPixel}, "text", 14.0, TextAnchor::left, kWhitePaint);
  draw_text(image, {10.0, 10.0}, "text", 0.0, TextAnchor::left, kWhitePaint);
  draw_text(image, {10.0, 10.0}, "text", kNanPixel, TextAnchor::left, kWhitePaint);
  draw_text(image, {10.0, 10.0}, "", 14.0, TextAnchor::left, kWhitePaint);
  draw_text(image, {1e9, -1e9}, "text", 14.0, TextAnchor::left, kWhitePaint);
  EXPECT_EQ(painted(image).width(), 0);
  EXPECT_EQ(text_width_px("", 14.0), 0.0);
}

}  // namespace
}  // namespace berm
