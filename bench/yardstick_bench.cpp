#include <cmath>
#include <cstring>
#include <string>
#include <vector>

#include <benchmark/benchmark.h>

#include "scans.hpp"

/// What a machine takes for work that everybody knows: one memcpy of the cloud (x, y, z, intensity) and one
/// std::atan2f per point. Figures of stages are quoted as ratios to these, of the same run.
namespace berm::bench {
namespace {

void copy_cloud(benchmark::State& state, const BenchScan& measured) {
  const std::vector<float> from(4 * measured.cloud.size(), 1.0F);
  std::vector<float> to(from.size());
  for (auto _ : state) {
    std::memcpy(to.data(), from.data(), from.size() * sizeof(float));
    benchmark::DoNotOptimize(to.data());
    benchmark::ClobberMemory();
  }
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(measured.cloud.size()));
}

void azimuth_of_points(benchmark::State& state, const BenchScan& measured) {
  const PointsView points = measured.cloud.view();
  std::vector<float> azimuth_rad(points.size());
  for (auto _ : state) {
    for (std::size_t i = 0; i < points.size(); ++i) {
      azimuth_rad[i] = std::atan2(points.y[i], points.x[i]);
    }
    benchmark::DoNotOptimize(azimuth_rad.data());
    benchmark::ClobberMemory();
  }
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(measured.cloud.size()));
}

const bool kRegistered = [] {
  for (const std::string& name : all_scans()) {
    benchmark::RegisterBenchmark(("yardstick_memcpy/" + name).c_str(), [name](benchmark::State& state) {
      copy_cloud(state, scan(name));
    })->Unit(benchmark::kMicrosecond);
    benchmark::RegisterBenchmark(("yardstick_atan2f/" + name).c_str(), [name](benchmark::State& state) {
      azimuth_of_points(state, scan(name));
    })->Unit(benchmark::kMicrosecond);
  }
  return true;
}();

}  // namespace
}  // namespace berm::bench
