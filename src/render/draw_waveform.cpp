#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "berm/core/error.hpp"
#include "berm/render/draw_figure.hpp"
#include "chart.hpp"
#include "ticks.hpp"

namespace berm {
namespace {

constexpr std::array kWaveformLabels = {Label::drivable, Label::terrain, Label::obstacle, Label::falling_snow,
                                        Label::unlabeled};

/// One coordinate of the points, levelled.
struct Track {
  std::string title;
  std::vector<double> raw;     ///< NaN for beams that met nothing
  std::vector<double> series;  ///< gaps closed
};

struct Stretch {
  std::size_t first;
  std::size_t end;
};

void check(const Waveform& waveform) {
  const std::size_t n = waveform.points.size();
  const bool same = waveform.points.y.size() == n && waveform.points.z.size() == n &&
                    (waveform.labels.empty() || waveform.labels.size() == n) &&
                    (waveform.steps.empty() || waveform.steps.size() == n) && waveform.series.x.size() == n &&
                    waveform.series.y.size() == n && waveform.series.z.size() == n &&
                    waveform.series.interpolated.size() == n;
  if (!same) {
    throw Error(ErrorCode::invalid_argument, "draw: points, labels, series and steps differ in length");
  }
  if (waveform.first >= n) {
    throw Error(ErrorCode::invalid_argument, "draw: the stretch begins at point " + std::to_string(waveform.first) +
                                                 ", the scan has " + std::to_string(n));
  }
}

Stretch stretch_of(const Waveform& waveform) {
  const std::size_t rest = waveform.points.size() - waveform.first;
  return {waveform.first, waveform.first + (waveform.count == 0 ? rest : std::min(waveform.count, rest))};
}

/// Row `axis` of the levelled points.
Track track_of(const Waveform& waveform, const Stretch& stretch, const DrawOptions& options, int axis,
               std::string title) {
  Track track{.title = std::move(title), .raw = {}, .series = {}};
  const auto level = [&](float x, float y, float z) {
    return (options.T_base_sensor * Eigen::Vector3d(x, y, z))[axis];
  };
  const PointsView& p = waveform.points;
  const SeriesView& s = waveform.series;
  for (std::size_t i = stretch.first; i < stretch.end; ++i) {
    const bool met = !is_no_return(p.x[i], p.y[i], p.z[i]);
    track.raw.push_back(met ? level(p.x[i], p.y[i], p.z[i]) : std::nan(""));
    track.series.push_back(level(s.x[i], s.y[i], s.z[i]));
  }
  return track;
}

/// What most of the series keeps within, and a little more.
ChartAxis axis_of(const Track& track) {
  std::vector<double> sorted;
  std::copy_if(track.series.begin(), track.series.end(), std::back_inserter(sorted),
               [](double value) { return std::isfinite(value); });
  if (sorted.empty()) {
    return {-1.0, 1.0, track.title};
  }
  std::sort(sorted.begin(), sorted.end());
  const auto stray = static_cast<std::size_t>(0.003 * static_cast<double>(sorted.size()));
  const double low = sorted[stray];
  const double high = sorted[sorted.size() - 1 - stray];
  const double margin = std::max(0.12 * (high - low), 0.2);
  return {low - margin, high + 1.5 * margin, track.title};
}

std::vector<LegendEntry> legend_of(const Waveform& waveform, const Stretch& stretch, const DrawOptions& options,
                                   Rgb envelope) {
  const FrameColors colors = frame_colors(options.background);
  std::vector<LegendEntry> entries;
  std::size_t made_up = 0;
  std::size_t steps = 0;
  std::array<std::size_t, 256> counts{};
  for (std::size_t i = stretch.first; i < stretch.end; ++i) {
    made_up += waveform.series.interpolated[i] != 0 ? 1U : 0U;
    steps += !waveform.steps.empty() && waveform.steps[i] != 0 ? 1U : 0U;
    counts[waveform.labels.empty() ? 0U : static_cast<std::size_t>(waveform.labels[i])] += 1;
  }
  for (const Label label : kWaveformLabels) {
    const std::size_t count = counts[static_cast<std::size_t>(label)];
    if (count > 0 && !waveform.labels.empty()) {
      entries.push_back({label_name(label) + (" " + count_text(count)), label_color(label, options.background)});
    }
  }
  entries.push_back({"repaired " + count_text(made_up), mix(colors.ground, colors.text, 0.75)});
  if (!waveform.steps.empty()) {
    entries.push_back({"step " + count_text(steps), colors.text});
  }
  if (!waveform.envelopes.empty()) {
    entries.push_back({"envelope", envelope});
  }
  return entries;
}

class WaveformPainter {
 public:
  WaveformPainter(Image& image, const Waveform& waveform, const Stretch& stretch, const DrawOptions& options,
                  Rgb envelope)
      : image_(image),
        waveform_(waveform),
        stretch_(stretch),
        options_(options),
        colors_(frame_colors(options.background)),
        unit_px_(FrameSizes(options).unit_px),
        envelope_(envelope) {}

  void paint(const Track& track, const PixelBox& box, bool last) const {
    const Chart chart(
        image_, options_, box,
        {static_cast<double>(stretch_.first), static_cast<double>(stretch_.end - 1) + 1e-9, "point in firing order"},
        axis_of(track));
    for (const PointRange& range : waveform_.envelopes) {
      if (range.last >= stretch_.first && range.first < stretch_.end) {
        chart.fill_stretch(static_cast<double>(range.first), static_cast<double>(range.last), envelope_);
      }
    }
    chart.draw_grid();
    paint_series(chart, track);
    paint_points(chart, track);
    chart.draw_axes(last);
  }

 private:
  [[nodiscard]] PixelPoint place(const Chart& chart, std::size_t k, double value) const {
    return chart.pixel(static_cast<double>(stretch_.first + k), value);
  }

  void paint_series(const Chart& chart, const Track& track) const {
    const Rgb plain = mix(colors_.ground, colors_.text, 0.35);
    const Rgb made_up = mix(colors_.ground, colors_.text, 0.75);
    for (std::size_t k = 1; k < track.series.size(); ++k) {
      const bool repaired = waveform_.series.interpolated[stretch_.first + k] != 0 ||
                            waveform_.series.interpolated[stretch_.first + k - 1] != 0;
      chart.draw_line(place(chart, k - 1, track.series[k - 1]), place(chart, k, track.series[k]),
                      (repaired ? 1.6 : 1.0) * unit_px_, repaired ? made_up : plain);
    }
  }

  void paint_points(const Chart& chart, const Track& track) const {
    // Never so large that neighbours hide each other's colour.
    const double spacing_px = static_cast<double>(chart.box().width()) / static_cast<double>(track.raw.size());
    const double size_px = std::clamp(2.0 * spacing_px, 2.0 * unit_px_, 6.0 * unit_px_);
    for (std::size_t k = 0; k < track.raw.size(); ++k) {
      const std::size_t i = stretch_.first + k;
      if (!std::isfinite(track.raw[k])) {
        continue;
      }
      const Label label = waveform_.labels.empty() ? Label::unlabeled : waveform_.labels[i];
      const PixelPoint at = place(chart, k, track.raw[k]);
      if (!waveform_.steps.empty() && waveform_.steps[i] != 0) {
        chart.draw_dot(at, size_px + 4.0 * unit_px_, colors_.text);
      }
      chart.draw_dot(at, size_px, label_color(label, options_.background));
    }
  }

  Image& image_;
  const Waveform& waveform_;
  Stretch stretch_;
  const DrawOptions& options_;
  FrameColors colors_;
  double unit_px_;
  Rgb envelope_;
};

}  // namespace

Image draw_waveform(const Waveform& waveform, const DrawOptions& options) {
  options.check();
  check(waveform);
  const Stretch stretch = stretch_of(waveform);
  const FrameColors colors = frame_colors(options.background);
  const Rgb envelope = mix(colors.ground, label_color(Label::obstacle, options.background), 0.28);
  Image image(options.width_px, options.height_px, colors.ground);
  const int header = draw_header(image, options, legend_of(waveform, stretch, options, envelope), nullptr);
  const double unit_px = FrameSizes(options).unit_px;
  const int left = static_cast<int>(Chart::left_margin_px(options));
  const int right = options.width_px - static_cast<int>(24.0 * unit_px);
  const int bottom = options.height_px - static_cast<int>(Chart::bottom_margin_px(options));
  const int gap = static_cast<int>(18.0 * unit_px);
  const int middle = (header + bottom) / 2;
  if (right - left < 16 || bottom - header < 2 * gap + 32) {
    return image;
  }
  const WaveformPainter painter(image, waveform, stretch, options, envelope);
  painter.paint(track_of(waveform, stretch, options, 0, "x, m"), {left, header, right, middle - gap / 2}, false);
  painter.paint(track_of(waveform, stretch, options, 2, "z, m"), {left, middle + gap / 2, right, bottom}, true);
  return image;
}

}  // namespace berm
