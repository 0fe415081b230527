// The map of the surface: time per scan of a Mid-70, and the memory it holds on a loop that is driven again and again.
#include <cmath>
#include <cstdint>
#include <map>
#include <random>
#include <vector>

#include <benchmark/benchmark.h>

#include "berm/map/surface_tiles.hpp"

namespace berm::bench {
namespace {

constexpr int kBeams = 8000;  // returns of a Mid-70 in a tenth of a second
constexpr double kLoopRadius_m = 60.0;
constexpr double kStep_m = 0.4;  // 4 m/s, ten scans a second
constexpr int kScansPerLoop = static_cast<int>(2.0 * 3.14159265 * kLoopRadius_m / kStep_m);

double uniform(std::mt19937_64& random) {
  return static_cast<double>(random() >> 11U) * 0x1p-53;
}

/// In memory, as a disk without its time would be.
class Store final : public SurfaceStore {
 public:
  std::vector<SurfacePoint> load(const TileKey& key) override { return tiles_[key]; }
  void save(const TileKey& key, std::span<const SurfacePoint> points) override {
    tiles_[key].assign(points.begin(), points.end());
  }
  void commit() override {}

 private:
  std::map<TileKey, std::vector<SurfacePoint>> tiles_;
};

/// A groomer on a round way, looking 70 deg wide along it: snow to 50 m, trees outside a piste of 24 m.
SurfaceScan scan_at(int number, std::mt19937_64& random) {
  const double turned_rad = number * kStep_m / kLoopRadius_m;
  SurfaceScan scan;
  scan.sensor_m = {kLoopRadius_m * std::cos(turned_rad), kLoopRadius_m * std::sin(turned_rad), 2.3};
  std::vector<Eigen::Vector3d> ends_m;
  for (int i = 0; i < kBeams; ++i) {
    const double bearing_rad = turned_rad + 1.5708 + 1.22 * (uniform(random) - 0.5);
    const double down_rad = 0.04 + 0.75 * uniform(random) * uniform(random);
    Eigen::Vector3d end_m =
        scan.sensor_m + 2.3 / std::tan(down_rad) * Eigen::Vector3d(std::cos(bearing_rad), std::sin(bearing_rad), 0.0);
    end_m.z() = 0.02 * (uniform(random) - 0.5);
    const double aside_m = std::abs(end_m.head<2>().norm() - kLoopRadius_m);
    const bool is_tree = aside_m > 12.0;
    end_m.z() += is_tree ? 8.0 * uniform(random) : 0.0;
    ends_m.push_back(end_m);
    scan.samples.push_back({end_m, 150.0F, is_tree ? Label::obstacle : Label::drivable});
  }
  scan.beams.resize(1);
  scan.beams[0].set(scan.sensor_m, ends_m);
  return scan;
}

/// `loops` rounds; the time is that of one scan.
void add_surface(benchmark::State& state) {
  SurfaceMapConfig config;
  config.surface = true;
  std::size_t most_after_first = 0;
  std::size_t most_of_first = 0;
  for ([[maybe_unused]] const auto loop : state) {
    Store store;
    SurfaceTiles tiles(config, Eigen::Vector3d::Zero(), store);
    std::mt19937_64 random(1);
    const int scans = static_cast<int>(state.range(0)) * kScansPerLoop;
    for (int i = 0; i < scans; ++i) {
      state.PauseTiming();
      const SurfaceScan scan = scan_at(i, random);
      state.ResumeTiming();
      tiles.add(scan);
      std::size_t& most = i < kScansPerLoop ? most_of_first : most_after_first;
      most = std::max(most, i % 100 == 0 ? tiles.voxels_in_memory() : 0);
    }
    state.counters["cpu_per_scan"] =
        benchmark::Counter(scans, benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
  }
  state.counters["voxels_first_loop"] = static_cast<double>(most_of_first);
  state.counters["voxels_later_loops"] = static_cast<double>(most_after_first);
}

// Three loops of 377 m.
BENCHMARK(add_surface)->Arg(1)->Arg(3)->Iterations(1)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace berm::bench
