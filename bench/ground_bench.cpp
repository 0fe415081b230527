#include <string>

#include <benchmark/benchmark.h>

#include "berm/ground/polar_ground.hpp"
#include "berm/ground/terrain_ground.hpp"
#include "scans.hpp"

namespace berm::bench {
namespace {

template <typename Ground, typename Config>
void add(const std::string& method) {
  for (const std::string& name : all_scans()) {
    benchmark::RegisterBenchmark((method + "/" + name).c_str(), [name](benchmark::State& state) {
      const BenchScan& measured = scan(name);
      Ground ground{Config{}};
      for (auto _ : state) {
        benchmark::DoNotOptimize(ground.process(measured.cloud.view(), measured.T_base_sensor).counts);
      }
      state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(measured.cloud.size()));
    })->Unit(benchmark::kMicrosecond);
  }
}

const bool kRegistered = [] {
  add<TerrainGround, TerrainGroundConfig>("ground_default");
  add<PolarGround, PolarGroundConfig>("ground_reference");
  return true;
}();

}  // namespace
}  // namespace berm::bench
