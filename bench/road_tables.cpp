#include "road_tables.hpp"

#include <algorithm>
#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <fmt/core.h>

namespace berm::bench {
namespace {

constexpr double kLeastF1 = 95.0;
constexpr double kMostMedian_m = 0.12;
constexpr double kMostP95_m = 0.35;
constexpr double kMostWrongSide = 0.5;
constexpr double kMostHeightError_m = 0.15;
constexpr double kMostDetect_ms = 3.0;  // for a scan of so many points
constexpr double kPointsOfBar = 28'800.0;
constexpr double kMostMap_ms = 4.0;

double percent(const std::optional<double>& share) {
  return 100.0 * share.value_or(0.0);
}

std::string text(const std::optional<double>& value) {
  return value ? fmt::format("{:.3f}", *value) : "";
}

std::string score_cells(const RoadScore& score) {
  return fmt::format("{:6.2f} | {:9.2f} | {:6.2f} | {:9} | {:6} | {:7.2f} | {:9}", percent(score.lines.f1),
                     percent(score.lines.precision), percent(score.lines.recall), text(score.lines.lateral_median_m),
                     text(score.lines.lateral_p95_m), percent(score.lines.wrong_side_share),
                     text(score.height_error_m));
}

using Value = std::function<double(const RoadScore&)>;

double mean(std::span<const RoadResult> results, std::size_t method, const Value& value) {
  double sum = 0.0;
  for (const RoadResult& result : results) {
    sum += value(result.scores[method]) / static_cast<double>(results.size());
  }
  return sum;
}

/// The worst road of the first method, and whether it holds.
bool print_bar(const std::string& what, std::span<const RoadResult> results, double bar, bool at_least, int digits,
               const std::string& unit, const std::function<double(const RoadResult&)>& value) {
  double sum = 0.0;
  const RoadResult* worst = &results.front();
  std::string missed;
  for (const RoadResult& result : results) {
    sum += value(result) / static_cast<double>(results.size());
    worst = (value(result) < value(*worst)) == at_least ? &result : worst;
    if (value(result) < bar ? at_least : value(result) > bar && !at_least) {
      missed += (missed.empty() ? "" : ", ") + result.name;
    }
  }
  const bool holds = at_least ? sum >= bar : sum <= bar;
  fmt::print("- {}: mean {:.{}f} {}, worst {:.{}f} ({}), {} {:.{}f} asked for: {}{}\n", what, sum, digits, unit,
             value(*worst), digits, worst->name, at_least ? "at least" : "at most", bar, digits,
             holds ? "holds in the mean" : "**missed**", missed.empty() ? "" : "; not on: " + missed);
  return holds;
}

}  // namespace

void print_roads(std::span<const RoadMethod> methods, std::span<const RoadResult> results) {
  fmt::print(
      "Of the lines, at places 0.25 m apart: F1, precision and recall in % at 0.5 m, recall of the truth within 25 m "
      "of "
      "the path;\nmedian and 95th percentile of the distance to the truth, of those within 0.5 m; share of these on "
      "the "
      "wrong side. Height:\nmedian error of the berm's at the vertices of the lines. CPU time a scan "
      "on "
      "one core, medians.\n\n");
  fmt::print(
      "| road | seed | m | points a scan | method | F1 | precision | recall | median, m | p95, m | side, % | height, m "
      "| "
      "edges, ms | map, ms | lines, ms "
      "|\n|:---|---:|---:|---:|:---|---:|---:|---:|---:|---:|---:|---:|---:|---:|---:|\n");
  for (std::size_t m = 0; m < std::min<std::size_t>(methods.size(), 2); ++m) {
    for (const RoadResult& result : results) {
      fmt::print("| {:<22} | {:4} | {:.0f} | {:6.0f} | {:<9} | {} | {:.2f} | {:.2f} | {:.0f} |\n", result.name,
                 result.seed, result.length_m, result.points_a_scan,
                 m == 1 && methods[m].is_reference ? "reference" : methods[m].name, score_cells(result.scores[m]),
                 result.scores[m].detect_ms, result.scores[m].map_ms, result.scores[m].lines_ms);
    }
  }
  fmt::print("\n");
}

bool print_bars(std::span<const RoadResult> results) {
  bool holds = print_bar("F1", results, kLeastF1, true, 2, "%",
                         [](const RoadResult& r) { return percent(r.scores[0].lines.f1); });
  holds &= print_bar("Lateral error, median", results, kMostMedian_m, false, 3, "m",
                     [](const RoadResult& r) { return r.scores[0].lines.lateral_median_m.value_or(0.0); });
  holds &= print_bar("Lateral error, p95", results, kMostP95_m, false, 3, "m",
                     [](const RoadResult& r) { return r.scores[0].lines.lateral_p95_m.value_or(0.0); });
  holds &= print_bar("Wrong side", results, kMostWrongSide, false, 2, "%",
                     [](const RoadResult& r) { return percent(r.scores[0].lines.wrong_side_share); });
  holds &= print_bar("Height of the berm", results, kMostHeightError_m, false, 3, "m",
                     [](const RoadResult& r) { return r.scores[0].height_error_m.value_or(0.0); });
  holds &= print_bar("Edges, a scan of 28,800 points", results, kMostDetect_ms, false, 2, "ms",
                     [](const RoadResult& r) { return r.scores[0].detect_ms * kPointsOfBar / r.points_a_scan; });
  holds &= print_bar("Map, a scan", results, kMostMap_ms, false, 2, "ms",
                     [](const RoadResult& r) { return r.scores[0].map_ms; });
  fmt::print("\n");
  return holds;
}

void print_methods(std::span<const RoadMethod> methods, std::span<const RoadResult> results) {
  fmt::print("## Every step switched off in turn, and other settings\n\nMeans over these roads.\n\n");
  fmt::print(
      "| method | F1 | against default | precision | recall | median, m | p95, m | side, % | edges, ms |\n"
      "|:---|---:|---:|---:|---:|---:|---:|---:|---:|\n");
  const auto f1 = [](const RoadScore& s) { return percent(s.lines.f1); };
  for (std::size_t m = 0; m < methods.size(); ++m) {
    fmt::print("| {:<26} | {:6.2f} | {:+6.2f} | {:6.2f} | {:6.2f} | {:.3f} | {:.3f} | {:5.2f} | {:.2f} |\n",
               methods[m].name, mean(results, m, f1), mean(results, m, f1) - mean(results, 0, f1),
               mean(results, m, [](const RoadScore& s) { return percent(s.lines.precision); }),
               mean(results, m, [](const RoadScore& s) { return percent(s.lines.recall); }),
               mean(results, m, [](const RoadScore& s) { return s.lines.lateral_median_m.value_or(0.0); }),
               mean(results, m, [](const RoadScore& s) { return s.lines.lateral_p95_m.value_or(0.0); }),
               mean(results, m, [](const RoadScore& s) { return percent(s.lines.wrong_side_share); }),
               mean(results, m, [](const RoadScore& s) { return s.detect_ms; }));
  }
  fmt::print("\n");
}

}  // namespace berm::bench
