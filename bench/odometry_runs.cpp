#include "odometry_runs.hpp"

#include <utility>

namespace berm::bench {
namespace {

using Settings = std::vector<std::string>;

/// At 1.5 to 1.7 m/s more than 50 m.
constexpr double kGroomer_s = 38.0;
constexpr double kTruck_s = 20.0;

OdometryRun groomer(std::string name, std::string scenario, std::uint64_t seed, Settings settings) {
  return {.plan = {.name = std::move(name),
                   .scenario = std::move(scenario),
                   .settings = std::move(settings),
                   .seed = seed,
                   .seconds = kGroomer_s},
          .machine = "groomer"};
}

OdometryRun truck(std::string name, std::string scenario, std::uint64_t seed, std::string sensor, Settings settings) {
  return {.plan = {.name = std::move(name),
                   .scenario = std::move(scenario),
                   .settings = std::move(settings),
                   .seed = seed,
                   .seconds = kTruck_s,
                   .sensor = std::move(sensor)},
          .machine = "haul_truck"};
}

/// Neither forest nor fences, poles, houses and lift.
Settings nothing_beside() {
  return {"things.trees_per_hectare=0", "things.fence_share=0", "things.pole_every_m=0", "things.billboard_every_m=0",
          "things.building_every_m=0",  "things.lift=false",    "traffic.oncoming=0",    "traffic.parked=0"};
}

Settings with(Settings settings, const Settings& more) {
  settings.insert(settings.end(), more.begin(), more.end());
  return settings;
}

}  // namespace

std::vector<OdometryRun> odometry_runs(std::uint64_t seed_offset) {
  const Settings steep = {"route.min_gradient_deg=20", "route.max_gradient_deg=30"};
  const Settings heaving = {"vehicle.heave_m=0.06"};
  const Settings few = {"things.trees_per_hectare=25", "things.fence_share=0"};
  const Settings many = {"things.trees_per_hectare=900", "things.fence_share=0.6"};
  const Settings dense = {"snowfall.flakes_per_m3=350", "snowfall.gustiness=0.2"};
  std::vector<OdometryRun> runs = {
      groomer("clear", "groomer_clear", 301, {}),
      groomer("clear, 30 deg, heaving", "groomer_clear", 302, with(steep, heaving)),
      groomer("clear, little beside", "groomer_clear", 303, few),
      groomer("clear, much beside", "groomer_clear", 304, many),
      groomer("5 % flakes", "groomer_snowfall", 305, {}),
      groomer("5 % flakes, 30 deg", "groomer_snowfall", 306, with(steep, heaving)),
      groomer("5 % flakes, little beside", "groomer_snowfall", 307, few),
      groomer("12 % flakes", "groomer_snowfall", 308, dense),
      groomer("12 % flakes, bends", "groomer_snowfall", 309,
              with(dense, {"route.bend_deg=100", "route.min_gradient_deg=10"})),
      groomer("night storm", "groomer_night_storm", 310, {}),
      groomer("forks", "groomer_forks", 311, {}),
      groomer("clear, 5 m/s", "groomer_clear", 313, {"vehicle.speed_m_per_s=5"}),
      groomer("5 % flakes, stops", "groomer_snowfall", 314, {"vehicle.stop_every_s=10"}),
      groomer("bare slope", "groomer_clear", 312,
              with(nothing_beside(), {"piste.bank_share=0", "piste.forks=0", "piste.min_width_m=60",
                                      "piste.max_width_m=80", "route.min_radius_m=100"})),
      truck("mine road, 16 rings", "haul_road", 321, "vlp16", {}),
      truck("mine road, 32 rings", "haul_road", 322, "hdl32e", {}),
      truck("mine road, Mid-360", "haul_road", 323, "livox_mid360", {"mount.pitch_deg=15"}),
      truck("flat road, 16 rings", "flat_road", 324, "vlp16", {}),
  };
  for (OdometryRun& run : runs) {
    run.plan.seed += seed_offset;
    run.is_bare = run.plan.name == "bare slope";
  }
  return runs;
}

}  // namespace berm::bench
