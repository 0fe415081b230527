// From scans to the lines of a road's edges, against the truth of simulated haul roads, as tables of Markdown; exit
// code 1 if a bar is missed. scripts/road_table.sh builds and runs it. With recordings as arguments: those instead.

#include <algorithm>
#include <cstdint>
#include <exception>
#include <filesystem>
#include <string>
#include <thread>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/core.h>

#include "road_measure.hpp"
#include "road_tables.hpp"

namespace berm::bench {
namespace {

struct Options {
  std::vector<std::string> recordings;
  std::vector<std::string> changes;
  std::string dump_folder;
  std::string kept_folder;
  std::uint64_t seed_offset = 0;
  bool runs_only = false;
  bool bars_only = false;
  bool dust = false;
  std::size_t threads = std::max(1U, std::thread::hardware_concurrency());
};

void measure_dust(const Options& options) {
  const std::vector<RoadMethod> methods = dust_methods();
  const std::vector<RoadResult> results =
      measure_roads(dust_runs(options.seed_offset), methods, options.threads, options.kept_folder);
  fmt::print("## In dust, seeds + {}\n\n", options.seed_offset);
  print_roads(methods, results);
}

bool measure(const Options& options) {
  if (options.dust) {
    measure_dust(options);
    return true;
  }
  std::vector<RoadMethod> methods = main_road_methods();
  if (!options.changes.empty()) {
    methods = {road_method("default", options.changes)};
  } else if (options.bars_only) {
    methods.resize(1);
  } else if (!options.runs_only) {
    const std::vector<RoadMethod> changed = changed_road_methods();
    methods.insert(methods.end(), changed.begin(), changed.end());
  }
  std::vector<RoadResult> results;
  if (options.recordings.empty()) {
    results = measure_roads(road_runs(options.seed_offset), methods, options.threads, options.kept_folder);
    fmt::print("## Roads, seeds + {}\n\n", options.seed_offset);
  } else {
    for (const std::string& recording : options.recordings) {
      results.push_back(measure_recording(recording, methods, options.dump_folder));
    }
  }
  if (!options.bars_only) {
    print_roads(methods, results);
  }
  const bool holds = print_bars(results);
  if (methods.size() > 2) {
    print_methods(methods, results);
  }
  return holds;
}

}  // namespace
}  // namespace berm::bench

int main(int argc, char** argv) {
  berm::bench::Options options;
  CLI::App app("Lines of road edges on simulated haul roads");
  app.add_option("recordings", options.recordings, "Recordings of the simulator instead of the runs");
  app.add_option("--set", options.changes, "The default alone, with another value for a key: section.key=value");
  app.add_option("--dump", options.dump_folder, "Folder for what the default found in the recordings");
  app.add_option("--keep", options.kept_folder, "Folder where recordings are kept, and used again by the next call");
  app.add_option("--seed-offset", options.seed_offset, "Added to the seed of every run: other roads");
  app.add_flag("--runs-only", options.runs_only, "Default and reference, road by road");
  app.add_flag("--dust", options.dust, "Roads in dust and the same in clear air, with and without the snow stage");
  app.add_flag("--bars-only", options.bars_only, "No table, just whether the bars hold");
  app.add_option("--threads", options.threads, "Runs worked on at a time")->check(CLI::Range(1, 1024));
  CLI11_PARSE(app, argc, argv);
  try {
    return berm::bench::measure(options) ? 0 : 1;
  } catch (const std::exception& error) {
    fmt::print(stderr, "berm_road_accuracy: {}\n", error.what());
    return 2;
  }
}
