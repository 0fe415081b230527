#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "piste_runs.hpp"
#include "support/chain_score.hpp"

namespace berm::bench {

/// What a run says of each method.
struct RunResult {
  PisteRun run;  ///< with the seed that was used
  double min_slope_deg = 0.0;
  double max_slope_deg = 0.0;
  std::uint64_t beams = 0;
  std::uint64_t on_flakes = 0;              ///< beams that came back off a flake
  BinaryCounts bare_rule;                   ///< of snow: near and dark is a flake
  std::vector<test::Score> scores;          ///< one per method
  std::vector<test::LabelledScan> samples;  ///< every 50th scan, to measure time with
};

/// Simulates the runs and takes them through the methods, `threads` runs at a time. A seed that gives no route that
/// can be driven is replaced by one 100 above.
[[nodiscard]] std::vector<RunResult> measure_runs(const std::vector<PisteRun>& runs,
                                                  const std::vector<test::Method>& methods, std::size_t threads);

[[nodiscard]] double accuracy_percent(const RunResult& result, std::size_t method);

/// Accuracy of a method over the runs, each of which counts the same.
struct Spread {
  double mean_percent = 0.0;
  double min_percent = 100.0;
  std::string worst_run;
};
[[nodiscard]] Spread spread_of(std::span<const RunResult> results, std::size_t method);

/// F1 in percent of falling snow; none without flakes in truth.
[[nodiscard]] std::optional<double> snow_f1_percent(const BinaryCounts& counts);

}  // namespace berm::bench
