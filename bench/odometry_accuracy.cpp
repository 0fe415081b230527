// berm_odometry_accuracy [--seed-offset N] [--runs-only]: simulates drives with truth, labels them with the chain of
// their machine, and measures where the odometry is: the default beside the published method, drive by drive, and the
// default with each part switched off in turn. scripts/odometry_table.sh writes docs/odometry_table.md with it.

#include <algorithm>
#include <cmath>
#include <ctime>
#include <exception>
#include <functional>
#include <memory>
#include <numeric>
#include <optional>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "berm/eval/trajectory_metrics.hpp"
#include "berm/odometry/feature_odometry.hpp"
#include "berm/odometry/surface_odometry.hpp"
#include "berm/pipeline/machine.hpp"
#include "berm/pipeline/pipeline.hpp"
#include "odometry_runs.hpp"

namespace berm::bench {
namespace {

constexpr double kLengths_m[] = {10.0, 25.0, 50.0};

using MakeOdometry = std::function<std::unique_ptr<Odometry>()>;

struct Method {
  std::string name;
  MakeOdometry make;
};

/// A drive, and what the stages before the odometry say of it.
struct Drive {
  std::string name;
  bool is_bare = false;
  test::SimulatedRun run;
  std::vector<std::vector<Label>> labels;
  double labels_ms = 0.0;  ///< of CPU a scan
};

struct Figures {
  double drift_percent = NAN;
  double ate_m = NAN;
  double mean_ms = 0.0;
  double p99_ms = 0.0;
  double weak_share = 0.0;
  double lost_share = 0.0;
};

double cpu_ms() {
  timespec time{};
  (void)clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return 1e3 * static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_nsec);
}

Drive make_drive(const OdometryRun& plan) {
  Drive drive{.name = plan.plan.name,
              .is_bare = plan.is_bare,
              .run = test::simulate_run(plan.plan, {.scenarios = BERM_SCENARIOS, .sensors = BERM_SENSORS})};
  Pipeline pipeline(read_machine(std::filesystem::path(BERM_MACHINES) / (plan.machine + ".yaml")));
  const double start_ms = cpu_ms();
  for (const test::LabelledScan& scan : drive.run.scans) {
    const ScanResult result = pipeline.process(scan.scan);
    drive.labels.emplace_back(result.labels.begin(), result.labels.end());
  }
  drive.labels_ms = (cpu_ms() - start_ms) / static_cast<double>(drive.run.scans.size());
  return drive;
}

Trajectory as_trajectory(const Drive& drive, const std::vector<Pose>& poses) {
  Trajectory trajectory;
  for (std::size_t i = 0; i < poses.size(); ++i) {
    trajectory.append(drive.run.scans[i].scan.stamp_ns, poses[i]);
  }
  return trajectory;
}

Figures follow(const Drive& drive, const MakeOdometry& make) {
  const std::unique_ptr<Odometry> odometry = make();
  std::vector<Pose> poses;
  std::vector<double> times_ms;
  Figures figures;
  for (std::size_t i = 0; i < drive.run.scans.size(); ++i) {
    const Scan& scan = drive.run.scans[i].scan;
    const double start_ms = cpu_ms();
    const OdometryResult result = odometry->process({.points = scan.cloud.view(),
                                                     .labels = drive.labels[i],
                                                     .stamp_ns = scan.stamp_ns,
                                                     .T_base_sensor = scan.T_base_sensor});
    times_ms.push_back(cpu_ms() - start_ms);
    std::copy(result.revised.begin(), result.revised.end(),
              poses.end() - static_cast<std::ptrdiff_t>(result.revised.size()));
    poses.push_back(result.T_world_begin);
    figures.weak_share += result.health == OdometryHealth::weak ? 1.0 : 0.0;
    figures.lost_share += result.health == OdometryHealth::lost ? 1.0 : 0.0;
  }
  const auto scans = static_cast<double>(poses.size());
  figures.weak_share /= scans;
  figures.lost_share /= scans;
  figures.mean_ms = std::accumulate(times_ms.begin(), times_ms.end(), 0.0) / scans;
  std::sort(times_ms.begin(), times_ms.end());
  figures.p99_ms = times_ms[times_ms.size() * 99 / 100];
  const auto pairs = pair_poses(as_trajectory(drive, poses), drive.run.truth);
  const auto drift = mean_error(relative_errors(pairs, kLengths_m));
  figures.drift_percent = drift ? drift->translation_percent : NAN;
  figures.ate_m = absolute_error_m(pairs).value_or(NAN);
  return figures;
}

Method surface(const std::string& name, const SurfaceOdometryConfig& config) {
  return {name, [config] { return std::make_unique<SurfaceOdometry>(config); }};
}

Method feature(const std::string& name, const FeatureOdometryConfig& config) {
  return {name, [config] { return std::make_unique<FeatureOdometry>(config); }};
}

std::vector<Method> parts_off() {
  SurfaceOdometryConfig no_map_size;
  no_map_size.wide_voxel_m = no_map_size.coarse_voxel_m;
  return {surface("default", {}),
          surface("without deskew", {.deskew = false}),
          surface("without find_start", {.find_start = false}),
          surface("without use_shapes", {.use_shapes = false}),
          surface("wide voxels as the coarse ones", no_map_size),
          surface("every point a fact", {.points_per_fact = 1.0}),
          surface("no prior: 100 m/s2, 100 rad/s2", {.acceleration_mps2 = 100.0, .turn_acceleration_rps2 = 100.0}),
          surface("half the samples", {.sample_spacing_m = 0.5, .max_samples = 1250.0})};
}

void print_row(const Drive& drive, const std::string& method, const Figures& figures) {
  fmt::print("| {:<26} | {:<9} | {:6.0f} | {:6.2f} | {:7.3f} | {:5.1f} | {:5.1f} | {:5.1f} | {:5.1f} | {:4.1f} |\n",
             drive.name, method, path_length_m(pair_poses(drive.run.truth, drive.run.truth)), figures.drift_percent,
             figures.ate_m, 100.0 * figures.weak_share, 100.0 * figures.lost_share, figures.mean_ms, figures.p99_ms,
             drive.labels_ms);
  std::fflush(stdout);
}

void print_runs(const std::vector<Drive>& drives, bool with_reference) {
  fmt::print(
      "| drive | method | m | drift, % | ATE, m | weak, % | lost, % | ms | p99, ms | labels, ms |\n"
      "|:---|:---|---:|---:|---:|---:|---:|---:|---:|---:|\n");
  for (const Drive& drive : drives) {
    print_row(drive, "default", follow(drive, surface("default", {}).make));
    if (with_reference) {
      FeatureOdometryConfig config;
      config.pieces = drive.run.scans.front().scan.cloud.view().ring.empty() ? config.pieces : 1;
      print_row(drive, "reference", follow(drive, feature("reference", config).make));
    }
  }
}

/// Of all drives but the bare slope, which nothing can know.
void print_parts(const std::vector<Drive>& drives) {
  fmt::print("\n| default | mean drift, % | worst, % | ms |\n|:---|---:|---:|---:|\n");
  for (const Method& method : parts_off()) {
    double sum_percent = 0.0;
    double worst_percent = 0.0;
    double sum_ms = 0.0;
    double count = 0.0;
    for (const Drive& drive : drives) {
      if (!drive.is_bare) {
        const Figures figures = follow(drive, method.make);
        sum_percent += figures.drift_percent;
        worst_percent = std::max(worst_percent, figures.drift_percent);
        sum_ms += figures.mean_ms;
        count += 1.0;
      }
    }
    fmt::print("| {:<32} | {:6.3f} | {:6.2f} | {:5.1f} |\n", method.name, sum_percent / count, worst_percent,
               sum_ms / count);
    std::fflush(stdout);
  }
}

}  // namespace
}  // namespace berm::bench

int main(int argc, char** argv) {
  CLI::App app("Drift of the odometry on simulated drives");
  std::uint64_t seed_offset = 0;
  bool runs_only = false;
  bool no_reference = false;
  app.add_option("--seed-offset", seed_offset, "added to the seed of every drive");
  app.add_flag("--runs-only", runs_only, "leave out the table of parts switched off");
  app.add_flag("--no-reference", no_reference, "leave out the published method, which is slow");
  CLI11_PARSE(app, argc, argv);
  try {
    std::vector<berm::bench::Drive> drives;
    for (const auto& plan : berm::bench::odometry_runs(seed_offset)) {
      drives.push_back(berm::bench::make_drive(plan));
    }
    berm::bench::print_runs(drives, !no_reference);
    if (!runs_only) {
      berm::bench::print_parts(drives);
    }
  } catch (const std::exception& error) {
    fmt::print(stderr, "berm_odometry_accuracy: {}\n", error.what());
    return 1;
  }
  return 0;
}
