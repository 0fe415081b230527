#include "simulated_run.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "berm/core/error.hpp"
#include "berm/io/label_file.hpp"
#include "berm/io/recording.hpp"
#include "berm/io/settings.hpp"
#include "berm/sim/scenario.hpp"
#include "berm/sim/sensor.hpp"
#include "berm/sim/simulate.hpp"
#include "temp_folder.hpp"

namespace berm::test {
namespace {

sim::Scenario make_scenario(const RunPlan& plan, const SimulatorFolders& folders) {
  sim::Scenario scenario = sim::read_scenario(folders.scenarios / (plan.scenario + ".yaml"));
  for (const std::string& setting : plan.settings) {
    (void)set_value(scenario, setting, plan.name);
  }
  scenario.scenario.seconds = plan.seconds;
  scenario.check();
  return scenario;
}

double slope_deg(const Pose& T_world_base) {
  const Eigen::Vector3d forward = T_world_base.rotation() * Eigen::Vector3d::UnitX();
  return std::asin(std::clamp(forward.z(), -1.0, 1.0)) * 180.0 / std::numbers::pi;
}

void measure_slopes(const Recording& recording, SimulatedRun& run) {
  std::optional<Trajectory> truth = recording.read_truth_poses();
  if (!truth || truth->empty()) {
    throw Error(ErrorCode::invalid_argument, recording.path().string() + " has no true poses");
  }
  run.min_slope_deg = 90.0;
  run.max_slope_deg = -90.0;
  for (const StampedPose& pose : truth->poses()) {
    run.min_slope_deg = std::min(run.min_slope_deg, slope_deg(pose.T_world_base));
    run.max_slope_deg = std::max(run.max_slope_deg, slope_deg(pose.T_world_base));
  }
  run.truth = std::move(*truth);
}

}  // namespace

SimulatedRun simulate_run(const RunPlan& plan, const SimulatorFolders& folders) {
  const TempFolder folder;
  const sim::Scenario scenario = make_scenario(plan, folders);
  sim::SimulateOptions options;
  options.output = folder.path() / "recording";
  options.seed = plan.seed;
  (void)sim::simulate(scenario, sim::read_sensor(folders.sensors / (plan.sensor + ".yaml")), options);

  const Recording recording = Recording::open(options.output);
  SimulatedRun run;
  run.scans.resize(recording.size());
  for (std::size_t i = 0; i < recording.size(); ++i) {
    LabelledScan& labelled = run.scans[i];
    recording.read(i, labelled.scan);
    labelled.scan.T_base_sensor = scenario.mount.T_base_sensor();
    labelled.truth = read_labels(recording.scan(i).truth_labels.value(), labelled.scan.cloud.size());
  }
  measure_slopes(recording, run);
  return run;
}

}  // namespace berm::test
