// berm_long_run [--minutes N] [--scenario NAME] [--leg S | --standing] [--no-map | --map-own] [--places] [--bound MIB]:
// half an hour of a Mid-70 on a groomer that drives up and down one piste, or stands. Scans are simulated one after the
// other and never written: the chain labels each, the default odometry follows, a map of the surface in tiles is made
// on the disk, with true poses; --map-own takes those of the odometry, whose drift maps a place anew at every passing.
// Every minute it says how much memory is resident, how long a scan took, how far the pose is from the truth. Fails if
// ever more memory was resident than in the first five minutes, once up and down, and the bound on top.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <ctime>
#include <exception>
#include <filesystem>
#include <fstream>
#include <optional>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "berm/core/error.hpp"
#include "berm/core/stamp.hpp"
#include "berm/io/surface_folder.hpp"
#include "berm/odometry/pose_graph_places.hpp"
#include "berm/odometry/surface_odometry.hpp"
#include "berm/pipeline/machine.hpp"
#include "berm/pipeline/pipeline.hpp"
#include "berm/sim/scan_maker.hpp"
#include "berm/sim/scenario.hpp"
#include "berm/sim/simulate.hpp"
#include "support/temp_folder.hpp"

namespace berm::bench {
namespace {

namespace fs = std::filesystem;

struct LongRun {
  double minutes = 30.0;
  std::string scenario = "groomer_clear";
  std::uint64_t seed = 1;
  double leg_s = 135.0;  ///< up and down and two turns take five minutes
  bool is_standing = false;
  bool has_map = true;
  bool is_map_own = false;
  bool has_places = false;
  double bound_mib = 8.0;
};

/// By then everything that is kept was needed once.
constexpr std::size_t kRound_min = 5;
/// Scans between looks at the memory.
constexpr std::size_t kLook = 10;

double cpu_ms() {
  timespec time{};
  (void)clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return 1e3 * static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_nsec);
}

double resident_mib() {
  std::ifstream status("/proc/self/status");
  for (std::string line; std::getline(status, line);) {
    if (line.starts_with("VmRSS:")) {
      return std::stod(line.substr(6)) / 1024.0;
    }
  }
  throw Error(ErrorCode::invalid_argument, "/proc/self/status does not say how much memory is resident");
}

sim::Scenario make_scenario(const LongRun& plan) {
  sim::Scenario scenario = sim::read_scenario(fs::path(BERM_SCENARIOS) / (plan.scenario + ".yaml"));
  scenario.scenario.seconds = 60.0 * plan.minutes;
  scenario.traffic.oncoming = 0;  // they would stand where their way ends, on the piste
  if (plan.is_standing) {
    scenario.vehicle.speed_m_per_s = 0.0;
  } else {
    scenario.vehicle.leg_s = plan.leg_s;
  }
  scenario.check();
  return scenario;
}

/// The map of the surface while the machine drives.
class LiveMap final : public SurfaceStore {
 public:
  explicit LiveMap(const fs::path& folder)
      : tiles_(config(), Eigen::Vector3d::Zero(), *this),
        folder_(folder, {config().voxel_m, tiles_.tile_m(), Eigen::Vector3d::Zero()}) {}

  /// The machine moves evenly from `T_world_begin` to `T_world_end` in `duration_s`.
  void add(const Scan& scan, std::span<const Label> labels, const Pose& T_world_begin, const Pose& T_world_end,
           double duration_s) {
    const PointsView points = scan.cloud.view();
    const Vector6d displacement = (T_world_begin.inverse() * T_world_end).log();
    std::vector<Pose> T_world_sensor;
    for (std::size_t step = 0; step <= kSteps; ++step) {
      T_world_sensor.push_back(T_world_begin * Pose::exp(static_cast<double>(step) / kSteps * displacement) *
                               scan.T_base_sensor);
    }
    scan_.sensor_m = T_world_sensor[kSteps / 2].translation_m();
    scan_.samples.clear();
    ends_m_.clear();
    for (std::size_t i = 0; i < labels.size(); ++i) {
      if (labels[i] == Label::no_return || labels[i] == Label::unlabeled) {
        continue;
      }
      const double share = duration_s > 0.0 ? double{points.time[i]} / duration_s : 0.0;
      const auto step = static_cast<std::size_t>(std::clamp(share, 0.0, 1.0) * kSteps + 0.5);
      const Eigen::Vector3d in_sensor_m(points.x[i], points.y[i], points.z[i]);
      ends_m_.push_back(T_world_sensor[step] * in_sensor_m);
      if (labels[i] != Label::falling_snow && in_sensor_m.norm() <= config().max_range_m) {
        scan_.samples.push_back({ends_m_.back(), points.intensity[i], labels[i]});
      }
    }
    scan_.beams.resize(1);
    scan_.beams[0].set(scan_.sensor_m, ends_m_);
    tiles_.add(scan_);
  }

  [[nodiscard]] std::size_t voxels_in_memory() const { return tiles_.voxels_in_memory(); }

  std::vector<SurfacePoint> load(const TileKey& key) override { return folder_.load(key); }
  void save(const TileKey& key, std::span<const SurfacePoint> points) override { folder_.save(key, points); }
  void commit() override { folder_.commit(); }

 private:
  static constexpr std::size_t kSteps = 20;

  static SurfaceMapConfig config() {
    SurfaceMapConfig config;
    config.surface = true;
    return config;
  }

  SurfaceTiles tiles_;
  SurfaceFolder folder_;
  SurfaceScan scan_;
  std::vector<Eigen::Vector3d> ends_m_;
};

/// What a minute was like.
struct Minute {
  std::vector<double> odometry_ms;
  double labels_ms = 0.0;
  double map_ms = 0.0;
  std::size_t unsure = 0;   ///< scans that were weak or lost
  double memory_mib = 0.0;  ///< at most

  void print(std::size_t number, double off_m, std::size_t voxels) {
    std::sort(odometry_ms.begin(), odometry_ms.end());
    const auto scans = static_cast<double>(odometry_ms.size());
    double sum_ms = 0.0;
    for (const double time_ms : odometry_ms) {
      sum_ms += time_ms;
    }
    fmt::print("| {:6} | {:9.1f} | {:6.2f} | {:8.2f} | {:7.2f} | {:4.2f} | {:8} | {:6.3f} | {:6} |\n", number,
               memory_mib, labels_ms / scans, sum_ms / scans, odometry_ms[odometry_ms.size() * 99 / 100],
               map_ms / scans, voxels, off_m, unsure);
    std::fflush(stdout);
    *this = Minute();
  }
};

/// Distance of the pose from the truth, both as seen from a scan after the start.
class Drift {
 public:
  double add(const Pose& estimate, const Pose& truth) {
    if (!T_truth_estimate_) {
      T_truth_estimate_ = truth * estimate.inverse();
    }
    return (*T_truth_estimate_ * estimate.translation_m() - truth.translation_m()).norm();
  }

 private:
  std::optional<Pose> T_truth_estimate_;
};

/// MiB by which memory ever grew beyond that of the first round.
double drive_long(const LongRun& plan) {
  const sim::Scenario scenario = make_scenario(plan);
  const sim::Sensor sensor = sim::read_sensor(fs::path(BERM_SENSORS) / (scenario.scenario.sensor + ".yaml"));
  sim::World world = sim::build_world(scenario, plan.seed);
  const Trajectory truth = sim::drive(world, scenario.vehicle, scenario.scenario.seconds, plan.seed);
  const sim::RayCaster caster(world, sim::RayCasterConfig{});
  const sim::Weather weather(scenario.snowfall, sensor.optics, world.plumes, plan.seed);
  const sim::ScanMaker maker(sensor, scenario.mount.T_base_sensor(), caster, weather, truth, plan.seed);

  Pipeline pipeline(read_machine(fs::path(BERM_MACHINES) / "groomer.yaml"));
  SurfaceOdometry odometry({});
  PlaceMemory places;
  const test::TempFolder folder;
  LiveMap map(folder.path());
  const auto scans_a_minute = static_cast<std::size_t>(std::lround(60.0 * sensor.pattern.scan_hz));
  const auto minutes = static_cast<std::size_t>(std::lround(plan.minutes));
  fmt::print(
      "| minute | resident, MiB | labels, ms | odometry, ms | p99, ms | map, ms | voxels | off truth, m | weak or lost "
      "|\n"
      "|---:|---:|---:|---:|---:|---:|---:|---:|---:|\n");
  sim::MadeScan made;
  Minute minute;
  Drift drift;
  double first_mib = 0.0;
  double later_mib = 0.0;
  for (std::size_t i = 0; i < minutes * scans_a_minute; ++i) {
    maker.make(i, made);
    Scan scan{
        .stamp_ns = made.stamp_ns, .cloud = PointCloud(made.points), .T_base_sensor = scenario.mount.T_base_sensor()};
    const double begin_ms = cpu_ms();
    const ScanResult labelled = pipeline.process(scan);
    const double labelled_ms = cpu_ms();
    const OdometryInput input{.points = scan.cloud.view(),
                              .labels = labelled.labels,
                              .stamp_ns = scan.stamp_ns,
                              .T_base_sensor = scan.T_base_sensor};
    const OdometryResult result = odometry.process(input);
    const double followed_ms = cpu_ms();
    const bool is_known = result.health == OdometryHealth::good || result.health == OdometryHealth::weak;
    if (plan.has_places) {
      places.add(i, input, result);
    }
    const double mapping_ms = cpu_ms();
    if (is_known && plan.has_map) {
      const Stamp end_ns = scan.stamp_ns + from_seconds(result.duration_s);
      map.add(scan, labelled.labels, plan.is_map_own ? result.T_world_begin : *truth.at(scan.stamp_ns),
              plan.is_map_own ? result.T_world_end : *truth.at(end_ns), result.duration_s);
    }
    minute.map_ms += cpu_ms() - mapping_ms;
    minute.labels_ms += labelled_ms - begin_ms;
    minute.odometry_ms.push_back(followed_ms - labelled_ms);
    minute.unsure += result.health == OdometryHealth::weak || result.health == OdometryHealth::lost ? 1U : 0U;
    const double off_m = is_known ? drift.add(result.T_world_begin, *truth.at(scan.stamp_ns)) : 0.0;
    if (i % kLook == 0) {
      minute.memory_mib = std::max(minute.memory_mib, resident_mib());
    }
    if ((i + 1) % scans_a_minute == 0) {
      const std::size_t number = (i + 1) / scans_a_minute;
      double& most_mib = number <= kRound_min ? first_mib : later_mib;
      most_mib = std::max(most_mib, minute.memory_mib);
      minute.print(number, off_m, map.voxels_in_memory());
    }
  }
  return std::max(0.0, later_mib - first_mib);
}

}  // namespace
}  // namespace berm::bench

int main(int argc, char** argv) {
  CLI::App app("Memory, time and drift of a long run");
  berm::bench::LongRun plan;
  app.add_option("--minutes", plan.minutes, "how long, at least 6");
  app.add_option("--scenario", plan.scenario, "scenario of a groomer");
  app.add_option("--seed", plan.seed, "of the simulation");
  app.add_option("--leg", plan.leg_s, "it turns back after so many seconds");
  app.add_flag("--standing", plan.is_standing, "it stands");
  app.add_flag("!--no-map", plan.has_map, "without the map of the surface");
  app.add_flag("--map-own", plan.is_map_own, "the map is made with the poses of the odometry, not with true ones");
  app.add_flag("--places", plan.has_places, "keep the places that the pose graph looks for as well");
  app.add_option("--bound", plan.bound_mib, "MiB by which memory may grow after the first five minutes");
  CLI11_PARSE(app, argc, argv);
  try {
    const double growth_mib = berm::bench::drive_long(plan);
    const bool is_flat = growth_mib <= plan.bound_mib;
    fmt::print("\nMemory grew by {:.1f} MiB after the first {} minutes; bound {} MiB: {}\n", growth_mib,
               berm::bench::kRound_min, plan.bound_mib, is_flat ? "met" : "missed");
    return is_flat ? 0 : 1;
  } catch (const std::exception& error) {
    fmt::print(stderr, "berm_long_run: {}\n", error.what());
    return 1;
  }
}
