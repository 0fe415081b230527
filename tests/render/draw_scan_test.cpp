#include "berm/render/draw_scan.hpp"

#include <algorithm>
#include <array>
#include <cfloat>
#include <cmath>
#include <ctime>
#include <limits>
#include <optional>
#include <vector>

#include <gtest/gtest.h>

#include "berm/core/error.hpp"

namespace berm {
namespace {

constexpr float kNanPoint = std::numeric_limits<float>::quiet_NaN();
constexpr float kInf = std::numeric_limits<float>::infinity();
constexpr std::array kViews = {DrawView::top, DrawView::side, DrawView::front, DrawView::perspective};

/// Builds whose speed says nothing: unoptimised ones and those with sanitizers.
#if !defined(__OPTIMIZE__) || defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr bool kSlowBuild = true;
#elif defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer) || __has_feature(memory_sanitizer)
constexpr bool kSlowBuild = true;
#else
constexpr bool kSlowBuild = false;
#endif
#else
constexpr bool kSlowBuild = false;
#endif

struct Dot {
  float x, y, z;
  Label label = Label::obstacle;
  float intensity = 10.0F;
};

PointCloud cloud_of(const std::vector<Dot>& dots) {
  PointChannels channels;
  for (const Dot& dot : dots) {
    channels.x.push_back(dot.x);
    channels.y.push_back(dot.y);
    channels.z.push_back(dot.z);
    channels.intensity.push_back(dot.intensity);
    channels.label.push_back(dot.label);
  }
  return PointCloud(std::move(channels));
}

/// The points alone, 10 pixels a metre from above: x up from row 100, y to the left from column 100.
DrawOptions bare(DrawView view = DrawView::top) {
  return {.view = view, .width_px = 200, .height_px = 200, .range_m = 10.0, .point_size_px = 4.0, .frame = false};
}

Rgb label_color_of(Label label) {
  return label_color(label, Background::dark);
}

struct Spot {
  double column;
  double row;
  int pixels;
};

/// Middle of all pixels of exactly one colour.
std::optional<Spot> find_color(const Image& image, Rgb color) {
  Spot spot{0.0, 0.0, 0};
  for (int row = 0; row < image.height_px(); ++row) {
    for (int column = 0; column < image.width_px(); ++column) {
      if (*image.find(column, row) == color) {
        spot.column += column + 0.5;
        spot.row += row + 0.5;
        ++spot.pixels;
      }
    }
  }
  if (spot.pixels == 0) {
    return std::nullopt;
  }
  return Spot{spot.column / spot.pixels, spot.row / spot.pixels, spot.pixels};
}

bool same(const Image& a, const Image& b) {
  return std::equal(a.pixels().begin(), a.pixels().end(), b.pixels().begin(), b.pixels().end());
}

TEST(DrawScan, PutsPointsSeenFromAboveWhereTheyAre) {
  const PointCloud cloud = cloud_of({{5.0F, 0.0F, 1.0F, Label::drivable},
                                     {0.0F, 5.0F, 1.0F, Label::terrain},
                                     {-8.0F, -3.0F, 1.0F, Label::obstacle},
                                     {2.0F, 2.0F, 1.0F, Label::falling_snow}});
  const Image image = draw_scan(cloud.view(), {}, bare());
  EXPECT_EQ(*image.find(100, 50), label_color_of(Label::drivable)) << "ahead is up";
  EXPECT_EQ(*image.find(50, 100), label_color_of(Label::terrain)) << "left is left";
  EXPECT_EQ(*image.find(130, 180), label_color_of(Label::obstacle)) << "behind and right";
  EXPECT_EQ(*image.find(80, 80), label_color_of(Label::falling_snow));
  EXPECT_EQ(find_color(image, label_color_of(Label::drivable))->pixels, 16) << "4 x 4 pixels";
}

TEST(DrawScan, PutsPointsSeenFromTheSideWhereTheyAre) {
  const PointCloud cloud = cloud_of({{5.0F, 3.0F, 0.0F, Label::drivable}, {-5.0F, -3.0F, 2.0F, Label::obstacle}});
  const Image image = draw_scan(cloud.view(), {}, bare(DrawView::side));
  const auto ahead = find_color(image, label_color_of(Label::drivable));
  const auto behind = find_color(image, label_color_of(Label::obstacle));
  ASSERT_TRUE(ahead && behind);
  EXPECT_NEAR(ahead->column, 150.0, 1.0);
  EXPECT_NEAR(behind->column, 50.0, 1.0);
  EXPECT_LT(behind->row, ahead->row - 20.0) << "higher is up, and heights are exaggerated";
}

TEST(DrawScan, PutsPointsSeenFromTheSensorWhereTheyAre) {
  const PointCloud cloud = cloud_of({{10.0F, 5.0F, 0.0F, Label::drivable},
                                     {10.0F, -5.0F, 0.0F, Label::obstacle},
                                     {10.0F, 0.0F, 3.0F, Label::terrain}});
  const Image image = draw_scan(cloud.view(), {}, bare(DrawView::front));
  const auto left = find_color(image, label_color_of(Label::drivable));
  const auto right = find_color(image, label_color_of(Label::obstacle));
  const auto above = find_color(image, label_color_of(Label::terrain));
  ASSERT_TRUE(left && right && above);
  EXPECT_LT(left->column, above->column);
  EXPECT_LT(above->column, right->column);
  EXPECT_LT(above->row, left->row);
}

TEST(DrawScan, PutsWhatIsLookedAtInTheMiddle) {
  DrawOptions options = bare(DrawView::perspective);
  options.eye_m = {-10.0, 2.0, 5.0};
  options.target_m = {7.0, -1.0, 0.5};
  const PointCloud cloud =
      cloud_of({{7.0F, -1.0F, 0.5F, Label::drivable}, {7.0F, 3.0F, 0.5F, Label::terrain}, {-30.0F, 0.0F, 0.0F}});
  const Image image = draw_scan(cloud.view(), {}, options);
  EXPECT_EQ(*image.find(100, 100), label_color_of(Label::drivable));
  EXPECT_LT(find_color(image, label_color_of(Label::terrain))->column, 80.0);
  EXPECT_FALSE(find_color(image, label_color_of(Label::obstacle))) << "what is behind the eye is not seen";
}

TEST(DrawScan, LooksStraightDown) {
  DrawOptions options = bare(DrawView::perspective);
  options.eye_m = {0.0, 0.0, 20.0};
  options.target_m = {0.0, 0.0, 0.0};
  const Image image = draw_scan(
      cloud_of({{4.0F, 0.0F, 0.0F, Label::drivable}, {0.0F, 4.0F, 0.0F, Label::terrain}}).view(), {}, options);
  const auto ahead = find_color(image, label_color_of(Label::drivable));
  const auto left = find_color(image, label_color_of(Label::terrain));
  ASSERT_TRUE(ahead && left);
  EXPECT_LT(ahead->row, 80.0);
  EXPECT_LT(left->column, 80.0);
}

TEST(DrawScan, ShowsTheNearestPointInAnyOrder) {
  struct Pair {
    DrawView view;
    Dot nearer;
    Dot farther;
  };
  const std::array pairs = {
      Pair{DrawView::top, {5.0F, 0.0F, 3.0F, Label::obstacle}, {5.0F, 0.0F, 0.0F, Label::drivable}},
      Pair{DrawView::side, {5.0F, -2.0F, 1.0F, Label::obstacle}, {5.0F, 2.0F, 1.0F, Label::drivable}},
      Pair{DrawView::front, {4.0F, 1.0F, 0.4F, Label::obstacle}, {8.0F, 2.0F, 0.8F, Label::drivable}},
      Pair{DrawView::perspective, {-1.0F, 0.0F, 4.5F, Label::obstacle}, {12.0F, 0.0F, 0.0F, Label::drivable}}};
  for (const Pair& pair : pairs) {
    for (const auto& dots : {std::vector{pair.nearer, pair.farther}, std::vector{pair.farther, pair.nearer}}) {
      const Image image = draw_scan(cloud_of(dots).view(), {}, bare(pair.view));
      EXPECT_TRUE(find_color(image, label_color_of(Label::obstacle))) << static_cast<int>(pair.view);
      EXPECT_FALSE(find_color(image, label_color_of(Label::drivable))) << static_cast<int>(pair.view);
    }
  }
}

TEST(DrawScan, AppliesTheMount) {
  DrawOptions options = bare();
  options.T_base_sensor = Pose::from_yaw_pitch_roll(1.5707963267948966, 0.0, 0.0, {1.0, 0.0, 2.0});
  const Image image = draw_scan(cloud_of({{5.0F, 0.0F, 0.0F, Label::drivable}}).view(), {}, options);
  EXPECT_EQ(*image.find(50, 90), label_color_of(Label::drivable)) << "ahead of the sensor is left of the machine";
}

TEST(DrawScan, PrefersTheLabelsThatItIsGiven) {
  const PointCloud cloud = cloud_of({{5.0F, 0.0F, 1.0F, Label::drivable}});
  const std::vector<Label> labels = {Label::terrain};
  EXPECT_EQ(*draw_scan(cloud.view(), labels, bare()).find(100, 50), label_color_of(Label::terrain));
  EXPECT_EQ(*draw_scan(cloud.view(), {}, bare()).find(100, 50), label_color_of(Label::drivable));
  PointsView without = cloud.view();
  without.label = {};
  EXPECT_EQ(*draw_scan(without, {}, bare()).find(100, 50), label_color_of(Label::unlabeled));
}

TEST(DrawScan, ColoursByIntensityAndHeight) {
  DrawOptions options = bare();
  const PointCloud cloud = cloud_of({{5.0F, 0.0F, 0.0F, Label::drivable, 100.0F},
                                     {0.0F, 5.0F, 1.0F, Label::drivable, 0.0F},
                                     {-5.0F, 0.0F, 2.0F, Label::drivable, 50.0F}});
  options.color = DrawColor::height;
  const Image by_height = draw_scan(cloud.view(), {}, options);
  EXPECT_EQ(*by_height.find(100, 50), scale_color(0.0, Background::dark));
  EXPECT_EQ(*by_height.find(50, 100), scale_color(0.5, Background::dark));
  EXPECT_EQ(*by_height.find(100, 150), scale_color(1.0, Background::dark));
  options.color = DrawColor::intensity;
  const Image by_intensity = draw_scan(cloud.view(), {}, options);
  EXPECT_EQ(*by_intensity.find(100, 50), scale_color(1.0, Background::dark));
  EXPECT_EQ(*by_intensity.find(50, 100), scale_color(0.0, Background::dark));
  PointsView without = cloud.view();
  without.intensity = {};
  EXPECT_TRUE(same(draw_scan(without, {}, options), by_height)) << "without intensities by height";
}

TEST(DrawScan, LeavesOutWhatHasNoPlace) {
  const std::vector<Dot> good = {{5.0F, 0.0F, 1.0F, Label::drivable}, {1.0F, 2.0F, 1.0F}};
  std::vector<Dot> all = good;
  for (const float odd : {kNanPoint, kInf, -kInf, FLT_MAX, -FLT_MAX, 2e4F}) {
    all.push_back({odd, 0.0F, 0.0F});
    all.push_back({0.0F, odd, 1.0F});
    all.push_back({1.0F, 1.0F, odd});
    all.push_back({odd, odd, odd});
  }
  all.push_back({0.0F, 0.0F, 0.0F});
  for (const DrawView view : kViews) {
    EXPECT_TRUE(
        same(draw_scan(cloud_of(all).view(), {}, bare(view)), draw_scan(cloud_of(good).view(), {}, bare(view))));
    DrawOptions framed{.view = view};
    EXPECT_FALSE(same(draw_scan(cloud_of(all).view(), {}, framed), draw_scan(cloud_of(good).view(), {}, framed)))
        << "but the legend counts them";
  }
}

TEST(DrawScan, DrawsOddCloudsInEveryView) {
  const std::array<std::vector<Dot>, 8> clouds = {
      std::vector<Dot>{},
      {{1.0F, 2.0F, 3.0F}},
      std::vector<Dot>(100, {1.0F, 2.0F, 3.0F}),
      std::vector<Dot>(100, {0.0F, 0.0F, 0.0F}),
      std::vector<Dot>(100, {kNanPoint, kNanPoint, kNanPoint}),
      std::vector<Dot>(100, {kInf, kInf, kInf}),
      std::vector<Dot>(100, {FLT_MAX, -FLT_MAX, FLT_MAX}),
      {{1.0F, 0.0F, 0.0F}, {2.0F, 0.0F, 0.0F}, {3.0F, 0.0F, 0.0F}, {FLT_MIN, FLT_MIN, FLT_MIN}}};
  for (const auto& dots : clouds) {
    for (const DrawView view : kViews) {
      for (const DrawColor color : {DrawColor::label, DrawColor::intensity, DrawColor::height}) {
        const Image image =
            draw_scan(cloud_of(dots).view(), {}, {.view = view, .color = color, .width_px = 320, .height_px = 240});
        EXPECT_EQ(image.width_px(), 320);
        EXPECT_EQ(image.height_px(), 240);
      }
    }
  }
}

TEST(DrawScan, HasRoomForItsFrameInEverySize) {
  const PointCloud cloud = cloud_of({{5.0F, 0.0F, 1.0F, Label::drivable}, {-3.0F, 2.0F, 0.0F, Label::terrain}});
  for (const auto& [width, height] : {std::pair{64, 64}, {64, 1000}, {1000, 64}, {200, 150}, {2400, 1500}}) {
    for (const DrawView view : kViews) {
      const Image image = draw_scan(
          cloud.view(), {}, {.view = view, .width_px = width, .height_px = height, .title = "A title that is long"});
      EXPECT_EQ(image.width_px(), width);
    }
  }
}

TEST(DrawScan, NamesItsClassesInTheLegend) {
  const PointCloud cloud = cloud_of({{5.0F, 0.0F, 1.0F, Label::drivable}, {-3.0F, 2.0F, 0.0F, Label::drivable}});
  const Image image = draw_scan(cloud.view(), {}, {});
  const int header_px = 60;
  int swatch = 0;
  int other = 0;
  for (int row = 0; row < header_px; ++row) {
    for (int column = 0; column < image.width_px(); ++column) {
      swatch += *image.find(column, row) == label_color_of(Label::drivable) ? 1 : 0;
      other += *image.find(column, row) == label_color_of(Label::obstacle) ? 1 : 0;
    }
  }
  EXPECT_GE(swatch, 100);
  EXPECT_EQ(other, 0) << "what does not occur is not named";
}

TEST(DrawScan, GivesTheSamePictureTwice) {
  std::vector<Dot> dots;
  for (int i = 0; i < 5000; ++i) {
    const auto f = static_cast<float>(i);
    dots.push_back({30.0F * std::sin(f), 20.0F * std::cos(1.7F * f), std::sin(0.3F * f), static_cast<Label>(i % 6),
                    std::fmod(f, 256.0F)});
  }
  const PointCloud cloud = cloud_of(dots);
  for (const DrawView view : kViews) {
    EXPECT_TRUE(same(draw_scan(cloud.view(), {}, {.view = view}), draw_scan(cloud.view(), {}, {.view = view})));
  }
}

TEST(DrawScan, ShadesOnlyWhatLiesBehindAnEdge) {
  DrawOptions options = bare();
  const PointCloud alone = cloud_of({{5.0F, 0.0F, 0.0F, Label::drivable}});
  const Image lit = draw_scan(alone.view(), {}, options);
  options.shading = false;
  EXPECT_TRUE(same(lit, draw_scan(alone.view(), {}, options)));
  const PointCloud wall = cloud_of({{5.0F, 0.0F, 0.0F, Label::drivable}, {5.3F, 0.0F, 8.0F, Label::obstacle}});
  const Image flat = draw_scan(wall.view(), {}, options);
  options.shading = true;
  const Image shaded = draw_scan(wall.view(), {}, options);
  EXPECT_FALSE(same(flat, shaded));
  EXPECT_EQ(find_color(flat, label_color_of(Label::obstacle))->pixels,
            find_color(shaded, label_color_of(Label::obstacle))->pixels);
  EXPECT_LT(find_color(shaded, label_color_of(Label::drivable))->pixels,
            find_color(flat, label_color_of(Label::drivable))->pixels);
}

TEST(DrawScan, DrawsAMillionPointsInASecond) {
  PointChannels channels;
  for (int i = 0; i < 1'000'000; ++i) {
    const float range_m = 5.0F + 60.0F * static_cast<float>(i % 997) / 997.0F;
    const float azimuth = 6.2831853F * static_cast<float>(i) / 1'000'000.0F;
    channels.x.push_back(range_m * std::cos(azimuth));
    channels.y.push_back(range_m * std::sin(azimuth));
    channels.z.push_back(0.1F * static_cast<float>(i % 31));
    channels.label.push_back(static_cast<Label>(i % 6));
  }
  const PointCloud cloud(std::move(channels));
  for (const DrawView view : kViews) {
    const std::clock_t start = std::clock();
    const Image image = draw_scan(cloud.view(), {}, {.view = view});
    const double seconds = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
    EXPECT_TRUE(find_color(image, label_color_of(Label::drivable)));
    EXPECT_LT(seconds, kSlowBuild ? 60.0 : 1.0) << static_cast<int>(view);
  }
}

TEST(DrawScan, RefusesLengthsThatDoNotMatch) {
  const PointCloud cloud = cloud_of({{1.0F, 1.0F, 1.0F}, {2.0F, 1.0F, 1.0F}});
  const std::vector<Label> one(1);
  EXPECT_THROW((void)draw_scan(cloud.view(), one, {}), Error);
  EXPECT_THROW((void)draw_scan({}, one, {}), Error);
  PointsView broken = cloud.view();
  broken.z = broken.z.first(1);
  EXPECT_THROW((void)draw_scan(broken, {}, {}), Error);
}

TEST(DrawOptions, AreChecked) {
  const auto refused = [](const DrawOptions& options) {
    try {
      options.check();
    } catch (const ConfigError& error) {
      return error.key();
    }
    return std::string();
  };
  constexpr double kNotANumber = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(refused({}), "");
  EXPECT_EQ(refused({.width_px = 63}), "draw.width_px");
  EXPECT_EQ(refused({.width_px = Image::kMaxSide_px + 1}), "draw.width_px");
  EXPECT_EQ(refused({.height_px = -1}), "draw.height_px");
  EXPECT_EQ(refused({.range_m = -1.0}), "draw.range_m");
  EXPECT_EQ(refused({.range_m = kNotANumber}), "draw.range_m");
  EXPECT_EQ(refused({.point_size_px = 1e9}), "draw.point_size_px");
  EXPECT_EQ(refused({.eye_m = {kNotANumber, 0.0, 0.0}}), "draw.eye_m");
  EXPECT_EQ(refused({.target_m = {0.0, 0.0, 1e9}}), "draw.target_m");
  EXPECT_EQ(refused({.eye_m = {1.0, 1.0, 1.0}, .target_m = {1.0, 1.0, 1.0}}), "draw.target_m");
  EXPECT_EQ(refused({.field_of_view_rad = 0.0}), "draw.field_of_view_rad");
  EXPECT_EQ(refused({.field_of_view_rad = 3.2}), "draw.field_of_view_rad");
  EXPECT_EQ(refused({.T_base_sensor = {Eigen::Quaterniond::Identity(), {0.0, kNotANumber, 0.0}}}),
            "draw.T_base_sensor");
}

TEST(DrawClasses, TakesClassesOfTheCaller) {
  const PointCloud cloud = cloud_of({{5.0F, 0.0F, 1.0F}, {0.0F, 5.0F, 1.0F}, {-5.0F, 0.0F, 1.0F}});
  const std::vector<PointClass> classes = {{"right", {1, 2, 3}}, {"wrong", {200, 10, 20}}};
  const std::vector<std::uint8_t> class_of_point = {0, 1, 7};
  const Image image = draw_classes(cloud.view(), class_of_point, classes, bare());
  EXPECT_EQ(*image.find(100, 50), (Rgb{1, 2, 3}));
  EXPECT_EQ(*image.find(50, 100), (Rgb{200, 10, 20}));
  EXPECT_EQ(*image.find(100, 150), *image.find(0, 0)) << "an index beyond the classes is not drawn";
  EXPECT_THROW((void)draw_classes(cloud.view(), std::vector<std::uint8_t>{0}, classes, bare()), Error);
  EXPECT_THROW((void)draw_classes(cloud.view(), class_of_point, std::vector<PointClass>(251), bare()), Error);
}

TEST(DrawScan, LinesLieOverThePointsAndInTheLegendOnce) {
  const Rgb white{255, 255, 255};
  DrawOptions options = bare();
  options.lines = {{"edge", white, {{2.0, 3.0, 0.0}, {8.0, 3.0, 0.0}}}, {"edge", white, {{2.0, -3.0, 0.0}}}};
  const PointCloud cloud = cloud_of({{5.0F, 3.0F, 0.0F}});
  const Image image = draw_scan(cloud.view(), {}, options);
  // y = 3 is 30 pixels left of the middle, x = 2..8 is 20 to 80 pixels above it.
  const auto brightness = [&image](int column, int row) { return static_cast<int>(image.find(column, row)->b); };
  EXPECT_GT(brightness(70, 50), 200) << "over the point";
  EXPECT_GT(brightness(70, 75), 200);
  EXPECT_LT(brightness(70, 90), 100);
  EXPECT_LT(brightness(130, 80), 100) << "a line needs two vertices";
  options.lines[0].vertices_m.push_back({kNanPoint, 0.0, 0.0});
  EXPECT_EQ(draw_scan(cloud.view(), {}, options).width_px(), 200);
}

TEST(DrawScan, LookingAheadLeavesOutWhatIsBehind) {
  DrawOptions options = bare();
  options.ahead = true;
  const PointCloud cloud = cloud_of({{9.0F, 0.0F, 0.0F}, {-9.0F, 0.0F, 0.0F, Label::terrain}});
  for (const DrawView view : {DrawView::top, DrawView::side}) {
    options.view = view;
    options.width_px = 200;
    options.height_px = 100;
    const Image image = draw_scan(cloud.view(), {}, options);
    const auto has = [&image](Rgb color) {
      return std::find(image.pixels().begin(), image.pixels().end(), color) != image.pixels().end();
    };
    EXPECT_TRUE(has(label_color_of(Label::obstacle)));
    EXPECT_FALSE(has(label_color_of(Label::terrain)));
  }
}

}  // namespace
}  // namespace berm
