#include <map>
#include <memory>
#include <string>
#include <vector>

#include <benchmark/benchmark.h>

#include "berm/edge/ring_edges.hpp"
#include "berm/edge/trace_edges.hpp"
#include "berm/ground/terrain_ground.hpp"
#include "edge/road_scene.hpp"
#include "scans.hpp"

namespace berm::bench {
namespace {

/// A scan with what the ground stage says of it.
struct EdgeCase {
  explicit EdgeCase(PointsView view, const Pose& T) : points(view), T_base_sensor(T), ground({}) {
    const GroundResult result = ground.process(points, T_base_sensor);
    surface = result.surface;
    for (const GroundClass one : result.classes) {
      const Label solid = one == GroundClass::ground ? Label::drivable : Label::obstacle;
      labels.push_back(one == GroundClass::ground || one == GroundClass::not_ground ? solid : Label::no_return);
    }
  }

  PointsView points;
  Pose T_base_sensor;
  TerrainGround ground;
  std::vector<Label> labels;
  const HeightGrid* surface = nullptr;
};

const EdgeCase& edge_case(const std::string& name) {
  static std::map<std::string, std::unique_ptr<EdgeCase>> cases;
  std::unique_ptr<EdgeCase>& made = cases[name];
  if (made == nullptr && name == "haul_road_16") {
    static const test::RoadScan kRoad = test::scan_road(test::bend_between_berms(60.0, 7.0, 1.2));
    made = std::make_unique<EdgeCase>(kRoad.points(), kRoad.T_base_sensor);
  } else if (made == nullptr) {
    made = std::make_unique<EdgeCase>(scan(name).cloud.view(), scan(name).T_base_sensor);
  }
  return *made;
}

template <typename Edges, typename Config>
void add(const std::string& method) {
  std::vector<std::string> names = all_scans();
  names.emplace_back("haul_road_16");
  for (const std::string& name : names) {
    const std::string full_name = std::string("edge/").append(method).append("/").append(name);
    benchmark::RegisterBenchmark(full_name.c_str(), [name](benchmark::State& state) {
      const EdgeCase& measured = edge_case(name);
      Edges edges{Config{}};
      for (auto _ : state) {
        benchmark::DoNotOptimize(edges.process({.points = measured.points,
                                                .labels = measured.labels,
                                                .surface = measured.surface,
                                                .T_base_sensor = measured.T_base_sensor}));
      }
      state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(measured.points.size()));
    })->Unit(benchmark::kMicrosecond);
  }
}

const bool kRegistered = [] {
  add<TraceEdges, TraceEdgesConfig>("default");
  add<RingEdges, RingEdgesConfig>("reference");
  return true;
}();

}  // namespace
}  // namespace berm::bench
