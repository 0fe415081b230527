#include "road_runs.hpp"

#include <utility>

#include <fmt/core.h>

namespace berm::bench {
namespace {

constexpr double kSeconds = 60.0;  // at about 6 m/s: 300 m of road at least

test::RunPlan make_run(std::string name, std::uint64_t seed, std::vector<std::string> settings,
                       std::string sensor = "vlp16", std::string scenario = "haul_road") {
  return {.name = std::move(name),
          .scenario = std::move(scenario),
          .settings = std::move(settings),
          .seed = seed,
          .seconds = kSeconds,
          .sensor = std::move(sensor)};
}

std::vector<test::RunPlan> with_offset(std::vector<test::RunPlan> runs, std::uint64_t seed_offset) {
  for (test::RunPlan& run : runs) {
    run.seed += seed_offset;
  }
  return runs;
}

}  // namespace

std::vector<test::RunPlan> road_runs(std::uint64_t seed_offset) {
  std::vector<test::RunPlan> runs{
      make_run("plain 1", 101, {}),
      make_run("plain 2", 102, {}),
      make_run("plain 3", 110, {}),
      make_run("tight bends", 103, {"route.bend_deg=100", "route.bend_every_m=70", "route.min_radius_m=30"}),
      make_run("junctions, holes", 104,
               {"haul_road.junctions=3", "haul_road.potholes_per_km=200", "haul_road.puddles_per_km=60",
                "haul_road.rocks_per_km=200"}),
      make_run("wide, 6 parked trucks", 105,
               {"haul_road.min_width_m=18", "haul_road.max_width_m=30", "traffic.parked=6", "traffic.oncoming=2"}),
      make_run(
          "narrow", 106,
          {"haul_road.min_width_m=9", "haul_road.max_width_m=15", "haul_road.min_berm_m=0.7", "traffic.oncoming=0"}),
      make_run("low berms, many gaps", 109,
               {"haul_road.min_berm_m=0.4", "haul_road.max_berm_m=0.9", "haul_road.gap_every_m=40"}),
      make_run("HDL-32E", 107, {}, "hdl32e"),
      make_run("Livox Mid-360", 108, {"mount.pitch_deg=15"}, "livox_mid360"),
  };
  return with_offset(std::move(runs), seed_offset);
}

std::vector<test::RunPlan> dust_runs(std::uint64_t seed_offset) {
  std::vector<test::RunPlan> runs;
  for (const int road : {1, 2}) {
    const auto seed = static_cast<std::uint64_t>(110 + road);
    runs.push_back(make_run(fmt::format("dust {}", road), seed, {}, "vlp16", "haul_road_dust"));
    runs.push_back(make_run(fmt::format("clear {}", road), seed, {"dust.plumes=0"}, "vlp16", "haul_road_dust"));
  }
  return with_offset(std::move(runs), seed_offset);
}

}  // namespace berm::bench
