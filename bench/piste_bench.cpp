#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include <benchmark/benchmark.h>

#include "berm/io/recording.hpp"
#include "berm/pipeline/pipeline.hpp"
#include "berm/sim/scenario.hpp"
#include "berm/sim/sensor.hpp"
#include "berm/sim/simulate.hpp"
#include "support/temp_folder.hpp"

namespace berm::bench {
namespace {

namespace fs = std::filesystem;

/// A groomer's second on a piste: ten scans of 10,000 points in other places of the rosette.
std::vector<Scan> make_scans(const std::string& scenario_name, const std::string& sensor_name) {
  const test::TempFolder folder;
  sim::Scenario scenario = sim::read_scenario(fs::path(BERM_SCENARIOS) / (scenario_name + ".yaml"));
  scenario.scenario.seconds = 1.0;
  const sim::Sensor sensor = sim::read_sensor(fs::path(BERM_SENSORS) / (sensor_name + ".yaml"));
  sim::SimulateOptions options;
  options.output = folder.path() / "recording";
  (void)sim::simulate(scenario, sensor, options);
  const Recording recording = Recording::open(options.output);
  std::vector<Scan> scans(recording.size());
  for (std::size_t i = 0; i < scans.size(); ++i) {
    recording.read(i, scans[i]);
    scans[i].T_base_sensor = scenario.mount.T_base_sensor();
  }
  return scans;
}

void append(PointChannels& to, const PointsView& from) {
  to.x.insert(to.x.end(), from.x.begin(), from.x.end());
  to.y.insert(to.y.end(), from.y.begin(), from.y.end());
  to.z.insert(to.z.end(), from.z.begin(), from.z.end());
  to.intensity.insert(to.intensity.end(), from.intensity.begin(), from.intensity.end());
  to.time.insert(to.time.end(), from.time.begin(), from.time.end());
}

/// One scan of as many points as `copies` scans have: what a sensor of that many more beams would send.
Scan join(const std::vector<Scan>& scans, std::size_t copies) {
  PointChannels channels;
  for (std::size_t i = 0; i < copies; ++i) {
    append(channels, scans[i % scans.size()].cloud.view());
  }
  Scan joined;
  joined.T_base_sensor = scans.front().T_base_sensor;
  joined.cloud = PointCloud(std::move(channels));
  return joined;
}

/// `copies`: 1 for the scans as they are, more for one that joins so many.
const std::vector<Scan>& scans_of(const std::string& scenario, const std::string& sensor, std::size_t copies) {
  static std::map<std::string, std::vector<Scan>> made;
  const std::string key = scenario + "/" + sensor + "/" + std::to_string(copies);
  if (const auto found = made.find(key); found != made.end()) {
    return found->second;
  }
  std::vector<Scan> scans = make_scans(scenario, sensor);
  if (copies > 1) {
    Scan joined = join(scans, copies);
    scans.clear();
    scans.push_back(std::move(joined));
  }
  return made.emplace(key, std::move(scans)).first->second;
}

/// What each stage of the chain takes, one scan after the other; stages that come before are done outside the clock.
void run_stage(benchmark::State& state, const std::string& method, const std::string& stage,
               const std::string& scenario, const std::string& sensor, std::size_t copies) {
  const std::vector<Scan>& scans = scans_of(scenario, sensor, copies);
  Machine machine;
  machine.methods.snow = machine.methods.piste = method;
  const auto snow = make_snow(machine);
  const auto piste = make_piste(machine);
  SeriesRepair repair;
  struct Prepared {
    std::vector<std::uint8_t> falling;
    std::vector<Label> labels;
    HeightGrid surface;
  };
  std::vector<Prepared> prepared;
  {
    Machine until_ground = machine;
    until_ground.methods.piste = "none";
    Pipeline pipeline(until_ground);
    for (const Scan& scan : scans) {
      const SnowResult flakes = snow->process(scan.cloud.view(), scan.T_base_sensor);
      const ScanResult result = pipeline.process(scan);
      prepared.push_back({{flakes.falling.begin(), flakes.falling.end()},
                          {result.labels.begin(), result.labels.end()},
                          *result.surface});
    }
  }
  std::size_t index = 0;
  std::int64_t points = 0;
  for (auto _ : state) {
    const Scan& scan = scans[index];
    const Prepared& ready = prepared[index];
    const PointsView view = scan.cloud.view();
    if (stage == "snow") {
      benchmark::DoNotOptimize(snow->process(view, scan.T_base_sensor).count);
    } else {
      PisteInput input{.points = view,
                       .labels = ready.labels,
                       .series = {},
                       .surface = &ready.surface,
                       .T_base_sensor = scan.T_base_sensor};
      if (piste->needs_series()) {
        input.series = repair.process(view, ready.falling);
      }
      benchmark::DoNotOptimize(piste->process(input).labels.data());
    }
    points += static_cast<std::int64_t>(view.size());
    index = (index + 1) % scans.size();
  }
  state.SetItemsProcessed(points);
}

/// Snow, ground and piste together.
void run_chain(benchmark::State& state, const std::string& method, const std::string& scenario,
               const std::string& sensor) {
  const std::vector<Scan>& scans = scans_of(scenario, sensor, 1);
  Machine machine;
  machine.methods.snow = machine.methods.piste = method;
  Pipeline pipeline(machine);
  std::size_t index = 0;
  for (auto _ : state) {
    benchmark::DoNotOptimize(pipeline.process(scans[index]).labels.data());
    index = (index + 1) % scans.size();
  }
}

const bool kRegistered = [] {
  const auto add = [](const std::string& scenario, const std::string& sensor) {
    for (const std::string method : {"default", "reference"}) {
      const std::string place = method + "/" + scenario + "/" + sensor;
      for (const std::string stage : {"snow", "piste"}) {
        benchmark::RegisterBenchmark(("groomer/" + stage + "/" + place).c_str(), run_stage, method, stage, scenario,
                                     sensor, std::size_t{1})
            ->Unit(benchmark::kMicrosecond);
      }
      benchmark::RegisterBenchmark(("groomer/chain/" + place).c_str(), run_chain, method, scenario, sensor)
          ->Unit(benchmark::kMicrosecond);
    }
  };
  add("groomer_clear", "livox_mid70");
  add("groomer_snowfall", "livox_mid70");
  add("groomer_night_storm", "livox_mid70");
  add("groomer_clear", "hdl64e");
  for (const std::size_t copies : {std::size_t{10}, std::size_t{100}}) {
    for (const std::string method : {"default", "reference"}) {
      for (const std::string stage : {"snow", "piste"}) {
        const std::string name =
            "groomer/" + stage + "/" + method + "/groomer_snowfall/" + std::to_string(copies) + "x";
        benchmark::RegisterBenchmark(name.c_str(), run_stage, method, stage, "groomer_snowfall", "livox_mid70", copies)
            ->Unit(benchmark::kMicrosecond);
      }
    }
  }
  return true;
}();

}  // namespace
}  // namespace berm::bench
