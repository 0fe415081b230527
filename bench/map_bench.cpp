// The map of edges and its lines: time per scan, and how both grow from 100 m to 10 km of road.
#include <cmath>
#include <cstdint>
#include <map>
#include <random>
#include <string>
#include <vector>

#include <benchmark/benchmark.h>

#include "berm/map/edge_lines.hpp"
#include "berm/map/edge_map.hpp"

namespace berm::bench {
namespace {

constexpr double kHalfWidth_m = 14.0;
constexpr int kObserved = 13'000;  // returns of a 16-ring sensor on plain road
constexpr int kEdges = 26;

double uniform(std::mt19937_64& random) {
  return static_cast<double>(random() >> 11U) * 0x1p-53;
}

/// A place on a road that winds about the x axis with bends of 125 m radius, at a grade of 8 %.
Eigen::Vector3d on_road(double x_m, double aside_m) {
  return {x_m, 20.0 * std::sin(0.02 * x_m) + aside_m, 0.08 * x_m + 0.02 * aside_m};
}

struct Scan {
  std::vector<MappedEdge> edges;
  std::vector<Eigen::Vector3d> plain_m;
};

/// What a scan in the middle of 50 m of road sees, in rings: neighbours of a ring follow each other.
Scan scan_at(double x_m, std::mt19937_64& random) {
  Scan scan;
  for (int i = 0; i < kEdges; ++i) {
    const double side = i % 2 == 0 ? 1.0 : -1.0;
    const double aside_m = side * kHalfWidth_m + 0.3 * (uniform(random) - 0.5);
    scan.edges.push_back(
        {on_road(x_m + 50.0 * (uniform(random) - 0.5), aside_m), side > 0.0 ? EdgeSide::left : EdgeSide::right});
  }
  const int rings = 16;
  const int per_ring = kObserved / rings;
  for (int ring = 0; ring < rings; ++ring) {
    const double ahead_m = 50.0 * (uniform(random) - 0.5);
    for (int i = 0; i < per_ring; ++i) {
      const double aside_m = (2.0 * (i + uniform(random)) / per_ring - 1.0) * (kHalfWidth_m - 0.3);
      const double bent_m = 0.03 * aside_m * aside_m;
      const double bump_m = 0.06 * (uniform(random) - 0.5);
      scan.plain_m.emplace_back(on_road(x_m + ahead_m - bent_m, aside_m) + Eigen::Vector3d(0.0, 0.0, bump_m));
    }
  }
  return scan;
}

/// The map of a drive along that much road, a scan every metre.
const EdgeMap& map_of(int length_m) {
  static std::map<int, EdgeMap> made;
  const auto known = made.find(length_m);
  if (known != made.end()) {
    return known->second;
  }
  EdgeMap map({});
  std::mt19937_64 random(1);
  for (int x_m = 0; x_m < length_m; ++x_m) {
    const Scan scan = scan_at(x_m, random);
    map.add_scan(scan.edges, scan.plain_m);
  }
  return made.emplace(length_m, std::move(map)).first->second;
}

void add_scan(benchmark::State& state) {
  EdgeMap map = map_of(static_cast<int>(state.range(0)));
  std::mt19937_64 random(2);
  constexpr int kScans = 50;
  std::vector<Scan> scans;
  scans.reserve(kScans);
  for (int i = 0; i < kScans; ++i) {
    scans.push_back(scan_at(uniform(random) * static_cast<double>(state.range(0)), random));
  }
  std::size_t next = 0;
  for (auto _ : state) {
    benchmark::DoNotOptimize(map.add_scan(scans[next].edges, scans[next].plain_m));
    next = (next + 1) % scans.size();
  }
  state.SetItemsProcessed(state.iterations() * kObserved);
}

/// Per km of road, so that growth that is not linear shows.
void report_size(benchmark::State& state, const std::string& name, std::size_t bytes) {
  state.counters[name] = static_cast<double>(bytes) / 1e6 / (static_cast<double>(state.range(0)) / 1000.0);
}

void lines(benchmark::State& state) {
  const EdgeMap& map = map_of(static_cast<int>(state.range(0)));
  for (auto _ : state) {
    benchmark::DoNotOptimize(extract_lines(map, {}).size());
  }
  report_size(state, "map_MB_per_km", map.memory_bytes());
  state.counters["voxels_per_km"] = static_cast<double>(map.size()) / (static_cast<double>(state.range(0)) / 1000.0);
}

void write(benchmark::State& state) {
  const EdgeMap& map = map_of(static_cast<int>(state.range(0)));
  std::size_t bytes = 0;
  for (auto _ : state) {
    bytes = map.to_octomap().size();
    benchmark::DoNotOptimize(bytes);
  }
  report_size(state, "file_MB_per_km", bytes);
}

void read(benchmark::State& state) {
  const std::string bytes = map_of(static_cast<int>(state.range(0))).to_octomap();
  for (auto _ : state) {
    benchmark::DoNotOptimize(EdgeMap::from_octomap(bytes, "map", {}).size());
  }
}

void merge(benchmark::State& state) {
  const EdgeMap& map = map_of(static_cast<int>(state.range(0)));
  for (auto _ : state) {
    EdgeMap sum({});
    sum.merge(map);
    benchmark::DoNotOptimize(sum.size());
  }
}

const bool kRegistered = [] {
  const auto add = [](const char* name, void (*run)(benchmark::State&)) {
    benchmark::RegisterBenchmark((std::string("map/") + name).c_str(), run)
        ->Arg(100)
        ->Arg(1000)
        ->Arg(10'000)
        ->Unit(benchmark::kMillisecond);
  };
  add("add_scan", add_scan);
  add("lines", lines);
  add("write", write);
  add("read", read);
  add("merge", merge);
  return true;
}();

}  // namespace
}  // namespace berm::bench
