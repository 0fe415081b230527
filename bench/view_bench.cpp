#include <cstddef>
#include <utility>
#include <vector>

#include <benchmark/benchmark.h>

#include "berm/view/view_api.hpp"
#include "support/made_recording.hpp"
#include "support/temp_folder.hpp"

namespace {

/// A scan of `points` as `berm view` answers it; `cache_bytes` 0 reads the file every time.
void serve_scan(benchmark::State& state, std::size_t cache_bytes) {
  const berm::test::TempFolder folder;
  const auto points = static_cast<std::size_t>(state.range(0));
  berm::test::make_recording(folder / "recording", 1, points);
  std::vector<berm::ShownRun> runs;
  runs.push_back(berm::ShownRun::open(folder / "recording"));
  berm::ViewOptions options;
  options.cache_bytes = cache_bytes;
  berm::ViewApi api(std::move(runs), berm::Site(), std::move(options));
  for (auto _ : state) {
    auto answer = api.answer({.target = "/api/runs/0/scans/0", .caller = {.host = "localhost"}});
    benchmark::DoNotOptimize(answer.body->data());
  }
  state.SetItemsProcessed(state.iterations() * state.range(0));
}

void view_scan_from_file(benchmark::State& state) {
  serve_scan(state, 0);
}
void view_scan_from_cache(benchmark::State& state) {
  serve_scan(state, std::size_t{256} << 20U);
}

}  // namespace

// A Mid-70 and an HDL-64E.
BENCHMARK(view_scan_from_file)->Arg(10'000)->Arg(130'000)->Unit(benchmark::kMillisecond);
BENCHMARK(view_scan_from_cache)->Arg(130'000)->Unit(benchmark::kMillisecond);
