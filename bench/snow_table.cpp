#include <algorithm>
#include <cstdint>
#include <ctime>
#include <exception>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "bare_rule.hpp"
#include "berm/core/mount.hpp"
#include "berm/io/label_file.hpp"
#include "berm/io/recording.hpp"
#include "berm/snow/box_snow.hpp"
#include "berm/snow/sparse_snow.hpp"

// usage: berm_snow_table [--no-intensity] RECORDING...
//
// F1 of falling snow, or marks where none falls, and CPU time of the bare rule, the reference, the default and the
// default with each step switched off. The reference needs a mount: that of a groomer.

namespace berm::bench {
namespace {

struct Method {
  std::string name;
  std::function<std::unique_ptr<SnowFilter>()> make;
};

std::function<std::unique_ptr<SnowFilter>()> sparse(const std::function<void(SparseSnowConfig&)>& change) {
  return [change] {
    SparseSnowConfig config;
    change(config);
    return std::make_unique<SparseSnow>(config);
  };
}

std::vector<Method> methods() {
  return {{"baseline: < 17 m, intensity 0", [] { return std::make_unique<BareRule>(); }},
          {"reference", [] { return std::make_unique<BoxSnow>(BoxSnowConfig{}); }},
          {"default", sparse([](SparseSnowConfig&) {})},
          {"  without use_intensity", sparse([](SparseSnowConfig& c) { c.use_intensity = false; })},
          {"  without dark_share (all dark are flakes)", sparse([](SparseSnowConfig& c) {
             c.dark_share = 1.0;
             c.dark_points = 100.0;
           })},
          {"  without spare_lines", sparse([](SparseSnowConfig& c) { c.spare_lines = false; })},
          {"  without fade_with_range", sparse([](SparseSnowConfig& c) { c.fade_with_range = false; })},
          {"  without ask_for_spread", sparse([](SparseSnowConfig& c) { c.ask_for_spread = false; })},
          {"  window half as wide (0.025)", sparse([](SparseSnowConfig& c) { c.window = 0.025; })},
          {"  window twice as wide (0.1)", sparse([](SparseSnowConfig& c) { c.window = 0.1; })},
          {"  max_range_m 12", sparse([](SparseSnowConfig& c) { c.max_range_m = 12.0; })},
          {"  max_range_m 20", sparse([](SparseSnowConfig& c) { c.max_range_m = 20.0; })}};
}

double cpu_ms() {
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return 1e3 * static_cast<double>(now.tv_sec) + 1e-6 * static_cast<double>(now.tv_nsec);
}

struct Row {
  double hits = 0.0;
  double marks = 0.0;
  double flakes = 0.0;
  double returns = 0.0;
  std::vector<double> times_ms;
};

void measure(SnowFilter& filter, const PointsView& points, const std::vector<std::uint32_t>& truth, Row& row) {
  const Pose T_base_sensor = MountConfig{.height_m = 2.3, .pitch_deg = 11.0}.T_base_sensor();
  (void)filter.process(points, T_base_sensor);
  const double before_ms = cpu_ms();
  const SnowResult result = filter.process(points, T_base_sensor);
  row.times_ms.push_back(cpu_ms() - before_ms);
  row.marks += static_cast<double>(result.count);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const bool flake = !truth.empty() && (truth[i] & 0xFFFFU) == 110U;
    row.flakes += flake ? 1.0 : 0.0;
    row.hits += flake && result.falling[i] != 0 ? 1.0 : 0.0;
    row.returns += is_no_return(points.x[i], points.y[i], points.z[i]) ? 0.0 : 1.0;
  }
}

void print(const std::string& name, Row& row) {
  std::sort(row.times_ms.begin(), row.times_ms.end());
  const double median_ms = row.times_ms[row.times_ms.size() / 2];
  const std::string found =
      row.flakes > 0.0
          ? fmt::format("F1 {:6.2f}  precision {:6.2f}  recall {:6.2f}", 200.0 * row.hits / (row.marks + row.flakes),
                        row.marks > 0.0 ? 100.0 * row.hits / row.marks : 100.0, 100.0 * row.hits / row.flakes)
          : fmt::format("marks {:7.4f}", 100.0 * row.marks / row.returns);
  fmt::print("{:<44} {}  ms {:.3f}\n", name, found, median_ms);
}

void tabulate(const std::string& path, bool drop_intensity) {
  const Recording recording = Recording::open(path);
  const std::vector<Method> all = methods();
  std::vector<Row> rows(all.size());
  std::vector<std::unique_ptr<SnowFilter>> filters;
  filters.reserve(all.size());
  for (const Method& method : all) {
    filters.push_back(method.make());
  }
  Scan scan;
  for (std::size_t i = 0; i < recording.size(); ++i) {
    recording.read(i, scan);
    const auto labels = recording.scan(i).truth_labels;
    const std::vector<std::uint32_t> truth =
        labels ? read_labels(*labels, scan.cloud.size()) : std::vector<std::uint32_t>{};
    PointsView points = scan.cloud.view();
    if (drop_intensity) {
      points.intensity = {};
    }
    for (std::size_t k = 0; k < all.size(); ++k) {
      measure(*filters[k], points, truth, rows[k]);
    }
  }
  fmt::print("\n{}, %\n", recording.path().filename().string());
  for (std::size_t k = 0; k < all.size(); ++k) {
    print(all[k].name, rows[k]);
  }
}

}  // namespace
}  // namespace berm::bench

int main(int argc, char** argv) {
  bool drop_intensity = false;
  for (int i = 1; i < argc; ++i) {
    const std::string argument = argv[i];
    if (argument == "--no-intensity") {
      drop_intensity = true;
      continue;
    }
    try {
      berm::bench::tabulate(argument, drop_intensity);
    } catch (const std::exception& error) {
      fmt::print(stderr, "berm_snow_table: {}\n", error.what());
      return 1;
    }
  }
  return 0;
}
