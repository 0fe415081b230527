#include "berm/sim/simulate.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "berm/core/error.hpp"
#include "berm/core/ordered_parallel.hpp"
#include "berm/io/height_raster.hpp"
#include "berm/io/label_file.hpp"
#include "berm/sim/build_world.hpp"
#include "berm/sim/scan_maker.hpp"
#include "recording_writer.hpp"

namespace berm::sim {
namespace {

std::size_t count_scans(const Scenario& scenario, const Sensor& sensor) {
  const double scans = std::floor(scenario.scenario.seconds * sensor.pattern.scan_hz + 1e-9);
  if (scans < 1.0) {
    throw ConfigError("scenario.seconds",
                      fmt::format("{} s leave no scan, expected at least {} s, the time that one takes",
                                  scenario.scenario.seconds, 1.0 / sensor.pattern.scan_hz));
  }
  return static_cast<std::size_t>(scans);
}

bool is_in_the_air(std::uint32_t label) {
  const std::uint32_t id = semantic_class(label);
  return id == truth::kFallingSnow || id == truth::kDust;
}

double length_of(const Trajectory& path) {
  double length_m = 0.0;
  for (std::size_t i = 1; i < path.size(); ++i) {
    const Eigen::Vector3d moved_m =
        path.poses()[i].T_world_base.translation_m() - path.poses()[i - 1].T_world_base.translation_m();
    length_m += moved_m.head<2>().norm();
  }
  return length_m;
}

/// Makes one recording, see `simulate`.
class Simulation {
 public:
  Simulation(const Scenario& scenario, const Sensor& sensor, const SimulateOptions& options)
      : scenario_(scenario), sensor_(sensor), options_(options) {
    scenario.check();
    sensor.check();
    summary_.selected = count_scans(scenario, sensor);
  }

  SimulateSummary make() {
    OutputFolder folder(options_.output, options_.force, recording_results());
    const RecordingWriter writer(folder);
    tell("building the world");
    const World world = build_world(scenario_, options_.seed);
    const Trajectory driven = drive(world, scenario_.vehicle, scenario_.scenario.seconds, options_.seed);
    summary_.driven_m = length_of(driven);
    const RayCaster caster(world, RayCasterConfig{});
    const Weather weather(scenario_.snowfall, sensor_.optics, world.plumes, options_.seed);
    const ScanMaker maker(sensor_, scenario_.mount.T_base_sensor(), caster, weather, driven, options_.seed);
    maker.check_start(*world.terrain);
    tell(fmt::format("making {} scans", summary_.selected));
    make_scans(maker, writer);
    if (summary_.interrupted) {
      return summary_;
    }
    writer.write_scan_times(stamps_);
    writer.write_poses(driven, measure_gnss(driven, scenario_.gnss, options_.seed));
    writer.write_world(world, driven);
    writer.write_settings(scenario_, sensor_, options_.seed, world);
    folder.finish();
    return summary_;
  }

 private:
  /// A scan on its way: made and written by one thread, counted by the calling one.
  struct Job {
    MadeScan scan;
    std::uint64_t returns = 0;
    std::uint64_t in_the_air = 0;
  };

  void tell(const std::string& stage) const {
    if (options_.on_stage) {
      options_.on_stage(stage);
    }
  }

  void make_scans(const ScanMaker& maker, const RecordingWriter& writer) {
    OrderedParallel<Job> work(
        summary_.selected, std::max<std::size_t>(1, options_.threads),
        [&](std::size_t /*worker*/, std::size_t index, Job& job) {
          maker.make(index, job.scan);
          writer.write_scan(index, job.scan);
          count(job);
        },
        [this](std::size_t index, const Job& job) { return keep(index, job); });
    work.run();
  }

  static void count(Job& job) {
    const PointChannels& points = job.scan.points;
    job.returns = 0;
    job.in_the_air = 0;
    for (std::size_t i = 0; i < points.x.size(); ++i) {
      if (!is_no_return(points.x[i], points.y[i], points.z[i])) {
        ++job.returns;
        job.in_the_air += is_in_the_air(job.scan.labels[i]) ? 1U : 0U;
      }
    }
  }

  bool keep(std::size_t index, const Job& job) {
    stamps_.push_back(job.scan.stamp_ns);
    ++summary_.scans;
    summary_.beams += job.scan.beams;
    summary_.returns += job.returns;
    summary_.in_the_air += job.in_the_air;
    if (options_.on_progress) {
      options_.on_progress(index + 1, summary_.selected);
    }
    summary_.interrupted = index + 1 < summary_.selected && options_.should_stop && options_.should_stop();
    return !summary_.interrupted;
  }

  const Scenario& scenario_;
  const Sensor& sensor_;
  const SimulateOptions& options_;
  std::vector<Stamp> stamps_;
  SimulateSummary summary_;
};

}  // namespace

World build_world(const Scenario& scenario, std::uint64_t seed) {
  std::optional<HeightRaster> elevation;
  if (!scenario.world.elevation.empty()) {
    elevation = read_height_raster(scenario.world.elevation);
  }
  return build_world(scenario, elevation, seed);
}

SimulateSummary simulate(const Scenario& scenario, const Sensor& sensor, const SimulateOptions& options) {
  return Simulation(scenario, sensor, options).make();
}

}  // namespace berm::sim
