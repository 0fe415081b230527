#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include <benchmark/benchmark.h>

#include "berm/piste/envelope_piste.hpp"
#include "berm/snow/box_snow.hpp"
#include "berm/snow/repair.hpp"
#include "piste/mid70_scan.hpp"

namespace berm::bench {
namespace {

/// The published chain on a piste as the groomer's Mid-70 sees it: flakes, repair, slope, steps, petals, envelopes.
void measure(benchmark::State& state, std::size_t count) {
  const test::MadeScan scan = test::mid70_scan(0, count);
  PointsView points = scan.cloud.view();
  const std::vector<float> bright(points.size(), 150.0F);
  points.intensity = bright;
  std::vector<Label> labels;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const bool none = is_no_return(points.x[i], points.y[i], points.z[i]);
    labels.push_back(none ? Label::no_return : Label::drivable);
  }
  PisteInput input{.points = points, .labels = labels, .series = {}, .T_base_sensor = test::groomer_mount()};
  BoxSnow snow({});
  SeriesRepair repair;
  EnvelopePiste piste({});
  for (auto _ : state) {
    input.series = repair.process(points, snow.process(points, input.T_base_sensor).falling);
    benchmark::DoNotOptimize(piste.process(input).labels.data());
  }
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(points.size()));
}

const bool kRegistered = [] {
  benchmark::RegisterBenchmark("piste/reference/mid70", measure, 10'000)->Unit(benchmark::kMicrosecond);
  benchmark::RegisterBenchmark("piste/reference/mid70_100k", measure, 100'000)->Unit(benchmark::kMicrosecond);
  benchmark::RegisterBenchmark("piste/reference/mid70_1M", measure, 1'000'000)->Unit(benchmark::kMicrosecond);
  return true;
}();

}  // namespace
}  // namespace berm::bench
