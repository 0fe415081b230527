// From scans to the lines of a road's edges, against the truth of simulated haul roads, as tables of Markdown; exit
// code 1 if a bar is missed. scripts/road_table.sh builds and runs it. With recordings as arguments: those instead.

#include <algorithm>
#include <exception>
#include <filesystem>
#include <string>
#include <thread>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/core.h>

#include "road_measure.hpp"

namespace berm::bench {
namespace {

struct Options {
  std::vector<std::string> recordings;
  std::string only;
  std::vector<std::string> changes;
  std::string dump_folder;
  std::uint64_t seed_offset = 0;
  bool runs_only = false;
  std::size_t threads = std::max(1U, std::thread::hardware_concurrency());
};

void print(const std::string& name, const RoadScore& score) {
  const auto percent = [](const std::optional<double>& share) { return 100.0 * share.value_or(0.0); };
  const EdgeScore& lines = score.lines;
  fmt::print(
      "| {:<40} | {:6.2f} | {:6.2f} | {:6.2f} | {:6.3f} | {:6.3f} | {:6.2f} | {:6.3f} | {:6.2f} | {:6.2f} | {:6.1f} "
      "|\n",
      name, percent(lines.f1), percent(lines.precision), percent(lines.recall), lines.lateral_median_m.value_or(0.0),
      lines.lateral_p95_m.value_or(0.0), percent(lines.wrong_side_share), score.height_error_m.value_or(0.0),
      score.detect_ms, score.map_ms, score.lines_ms);
}

bool measure(const Options& options) {
  std::vector<RoadMethod> methods = main_road_methods();
  if (!options.changes.empty()) {
    methods = {road_method("default", options.changes)};
  } else if (!options.runs_only) {
    for (RoadMethod& method : changed_road_methods()) {
      methods.push_back(std::move(method));
    }
  }
  std::erase_if(methods, [&](const RoadMethod& method) { return method.name.find(options.only) == std::string::npos; });
  std::vector<RoadResult> results;
  if (options.recordings.empty()) {
    results = measure_roads(road_runs(options.seed_offset), methods, options.threads);
  } else {
    for (const std::string& recording : options.recordings) {
      results.push_back(measure_recording(recording, methods, options.dump_folder));
    }
  }
  for (std::size_t m = 0; m < methods.size(); ++m) {
    for (const RoadResult& result : results) {
      print(result.name + ", " + methods[m].name, result.scores[m]);
    }
  }
  for (std::size_t m = 0; m < methods.size(); ++m) {
    double f1 = 0, p = 0, r = 0;
    for (const RoadResult& result : results) {
      const auto& l = result.scores[m].lines;
      f1 += l.f1.value_or(0) / double(results.size());
      p += l.precision.value_or(0) / double(results.size());
      r += l.recall.value_or(0) / double(results.size());
    }
    fmt::print("mean {:<30} {:.2f} {:.2f} {:.2f}\n", methods[m].name, 100 * f1, 100 * p, 100 * r);
  }
  return true;
}

}  // namespace
}  // namespace berm::bench

int main(int argc, char** argv) {
  berm::bench::Options options;
  CLI::App app("Lines of road edges on simulated haul roads");
  app.add_option("recordings", options.recordings, "Recordings of the simulator instead of the runs");
  app.add_option("--only", options.only, "Methods whose name holds this");
  app.add_option("--set", options.changes, "The default alone, with another value for a key: section.key=value");
  app.add_option("--dump", options.dump_folder, "Folder for what the first method found in the recordings");
  app.add_option("--seed-offset", options.seed_offset, "Added to the seed of every run");
  app.add_flag("--runs-only", options.runs_only, "Default and reference alone");
  app.add_option("--threads", options.threads, "Runs worked on at a time")->check(CLI::Range(1, 1024));
  CLI11_PARSE(app, argc, argv);
  try {
    return berm::bench::measure(options) ? 0 : 1;
  } catch (const std::exception& error) {
    fmt::print(stderr, "berm_road_accuracy: {}\n", error.what());
    return 2;
  }
}
