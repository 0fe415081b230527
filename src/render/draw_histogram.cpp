#include <algorithm>
#include <array>
#include <cmath>

#include "berm/core/error.hpp"
#include "berm/render/draw_figure.hpp"
#include "chart.hpp"
#include "ticks.hpp"

namespace berm {
namespace {

constexpr std::size_t kBins = 256;
/// The scale begins below one point, so that a single one shows.
constexpr double kLowest = 0.7;

struct Counts {
  std::array<std::size_t, kBins> all{};
  std::array<std::size_t, kBins> flakes{};
  std::size_t returns = 0;
  std::size_t falling = 0;
};

Counts count(const PointsView& points, std::span<const Label> labels) {
  Counts counts;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const float intensity = points.intensity[i];
    if (is_no_return(points.x[i], points.y[i], points.z[i]) || !std::isfinite(intensity)) {
      continue;
    }
    const auto bin = static_cast<std::size_t>(std::clamp(intensity, 0.0F, static_cast<float>(kBins - 1)));
    const bool flake = !labels.empty() && labels[i] == Label::falling_snow;
    ++counts.all[bin];
    ++counts.returns;
    counts.flakes[bin] += flake ? 1U : 0U;
    counts.falling += flake ? 1U : 0U;
  }
  return counts;
}

}  // namespace

Image draw_histogram(const PointsView& points, std::span<const Label> labels, const DrawOptions& options) {
  options.check();
  if (points.intensity.size() != points.size() || points.empty()) {
    throw Error(ErrorCode::invalid_argument, "draw: a histogram needs points with intensity, the scan has none");
  }
  if (!labels.empty() && labels.size() != points.size()) {
    throw Error(ErrorCode::invalid_argument, "draw: the labels differ in number from the points");
  }
  const Counts counts = count(points, labels);
  const FrameColors colors = frame_colors(options.background);
  const Rgb snow = label_color(Label::falling_snow, options.background);
  const Rgb rest = label_color(Label::drivable, options.background);

  Image image(options.width_px, options.height_px, colors.ground);
  const int header = draw_header(image, options,
                                 {{"falling snow " + count_text(counts.falling), snow},
                                  {"other returns " + count_text(counts.returns - counts.falling), rest}},
                                 nullptr);
  const double unit_px = FrameSizes(options).unit_px;
  const PixelBox box{static_cast<int>(Chart::left_margin_px(options)), header,
                     options.width_px - static_cast<int>(24.0 * unit_px),
                     options.height_px - static_cast<int>(Chart::bottom_margin_px(options))};
  if (box.width() < 16 || box.height() < 16) {
    return image;
  }
  const auto highest = static_cast<double>(*std::max_element(counts.all.begin(), counts.all.end()));
  const Chart chart(image, options, box, {0.0, static_cast<double>(kBins), "intensity"},
                    {kLowest, std::max(10.0, 1.5 * highest), "returns", true});
  chart.draw_grid();
  for (std::size_t bin = 0; bin < kBins; ++bin) {
    const auto fill = [&](std::size_t number, Rgb color) {
      if (number == 0) {
        return;
      }
      const auto place = static_cast<double>(bin);
      const PixelPoint top = chart.pixel(place, static_cast<double>(number));
      const int left = static_cast<int>(std::lround(top.u));
      const int right = static_cast<int>(std::lround(chart.pixel(place + 1.0, 1.0).u));
      const int gap = right - left > 3 ? 1 : 0;
      fill_box(image, {left, static_cast<int>(std::lround(top.v)), std::max(right - gap, left + 1), box.bottom}, color);
    };
    // On a logarithmic scale parts do not add up: what is seen of the upper bar is what the flakes add.
    fill(counts.all[bin], counts.flakes[bin] > 0 ? snow : rest);
    fill(counts.all[bin] - counts.flakes[bin], rest);
  }
  chart.draw_axes(true);
  return image;
}

}  // namespace berm
