#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <utility>

#include <benchmark/benchmark.h>

#include "bare_rule.hpp"
#include "berm/snow/box_snow.hpp"
#include "berm/snow/sparse_snow.hpp"
#include "scans.hpp"
#include "snow/snow_cases.hpp"

namespace berm::bench {
namespace {

/// Rosettes of a Mid-70 over a street, and denser ones, in snowfall that 0, 5 or 12 beams in a hundred meet.
const std::map<std::string, std::pair<int, double>>& rosettes() {
  static const std::map<std::string, std::pair<int, double>> all = {
      {"rosette_10k_clear", {10000, 0.0}},     {"rosette_10k_snow_5", {10000, 0.05}},
      {"rosette_10k_snow_12", {10000, 0.12}},  {"rosette_30k_snow_5", {30000, 0.05}},
      {"rosette_100k_snow_5", {100000, 0.05}}, {"rosette_300k_snow_5", {300000, 0.05}},
      {"rosette_1M_snow_5", {1000000, 0.05}}};
  return all;
}

const BenchScan& snowy_scan(const std::string& name) {
  static std::map<std::string, BenchScan> made;
  const auto known = made.find(name);
  if (known != made.end()) {
    return known->second;
  }
  const auto& [count, share] = rosettes().at(name);
  const test::Lookout lookout{"rosette", test::rosette_beams(70.4, count), 2.3, 11.0};
  test::SnowyScan snowy = test::let_it_snow(lookout.look(test::made_street(1)), {.share = share}, 1);
  return made.emplace(name, BenchScan{PointCloud(std::move(snowy.channels)), {}}).first->second;
}

template <typename MakeFilter>
void add(const std::string& method, const std::string& name, bool made_here, MakeFilter make_filter) {
  benchmark::RegisterBenchmark(("snow/" + method + "/" + name).c_str(), [=](benchmark::State& state) {
    const BenchScan& measured = made_here ? snowy_scan(name) : scan(name);
    const std::unique_ptr<SnowFilter> filter = make_filter();
    for (auto _ : state) {
      benchmark::DoNotOptimize(filter->process(measured.cloud.view(), measured.T_base_sensor).count);
    }
    state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(measured.cloud.size()));
  })->Unit(benchmark::kMicrosecond);
}

void add_methods(const std::string& name, bool made_here) {
  add("default", name, made_here, [] { return std::make_unique<SparseSnow>(SparseSnowConfig{}); });
  add("reference", name, made_here, [] { return std::make_unique<BoxSnow>(BoxSnowConfig{}); });
  add("bare", name, made_here, [] { return std::make_unique<BareRule>(); });
}

const bool kRegistered = [] {
  for (const auto& [name, what] : rosettes()) {
    add_methods(name, true);
  }
  for (const std::string& name : all_scans()) {
    add_methods(name, false);
  }
  return true;
}();

}  // namespace
}  // namespace berm::bench
