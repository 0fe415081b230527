// What the chain of the groomer gets right on simulated pistes with truth, as tables of Markdown; exit code 1 if a bar
// is missed. scripts/piste_table.sh builds and runs it.
//
//   BERM_DATA=FOLDER berm_piste_accuracy        FOLDER holds alpine_dem; without it made terrain alone

#include <algorithm>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <string>
#include <thread>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/core.h>

#include "piste_measure.hpp"
#include "piste_methods.hpp"
#include "piste_runs.hpp"
#include "piste_tables.hpp"
#include "piste_timing.hpp"

namespace berm::bench {
namespace {

namespace fs = std::filesystem;

struct Options {
  RunChoice runs;
  bool runs_only = false;
  bool bars_only = false;
  std::size_t threads = std::max(1U, std::thread::hardware_concurrency());
};

std::optional<fs::path> find_alpine_dem() {
  const char* data = std::getenv("BERM_DATA");
  if (data == nullptr || !fs::exists(fs::path(data) / "alpine_dem")) {
    return std::nullopt;
  }
  return fs::path(data) / "alpine_dem";
}

void print_intro(const RunChoice& choice, const std::vector<PisteRun>& runs) {
  fmt::print("## Runs, seeds + {}\n\n", choice.seed_offset);
  fmt::print("{} runs of {:.0f} s, 10 scans of 10,000 points each second.{}\n\n", runs.size(),
             runs.front().plan.seconds,
             choice.alpine_dem ? "" : " BERM_DATA names no folder with alpine_dem: no run on real elevation models.");
}

void print_steps(const std::vector<test::Method>& methods, const std::vector<RunResult>& results) {
  std::vector<test::LabelledScan> samples;
  for (const RunResult& result : results) {
    samples.insert(samples.end(), result.samples.begin(), result.samples.end());
  }
  fmt::print(
      "\n## Every step switched off in turn\n\nAccuracy in %, CPU time of a stage per 10,000 points: medians over "
      "{} scans of these runs.\n\n",
      samples.size());
  print_methods(methods, results, time_methods(methods, samples));
}

void measure_sensors(const Options& options) {
  std::vector<PisteRun> runs;
  std::size_t runs_each = 0;
  for (const char* sensor : {"livox_mid70", "livox_mid360", "vlp16", "hdl32e", "ouster64"}) {
    const std::vector<PisteRun> own = runs_with_sensor(sensor, options.runs.seed_offset);
    runs_each = own.size();
    runs.insert(runs.end(), own.begin(), own.end());
  }
  fmt::print("## Other sensors on the groomer\n\nMean accuracy in % over {} runs of {:.0f} s.\n\n", runs_each,
             runs.front().plan.seconds);
  print_sensors(measure_runs(runs, main_methods(), options.threads), runs_each);
}

bool measure(const Options& options) {
  const std::vector<PisteRun> runs = piste_runs(options.runs);
  const bool all_tables = !options.runs.quick && !options.runs_only && !options.bars_only;
  std::vector<test::Method> methods = main_methods();
  std::vector<VariedKey> keys;
  std::size_t steps_end = methods.size();
  if (all_tables) {
    const std::vector<test::Method> without = methods_without_a_step();
    methods.insert(methods.end(), without.begin(), without.end());
    steps_end = methods.size();
    keys = varied_keys();
    for (const VariedKey& key : keys) {
      methods.push_back(key.halved);
      methods.push_back(key.doubled);
    }
  }
  print_intro(options.runs, runs);
  const std::vector<RunResult> results = measure_runs(runs, methods, options.threads);
  if (!options.bars_only) {
    print_runs(results);
  }
  const bool holds = print_bars(results);
  if (all_tables) {
    methods.resize(steps_end);
    print_steps(methods, results);
    fmt::print(
        "## Settings halved and doubled\n\nMean accuracy against the default's, and the worst run, in %. The first "
        "three "
        "only matter for the obstacle ahead,\ntremble_mrad only without a firing order.\n\n");
    print_keys(keys, results, steps_end);
    measure_sensors(options);
  }
  return holds;
}

}  // namespace
}  // namespace berm::bench

int main(int argc, char** argv) {
  berm::bench::Options options;
  CLI::App app("Accuracy of the piste and of falling snow on simulated runs");
  app.add_flag("--quick", options.runs.quick, "Four runs of 3 s, and no other table");
  app.add_flag("--runs-only", options.runs_only, "The table of the runs alone");
  app.add_flag("--bars-only", options.bars_only, "No table, just whether the bars hold");
  app.add_option("--seed-offset", options.runs.seed_offset, "Added to the seed of every run: other worlds and weather");
  app.add_option("--threads", options.threads, "Runs worked on at a time")->check(CLI::Range(1, 1024));
  CLI11_PARSE(app, argc, argv);
  try {
    options.runs.alpine_dem = berm::bench::find_alpine_dem();
    return berm::bench::measure(options) ? 0 : 1;
  } catch (const std::exception& error) {
    fmt::print(stderr, "berm_piste_accuracy: {}\n", error.what());
    return 2;
  }
}
