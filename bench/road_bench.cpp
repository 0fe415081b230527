// The survey of a road: time per scan, time of the stations, and how both grow from 100 m to 10 km of road.
#include <cmath>
#include <cstdint>
#include <random>
#include <string>
#include <vector>

#include <benchmark/benchmark.h>

#include "berm/map/road_survey.hpp"

namespace berm::bench {
namespace {

constexpr double kHalfWidth_m = 14.0;
constexpr double kSpeed_mps = 10.0;
constexpr int kGround = 13'000;  // returns of a 16-ring sensor on plain road
constexpr int kRaised = 15'800;  // and on all else: 28,800 together
constexpr int kEdges = 26;

double uniform(std::mt19937_64& random) {
  return static_cast<double>(random() >> 11U) * 0x1p-53;
}

/// A place on a road that winds about the x axis with bends of 125 m radius, at a grade of 8 %.
Eigen::Vector3d on_road(double x_m, double aside_m) {
  return {x_m, 20.0 * std::sin(0.02 * x_m) + aside_m, 0.08 * x_m + 0.02 * aside_m};
}

Trajectory drive(int length_m) {
  Trajectory path;
  constexpr double kEvery_m = 0.5;
  for (int i = 0; i * kEvery_m <= length_m; ++i) {
    const double x_m = i * kEvery_m;
    path.append(static_cast<Stamp>(1e9 * x_m / kSpeed_mps),
                Pose::from_yaw_pitch_roll(std::atan(0.4 * std::cos(0.02 * x_m)), 0.0, 0.0, on_road(x_m, 0.0)));
  }
  return path;
}

struct Scan {
  Stamp stamp_ns = 0;
  std::vector<SurveyedEdge> edges;
  std::vector<Eigen::Vector3d> ground_m;
  std::vector<Eigen::Vector3d> raised_m;
};

/// Rings: neighbours in a scan follow each other.
Scan scan_at(double x_m, std::mt19937_64& random) {
  Scan scan;
  scan.stamp_ns = static_cast<Stamp>(1e9 * x_m / kSpeed_mps);
  for (int i = 0; i < kEdges; ++i) {
    const double side = i % 2 == 0 ? 1.0 : -1.0;
    scan.edges.push_back({on_road(x_m + 50.0 * (uniform(random) - 0.5), side * kHalfWidth_m), 1.0F, 2.0F});
  }
  const auto add = [&](std::vector<Eigen::Vector3d>& to, int count, double from_m, double to_m) {
    constexpr int kRings = 16;
    for (int ring = 0; ring < kRings; ++ring) {
      const double ahead_m = 60.0 * (uniform(random) - 0.5);
      for (int i = 0; i < count / kRings; ++i) {
        const double share = (i + uniform(random)) / (1.0 * count / kRings);
        const double aside_m = (i % 2 == 0 ? 1.0 : -1.0) * (from_m + share * (to_m - from_m));
        to.push_back(on_road(x_m + ahead_m - 0.03 * aside_m * aside_m, aside_m));
      }
    }
  };
  add(scan.ground_m, kGround, 0.0, kHalfWidth_m);
  add(scan.raised_m, kRaised, kHalfWidth_m, 30.0);
  return scan;
}

std::vector<EdgeLine> lines(int length_m) {
  std::vector<EdgeLine> both(2);
  both[1].side = EdgeSide::right;
  for (int i = 0; i <= 2 * length_m; ++i) {
    both[0].vertices.push_back({on_road(0.5 * i, kHalfWidth_m), 0.97});
    both[1].vertices.push_back({on_road(0.5 * i, -kHalfWidth_m), 0.97});
  }
  return both;
}

void add_scan(benchmark::State& state) {
  const int length_m = static_cast<int>(state.range(0));
  RoadSurvey survey({}, drive(length_m));
  std::mt19937_64 random(2);
  constexpr int kScans = 50;
  std::vector<Scan> scans;
  scans.reserve(kScans);
  for (int i = 0; i < kScans; ++i) {
    scans.push_back(scan_at(uniform(random) * length_m, random));
  }
  std::size_t next = 0;
  for (auto _ : state) {
    const Scan& scan = scans[next];
    survey.add_scan(scan.stamp_ns, scan.edges, scan.ground_m, scan.raised_m);
    next = (next + 1) % scans.size();
  }
  state.SetItemsProcessed(state.iterations() * (kGround + kRaised));
  state.counters["MB_per_km"] = static_cast<double>(survey.memory_bytes()) / 1e3 / length_m;
}

void stations(benchmark::State& state) {
  const int length_m = static_cast<int>(state.range(0));
  RoadSurvey survey({}, drive(length_m));
  std::mt19937_64 random(1);
  for (int x_m = 0; x_m < length_m; x_m += 2) {
    const Scan scan = scan_at(x_m, random);
    survey.add_scan(scan.stamp_ns, scan.edges, scan.ground_m, scan.raised_m);
  }
  const std::vector<EdgeLine> edges = lines(length_m);
  std::size_t count = 0;
  for (auto _ : state) {
    count = survey.stations(edges).size();
    benchmark::DoNotOptimize(count);
  }
  state.counters["stations"] = static_cast<double>(count);
}

void path(benchmark::State& state) {
  const Trajectory driven = drive(static_cast<int>(state.range(0)));
  for (auto _ : state) {
    benchmark::DoNotOptimize(RoadSurvey({}, driven).memory_bytes());
  }
}

const bool kRegistered = [] {
  const auto add = [](const char* name, void (*run)(benchmark::State&)) {
    benchmark::RegisterBenchmark((std::string("road/") + name).c_str(), run)
        ->Arg(100)
        ->Arg(1000)
        ->Arg(10'000)
        ->Unit(benchmark::kMillisecond);
  };
  add("add_scan", add_scan);
  add("stations", stations);
  add("path", path);
  return true;
}();

}  // namespace
}  // namespace berm::bench
