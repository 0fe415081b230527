#include "piste_measure.hpp"

#include <algorithm>

#include "berm/core/error.hpp"
#include "berm/core/ordered_parallel.hpp"
#include "berm/io/label_file.hpp"

namespace berm::bench {
namespace {

constexpr std::uint32_t kFallingSnow = 110;
constexpr std::size_t kSampleEvery = 50;
// Nearer than 17 m as in SnowClear; P's bound of the reflectivity, since the flakes of its sensor are not quite black.
constexpr float kBareRange_m = 17.0F;
constexpr float kBareIntensity = 4.0F;

constexpr int kSeedsTried = 5;
constexpr std::uint64_t kSeedStep = 100;

test::SimulatedRun simulate(test::RunPlan& plan) {
  for (int attempt = 1;; ++attempt) {
    try {
      return test::simulate_run(plan, {.scenarios = BERM_SCENARIOS, .sensors = BERM_SENSORS});
    } catch (const Error& error) {
      if (error.code() != ErrorCode::invalid_argument || attempt == kSeedsTried) {
        throw;
      }
      plan.seed += kSeedStep;
    }
  }
}

BinaryCounts judge_bare_rule(const test::LabelledScan& scan) {
  const PointsView points = scan.scan.cloud.view();
  std::vector<std::uint32_t> output(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    const float square = points.x[i] * points.x[i] + points.y[i] * points.y[i] + points.z[i] * points.z[i];
    const bool is_flake = square < kBareRange_m * kBareRange_m && points.intensity[i] <= kBareIntensity;
    output[i] = is_flake ? kFallingSnow : 0;
  }
  return judge_snow(output, scan.truth, test::find_returns(points));
}

RunResult measure_run(const PisteRun& run, const std::vector<test::Method>& methods) {
  RunResult result;
  result.run = run;
  const test::SimulatedRun made = simulate(result.run.plan);
  result.min_slope_deg = made.min_slope_deg;
  result.max_slope_deg = made.max_slope_deg;
  for (const test::LabelledScan& scan : made.scans) {
    result.beams += scan.truth.size();
    result.on_flakes +=
        static_cast<std::uint64_t>(std::count_if(scan.truth.begin(), scan.truth.end(), [](std::uint32_t label) {
          return semantic_class(label) == kFallingSnow;
        }));
    result.bare_rule += judge_bare_rule(scan);
  }
  result.scores = test::score_methods(methods, made.scans);
  for (std::size_t i = 0; i < made.scans.size(); i += kSampleEvery) {
    result.samples.push_back(made.scans[i]);
  }
  return result;
}

}  // namespace

std::vector<RunResult> measure_runs(const std::vector<PisteRun>& runs, const std::vector<test::Method>& methods,
                                    std::size_t threads) {
  std::vector<RunResult> results;
  OrderedParallel<RunResult> work(
      runs.size(), threads,
      [&](std::size_t /*worker*/, std::size_t index, RunResult& result) { result = measure_run(runs[index], methods); },
      [&results](std::size_t /*index*/, RunResult& result) {
        results.push_back(std::move(result));
        return true;
      });
  work.run();
  return results;
}

double accuracy_percent(const RunResult& result, std::size_t method) {
  return 100.0 * derive_metrics(result.scores[method].piste).accuracy.value_or(0.0);
}

Spread spread_of(std::span<const RunResult> results, std::size_t method) {
  Spread spread;
  for (const RunResult& result : results) {
    const double percent = accuracy_percent(result, method);
    spread.mean_percent += percent / static_cast<double>(results.size());
    if (percent < spread.min_percent || spread.worst_run.empty()) {
      spread.min_percent = percent;
      spread.worst_run = result.run.plan.name;
    }
  }
  return spread;
}

std::optional<double> snow_f1_percent(const BinaryCounts& counts) {
  if (counts.true_positive + counts.false_negative == 0) {
    return std::nullopt;
  }
  return 100.0 * derive_metrics(counts).f1.value_or(0.0);
}

}  // namespace berm::bench
