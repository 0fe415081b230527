#include "berm/render/draw_figure.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include <gtest/gtest.h>

#include "berm/core/error.hpp"

namespace berm {
namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

/// A scan over its firing order with everything that a figure shows.
struct MadeWaveform {
  std::vector<float> x, y, z, intensity, series_x, series_z;
  std::vector<Label> labels;
  std::vector<std::uint8_t> interpolated, steps;
  std::vector<PointRange> envelopes;

  explicit MadeWaveform(std::size_t n) : y(n, 1.0F), steps(n, 0) {
    for (std::size_t i = 0; i < n; ++i) {
      x.push_back(5.0F + static_cast<float>(i % 50) * 0.2F);
      z.push_back(-2.0F);
      intensity.push_back(150.0F);
      labels.push_back(Label::drivable);
    }
    series_x = x;
    series_z = z;
    interpolated.assign(n, 0);
  }

  [[nodiscard]] PointsView points() const {
    PointsView view;
    view.x = x;
    view.y = y;
    view.z = z;
    view.intensity = intensity;
    return view;
  }
  [[nodiscard]] Waveform view() const {
    return {.points = points(),
            .labels = labels,
            .series = {.x = series_x, .y = y, .z = series_z, .interpolated = interpolated},
            .steps = steps,
            .envelopes = envelopes};
  }
};

DrawOptions small() {
  return {.width_px = 800, .height_px = 600};
}

std::size_t count(const Image& image, Rgb color) {
  return static_cast<std::size_t>(std::count(image.pixels().begin(), image.pixels().end(), color));
}

/// Pixels in the upper or lower part, without the header.
std::size_t count_rows(const Image& image, Rgb color, int from, int to) {
  std::size_t found = 0;
  for (int row = from; row < to; ++row) {
    for (int column = 0; column < image.width_px(); ++column) {
      found += *image.find(column, row) == color ? 1U : 0U;
    }
  }
  return found;
}

Rgb color_of(Label label) {
  return label_color(label, Background::dark);
}

TEST(Histogram, FlakesStandOutFromTheRest) {
  MadeWaveform made(1000);
  const std::size_t without = count(draw_histogram(made.points(), made.labels, small()), color_of(Label::falling_snow));
  for (std::size_t i = 0; i < 200; ++i) {
    made.intensity[i] = 2.0F;
    made.labels[i] = Label::falling_snow;
  }
  const Image image = draw_histogram(made.points(), made.labels, small());
  EXPECT_GT(count(image, color_of(Label::falling_snow)), without + 300);
  EXPECT_GT(count(image, color_of(Label::drivable)), 300U);
  // Dark is on the left.
  std::size_t left = 0;
  for (int row = 100; row < 500; ++row) {
    for (int column = 0; column < 200; ++column) {
      left += *image.find(column, row) == color_of(Label::falling_snow) ? 1U : 0U;
    }
  }
  EXPECT_GT(left, 300U);
}

TEST(Histogram, AHigherBarForMore) {
  MadeWaveform made(1000);
  std::fill(made.intensity.begin(), made.intensity.begin() + 10, 50.0F);
  const Image image = draw_histogram(made.points(), {}, small());
  const auto height_at = [&image](int column) {
    std::size_t height = 0;
    for (int row = 90; row < 560; ++row) {
      height += *image.find(column, row) == color_of(Label::drivable) ? 1U : 0U;
    }
    return height;
  };
  std::vector<std::size_t> bars;
  for (int column = 100; column < 780; ++column) {
    bars.push_back(height_at(column));
  }
  const auto rare = *std::max_element(bars.begin(), bars.begin() + 200);
  const auto common = *std::max_element(bars.begin() + 200, bars.end());
  EXPECT_GT(rare, 20U);
  EXPECT_GT(common, rare + 50U);
}

TEST(Histogram, TakesNoReturnsAndNonsenseForNothing) {
  MadeWaveform made(100);
  for (std::size_t i = 0; i < 100; ++i) {
    made.intensity[i] = i % 3 == 0 ? kNan : (i % 3 == 1 ? 1e30F : -1e30F);
    made.x[i] = i % 2 == 0 ? 0.0F : kNan;
    made.y[i] = made.z[i] = 0.0F;
  }
  EXPECT_EQ(draw_histogram(made.points(), made.labels, small()).width_px(), 800);
}

TEST(Histogram, RefusesWhatItCannotDraw) {
  MadeWaveform made(10);
  EXPECT_THROW(static_cast<void>(draw_histogram(made.points(), std::vector<Label>(3), small())), Error);
  made.intensity.clear();
  EXPECT_THROW(static_cast<void>(draw_histogram(made.points(), made.labels, small())), Error);
  EXPECT_THROW(static_cast<void>(draw_histogram({}, {}, small())), Error);
}

TEST(WaveformFigure, ShowsLabelsInBothPanels) {
  MadeWaveform made(300);
  for (std::size_t i = 100; i < 150; ++i) {
    made.labels[i] = Label::obstacle;
  }
  const Image image = draw_waveform(made.view(), small());
  for (const Label label : {Label::drivable, Label::obstacle}) {
    EXPECT_GT(count_rows(image, color_of(label), 60, 300), 20U) << label_name(label);
    EXPECT_GT(count_rows(image, color_of(label), 330, 560), 20U) << label_name(label);
  }
  EXPECT_EQ(count(image, color_of(Label::falling_snow)), 0U);
}

TEST(WaveformFigure, MarksStepsAndEnvelopes) {
  const MadeWaveform plain(300);
  MadeWaveform marked(300);
  marked.envelopes = {{50, 99}};
  const Image before = draw_waveform(plain.view(), small());
  const Image after = draw_waveform(marked.view(), small());
  // A sixth of the width is shaded.
  std::size_t changed = 0;
  for (int column = 0; column < 800; ++column) {
    changed += *before.find(column, 150) != *after.find(column, 150) ? 1U : 0U;
  }
  EXPECT_NEAR(static_cast<double>(changed), 800.0 / 6.5, 20.0);
  MadeWaveform stepped(300);
  stepped.steps[120] = 1;
  const Image with_step = draw_waveform(stepped.view(), small());
  EXPECT_NE(std::vector<Rgb>(with_step.pixels().begin(), with_step.pixels().end()),
            std::vector<Rgb>(before.pixels().begin(), before.pixels().end()));
}

TEST(WaveformFigure, ShowsTheStretchThatIsAskedFor) {
  MadeWaveform made(1000);
  for (std::size_t i = 600; i < 700; ++i) {
    made.labels[i] = Label::obstacle;
  }
  Waveform view = made.view();
  view.first = 0;
  view.count = 500;
  EXPECT_EQ(count(draw_waveform(view, small()), color_of(Label::obstacle)), 0U);
  view.first = 600;
  view.count = 100;
  EXPECT_EQ(count_rows(draw_waveform(view, small()), color_of(Label::drivable), 60, 600), 0U);
  view.first = 999;
  view.count = 5000;
  EXPECT_EQ(draw_waveform(view, small()).height_px(), 600) << "one point";
}

TEST(WaveformFigure, DrawsWhatIsNoNumber) {
  MadeWaveform made(100);
  for (std::size_t i = 0; i < 100; i += 3) {
    made.x[i] = kNan;
    made.series_z[i] = kNan;
    made.z[i] = std::numeric_limits<float>::infinity();
  }
  EXPECT_EQ(draw_waveform(made.view(), small()).width_px(), 800);
  std::fill(made.series_x.begin(), made.series_x.end(), kNan);
  EXPECT_EQ(draw_waveform(made.view(), small()).width_px(), 800);
}

TEST(WaveformFigure, RefusesWhatItCannotDraw) {
  const MadeWaveform made(10);
  Waveform view = made.view();
  view.first = 10;
  EXPECT_THROW(static_cast<void>(draw_waveform(view, small())), Error);
  view = made.view();
  view.steps = std::span(made.steps).first(3);
  EXPECT_THROW(static_cast<void>(draw_waveform(view, small())), Error);
  view = made.view();
  view.series = {};
  EXPECT_THROW(static_cast<void>(draw_waveform(view, small())), Error);
  EXPECT_THROW(static_cast<void>(draw_waveform(made.view(), {.width_px = 1})), ConfigError);
}

TEST(Figures, AnySizeAndBackground) {
  const MadeWaveform made(200);
  for (const int side_px : {64, 65, 130, 700}) {
    for (const Background background : {Background::dark, Background::light}) {
      const DrawOptions options{.background = background, .width_px = side_px, .height_px = 64, .title = "a title"};
      EXPECT_EQ(draw_waveform(made.view(), options).width_px(), side_px);
      EXPECT_EQ(draw_histogram(made.points(), made.labels, options).width_px(), side_px);
    }
  }
}

TEST(DrawCurves, HigherValuesLieHigherAndGapsStayOpen) {
  const Rgb low_color{200, 10, 10};
  const Rgb high_color{10, 10, 200};
  const std::vector<Curve> curves = {
      {"low", low_color, {{0.0, 1.0}, {1.0, 1.0}, {2.0, std::nan("")}, {3.0, 1.0}, {4.0, 1.0}}},
      {"high", high_color, {{0.0, 5.0}, {3.9, 5.0}, {4.0, 10.0}}}};
  const DrawOptions options = small();
  const Image image = draw_curves(curves, {"time, s", "ms"}, options);
  // Lines have soft edges: what counts is which colour prevails.
  const auto rows_of = [&](bool is_red, int from, int to) {
    std::vector<int> rows;
    for (int row = 70; row < image.height_px(); ++row) {
      for (int column = from; column < to; ++column) {
        const Rgb& pixel = *image.find(column, row);
        const int redness = pixel.r - pixel.b;
        if (is_red ? redness > 60 : redness < -60) {
          rows.push_back(row);
        }
      }
    }
    return rows;
  };
  const auto low = rows_of(true, 100, 200);
  const auto high = rows_of(false, 100, 200);
  ASSERT_FALSE(low.empty());
  ASSERT_FALSE(high.empty());
  EXPECT_GT(*std::min_element(low.begin(), low.end()), *std::max_element(high.begin(), high.end()) + 100);
  EXPECT_TRUE(rows_of(true, 350, 500).empty()) << "nothing is known about 2 s";
  EXPECT_THROW(static_cast<void>(draw_curves({}, {"time, s", "ms"}, options)), Error);
}

}  // namespace
}  // namespace berm
