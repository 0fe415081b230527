#include "piste_tables.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include <fmt/core.h>

namespace berm::bench {
namespace {

// What issue and paper ask for: P's own figure of its recordings as the mean.
constexpr double kLeastMean_percent = 98.54;
constexpr double kLeastRun_percent = 96.0;
constexpr double kLeastSnowF1_percent = 97.0;
constexpr double kMost_ms = 0.4;  // snow and piste, per 10,000 points

constexpr const char* kLegend =
    "Accuracy (P eq. 13), precision and recall of the piste in %, over all returns but flakes; F1 of falling snow in "
    "%.\nBaseline: every ground point of the default ground is piste, behind the default snow stage. Reference: snow "
    "and piste as\npublished, ground of the default. Snow bare: what is nearer than 17 m with a reflectivity of at "
    "most "
    "4 is a flake.\nSlope: of the machine in the run, nose up. Flakes: beams that came back off one.";

using Row = std::vector<std::string>;

/// A table of Markdown that can be read as it is, too.
void print_table(const std::vector<Row>& rows) {
  std::vector<std::size_t> widths(rows.front().size());
  for (const Row& row : rows) {
    for (std::size_t i = 0; i < row.size(); ++i) {
      widths[i] = std::max(widths[i], row[i].size());
    }
  }
  std::string rule = "|";
  for (std::size_t i = 0; i < widths.size(); ++i) {
    rule += i == 0 ? ":" + std::string(widths[i] + 1, '-') + "|" : std::string(widths[i] + 1, '-') + ":|";
  }
  for (const Row& row : rows) {
    fmt::print("| {:<{}} |", row[0], widths[0]);
    for (std::size_t i = 1; i < widths.size(); ++i) {
      fmt::print(" {:>{}} |", row[i], widths[i]);
    }
    fmt::print("{}", &row == &rows.front() ? "\n" + rule + "\n" : "\n");
  }
  fmt::print("\n");
}

std::string number(double value) {
  return fmt::format("{:.2f}", value);
}

std::string number(std::optional<double> value) {
  return value ? number(*value) : "";
}

/// A share of 0..1 in percent.
std::string percent(std::optional<double> share) {
  return share ? number(100.0 * *share) : "";
}

Row row_of(const RunResult& result) {
  const BinaryMetrics metrics = derive_metrics(result.scores[kDefault].piste);
  return {result.run.plan.name,
          std::to_string(result.run.plan.seed),
          fmt::format("{:.0f} .. {:.0f}", result.min_slope_deg, result.max_slope_deg),
          fmt::format("{:.1f}", 100.0 * static_cast<double>(result.on_flakes) / static_cast<double>(result.beams)),
          number(accuracy_percent(result, kBaseline)),
          number(accuracy_percent(result, kReference)),
          number(accuracy_percent(result, kDefault)),
          percent(metrics.precision),
          percent(metrics.recall),
          number(snow_f1_percent(result.bare_rule)),
          number(snow_f1_percent(result.scores[kReference].snow)),
          number(snow_f1_percent(result.scores[kDefault].snow))};
}

Row summary_row(const std::string& name, std::span<const RunResult> results, double Spread::*figure) {
  Row row(12);
  row[0] = name;
  for (const std::size_t method : {kBaseline, kReference, kDefault}) {
    row[4 + method] = number(spread_of(results, method).*figure);
  }
  return row;
}

bool print_bar(const std::string& what, double value, double least) {
  const bool holds = value >= least;
  fmt::print("- {}: {:.2f} %, at least {:.2f} % asked for: {}\n", what, value, least,
             holds ? "holds" : "**does not hold**");
  return holds;
}

/// The runs of one class of snowfall together.
bool print_snow_bars(std::span<const RunResult> results) {
  bool all_hold = true;
  std::vector<std::string> classes;
  for (const RunResult& result : results) {
    const std::string& flakes = result.run.flakes;
    if (flakes.empty() || std::find(classes.begin(), classes.end(), flakes) != classes.end()) {
      continue;
    }
    classes.push_back(flakes);
    BinaryCounts counts;
    for (const RunResult& other : results) {
      if (other.run.flakes == flakes) {
        counts += other.scores[kDefault].snow;
      }
    }
    all_hold &= print_bar("F1 of falling snow, " + flakes, snow_f1_percent(counts).value_or(0.0), kLeastSnowF1_percent);
  }
  return all_hold;
}

double false_marks_percent(std::span<const RunResult> results) {
  BinaryCounts counts;
  for (const RunResult& result : results) {
    if (result.on_flakes == 0) {
      counts += result.scores[kDefault].snow;
    }
  }
  const std::uint64_t judged = std::max<std::uint64_t>(counts.judged(), 1);
  return 100.0 * static_cast<double>(counts.false_positive) / static_cast<double>(judged);
}

void print_where_below(std::span<const RunResult> results, std::size_t other, const std::string& name) {
  std::string runs;
  for (const RunResult& result : results) {
    const double lost = accuracy_percent(result, other) - accuracy_percent(result, kDefault);
    if (lost > 0.0) {
      runs += fmt::format("{}{} (by {:.2f} %)", runs.empty() ? "" : ", ", result.run.plan.name, lost);
    }
  }
  fmt::print("- Runs in which the default is below the {}: {}\n", name, runs.empty() ? "none" : "**" + runs + "**");
}

std::string difference(double value, double from) {
  return fmt::format("{:+.2f}", value - from);
}

}  // namespace

void print_runs(std::span<const RunResult> results) {
  fmt::print("{}\n\n", kLegend);
  std::vector<Row> rows = {{"run", "seed", "slope, deg", "flakes, %", "baseline", "reference", "default", "precision",
                            "recall", "snow bare", "snow ref.", "snow default"}};
  for (const RunResult& result : results) {
    rows.push_back(row_of(result));
  }
  rows.push_back(summary_row("mean", results, &Spread::mean_percent));
  rows.push_back(summary_row("minimum", results, &Spread::min_percent));
  print_table(rows);
}

bool print_bars(std::span<const RunResult> results) {
  const Spread spread = spread_of(results, kDefault);
  bool holds = print_bar("Mean accuracy", spread.mean_percent, kLeastMean_percent);
  holds &= print_bar("Worst run, " + spread.worst_run, spread.min_percent, kLeastRun_percent);
  holds &= print_snow_bars(results);
  print_where_below(results, kBaseline, "baseline");
  print_where_below(results, kReference, "reference");
  fmt::print("- Returns marked as flakes in clear air: {:.4f} %\n", false_marks_percent(results));
  return holds;
}

void print_methods(std::span<const test::Method> methods, std::span<const RunResult> results,
                   std::span<const StageTimes> times) {
  const Spread whole = spread_of(results, kDefault);
  std::vector<Row> rows = {{"method", "mean", "against default", "minimum", "in run", "piste, ms", "snow, ms"}};
  for (std::size_t i = 0; i < methods.size(); ++i) {
    const Spread spread = spread_of(results, i);
    rows.push_back({methods[i].name, number(spread.mean_percent), difference(spread.mean_percent, whole.mean_percent),
                    number(spread.min_percent), spread.worst_run,
                    times[i].piste_ms > 0.0 ? fmt::format("{:.3f}", times[i].piste_ms) : "",
                    times[i].snow_ms > 0.0 ? fmt::format("{:.3f}", times[i].snow_ms) : ""});
  }
  print_table(rows);
  const double whole_ms = times[kDefault].snow_ms + times[kDefault].piste_ms;
  fmt::print("- Snow and piste, default: {:.3f} ms, at most {:.1f} ms asked for on an idle core: {}\n", whole_ms,
             kMost_ms, whole_ms <= kMost_ms ? "holds" : "**does not hold**");
  fmt::print("- Snow and piste, reference: {:.3f} ms\n\n", times[kReference].snow_ms + times[kReference].piste_ms);
}

void print_sensors(std::span<const RunResult> results, std::size_t runs_each) {
  std::vector<Row> rows = {
      {"sensor", "points a scan", "baseline", "reference", "default", "minimum", "in run", "snow default, 12 %"}};
  for (std::size_t first = 0; first < results.size(); first += runs_each) {
    const std::span<const RunResult> own = results.subspan(first, runs_each);
    BinaryCounts snow;
    for (const RunResult& result : own) {
      snow += result.run.flakes.empty() ? BinaryCounts{} : result.scores[kDefault].snow;
    }
    const Spread spread = spread_of(own, kDefault);
    rows.push_back({own[0].run.plan.sensor, std::to_string(own[0].samples.at(0).truth.size()),
                    number(spread_of(own, kBaseline).mean_percent), number(spread_of(own, kReference).mean_percent),
                    number(spread.mean_percent), number(spread.min_percent), spread.worst_run,
                    number(snow_f1_percent(snow))});
  }
  print_table(rows);
  for (const RunResult& result : results) {
    for (const auto& [method, name] : {std::pair(kBaseline, "baseline"), std::pair(kReference, "reference")}) {
      const double lost = accuracy_percent(result, method) - accuracy_percent(result, kDefault);
      if (lost > 0.0) {
        fmt::print("- **Default below the {}**: {}, {} (by {:.2f} %)\n", name, result.run.plan.sensor,
                   result.run.plan.name, lost);
      }
    }
  }
}

void print_keys(std::span<const VariedKey> keys, std::span<const RunResult> results, std::size_t first) {
  const Spread whole = spread_of(results, kDefault);
  std::vector<Row> rows = {{"key", "value", "halved: mean", "minimum", "in run", "doubled: mean", "minimum", "in run"}};
  for (std::size_t i = 0; i < keys.size(); ++i) {
    const Spread halved = spread_of(results, first + 2 * i);
    const Spread doubled = spread_of(results, first + 2 * i + 1);
    rows.push_back({keys[i].key, fmt::format("{:g}", keys[i].value),
                    difference(halved.mean_percent, whole.mean_percent), number(halved.min_percent), halved.worst_run,
                    difference(doubled.mean_percent, whole.mean_percent), number(doubled.min_percent),
                    doubled.worst_run});
  }
  print_table(rows);
}

}  // namespace berm::bench
