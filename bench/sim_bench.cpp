#include <cmath>
#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include <benchmark/benchmark.h>

#include "berm/sim/build_world.hpp"
#include "berm/sim/scan_maker.hpp"

namespace berm::bench {
namespace {

using sim::MadeScan;
using sim::RayCaster;
using sim::ScanMaker;
using sim::Sensor;
using sim::SnowfallConfig;
using sim::Weather;
using sim::World;

constexpr double kRate_hz = 100.0;

/// A world of 1 km, cast, and a machine that drives through it.
struct Course {
  explicit Course(const std::string& kind) {
    sim::WorldPlan plan;
    plan.world.kind = kind;
    plan.route.length_m = 1000.0;
    world = sim::build_world(plan, {}, 1);
    caster = std::make_unique<RayCaster>(world, sim::RayCasterConfig{});
    const double speed_m_per_s = 1.5;
    const int samples = static_cast<int>((world.route.length_m() - 20.0) / speed_m_per_s * kRate_hz);
    for (int i = 0; i < samples; ++i) {
      const double t = i / kRate_hz;
      const sim::RoutePoint at = world.route.at(10.0 + speed_m_per_s * t);
      const double heave_m = 0.015 * std::sin(6.0 * t);
      const double height_m = world.terrain->at(at.x_m, at.y_m).height_m;
      const double ahead_m =
          world.terrain->at(at.x_m + 4.0 * std::cos(at.heading_rad), at.y_m + 4.0 * std::sin(at.heading_rad)).height_m;
      const double pitch_rad = std::atan2(height_m - ahead_m, 4.0) + 0.007 * std::sin(6.5 * t);
      trajectory.append(from_seconds(t), Pose::from_yaw_pitch_roll(at.heading_rad, pitch_rad, 0.005 * std::sin(5.0 * t),
                                                                   {at.x_m, at.y_m, height_m + heave_m}));
    }
  }

  World world;
  std::unique_ptr<RayCaster> caster;
  Trajectory trajectory;
};

const Course& course(const std::string& kind) {
  static std::map<std::string, Course> courses;
  const auto found = courses.find(kind);
  return found != courses.end() ? found->second : courses.emplace(kind, kind).first->second;
}

Sensor sensor_of(const std::string& name) {
  return sim::read_sensor(std::filesystem::path(BERM_SENSORS) / (name + ".yaml"));
}

/// What the air holds, by name: nothing; the snowfall of scenarios/groomer_snowfall.yaml, which one beam in twenty
/// meets; dust everywhere; both, and snow that blows along the ground: all that the air can do to a beam at once.
Weather weather_of(const std::string& air, const Sensor& sensor, const Course& at) {
  SnowfallConfig snowfall;
  std::vector<sim::Plume> plumes;
  if (air == "snowfall" || air == "everything") {
    snowfall.flakes_per_m3 = 130.0;
  }
  if (air == "everything") {
    snowfall.drift_flakes_per_m3 = 200.0;
  }
  if (air == "dust" || air == "everything") {
    for (double s_m = 0.0; s_m < at.world.route.length_m(); s_m += 20.0) {
      const sim::RoutePoint here = at.world.route.at(s_m);
      plumes.push_back({{here.x_m, here.y_m, here.z_m + 1.0}, {4.0, 3.0, 1.2}, 0.1});
    }
  }
  return {snowfall, sensor.optics, plumes, 1};
}

/// Scans along the whole course. Footprints, crowns, nets, movers, relief and receiver are always on.
void make_scans(benchmark::State& state, const std::string& kind, const std::string& sensor_name,
                const std::string& air) {
  const Course& at = course(kind);
  const Sensor sensor = sensor_of(sensor_name);
  const Weather weather = weather_of(air, sensor, at);
  const Pose T_base_sensor = Pose::from_yaw_pitch_roll(0.0, 0.19, 0.0, {0.0, 0.0, 2.3});
  const ScanMaker maker(sensor, T_base_sensor, *at.caster, weather, at.trajectory, 1);
  const auto scans =
      static_cast<std::size_t>(to_seconds(at.trajectory.poses().back().stamp_ns) * sensor.pattern.scan_hz) - 1;
  MadeScan scan;
  std::int64_t beams = 0;

  std::size_t index = 0;
  for (auto _ : state) {
    maker.make(index, scan);
    beams += static_cast<std::int64_t>(scan.beams);
    index = (index + 1) % scans;
  }
  state.SetItemsProcessed(beams);
  const double made_s = static_cast<double>(state.iterations()) / sensor.pattern.scan_hz;
  state.counters["times_real"] = benchmark::Counter(made_s, benchmark::Counter::kIsRate);
  state.counters["memory_mib"] = static_cast<double>(at.caster->memory_bytes()) / (1024.0 * 1024.0);
}

void build_caster(benchmark::State& state, const std::string& kind) {
  const Course& at = course(kind);
  for (auto _ : state) {
    const RayCaster caster(at.world, {});
    benchmark::DoNotOptimize(caster.memory_bytes());
  }
}

const bool kRegistered = [] {
  const auto add = [](const std::string& kind, const std::string& sensor, const std::string& air) {
    const std::string name = "sim/" + kind + " " + air + "/" + sensor;
    benchmark::RegisterBenchmark(name.c_str(), make_scans, kind, sensor, air)->Unit(benchmark::kMillisecond);
  };
  add("piste", "livox_mid70", "clear");
  add("piste", "livox_mid70", "snowfall");
  add("piste", "livox_mid70", "everything");
  add("piste", "ouster64", "snowfall");
  add("haul_road", "livox_mid70", "clear");
  add("haul_road", "livox_mid70", "dust");
  add("haul_road", "vlp16", "clear");
  benchmark::RegisterBenchmark("sim_build/piste", build_caster, std::string("piste"))->Unit(benchmark::kMillisecond);
  return true;
}();

}  // namespace
}  // namespace berm::bench
