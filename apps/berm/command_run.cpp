#include <algorithm>
#include <memory>
#include <numbers>
#include <thread>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include "berm/core/error.hpp"
#include "berm/io/recording.hpp"
#include "berm/pipeline/run.hpp"
#include "berm/pipeline/sensor_sheet.hpp"
#include "commands.hpp"
#include "console.hpp"
#include "exit_code.hpp"
#include "machine_option.hpp"
#include "make_report.hpp"
#include "progress_bar.hpp"
#include "signals.hpp"

namespace berm::app {
namespace {

constexpr const char* kRunExamples = R"(Examples:
  berm run recording --machine car -o out
  berm run recording -m groomer -o out --method piste=reference --method snow=reference
  berm run recording -m my_truck.yaml -o out --set mount.height_m=3.8 --first 100 --count 50
  berm run recording -m haul_truck -o out --poses ins.nmea --map yesterday/edges.ot
  berm run today -m groomer -o out --localize yesterday --start 12.5,-3,90

Writes out/labels/NAME.label for every scan, out/scans.csv with a line for each, out/boundary.csv with a piste method,
out/edge_points.csv with an edge method, out/trajectory.tum if there are poses or an odometry method, and out/run.json last; then the
page out/report.html, which shows all this. With an edge method and poses also the map of the road edges, out/edges.ot, and its lines, out/edges.csv, .geojson, .gpkg, .dxf.
With --localize also out/trajectory_map.tum, where the machine was in that map, and out/localization.csv, how sure that is.
Ends with 0 if everything was done, 3 if scans were skipped (run.json says which and why) or none could be located, 1 if it failed, 2 for wrong usage.)";

struct RunCommand {
  Console console;
  MachineOption machine;
  std::string recording;
  RunOptions options;
  std::size_t count = 0;
  bool map_surface = false;
  std::vector<double> start;
};

double percent(std::uint64_t part, std::uint64_t whole) {
  return whole == 0 ? 0.0 : 100.0 * static_cast<double>(part) / static_cast<double>(whole);
}

void report_map(const EdgeCounts& edges) {
  const auto km = [&edges](EdgeSide side) { return edges.lines_m[static_cast<std::size_t>(side)] * 1e-3; };
  spdlog::info("road edges: {:.2f} km left, {:.2f} km right; {} scans are in a map of {} voxels", km(EdgeSide::left),
               km(EdgeSide::right), edges.mapped, edges.voxels);
}

int report(const RunSummary& summary, const RunOptions& options) {
  const RunCounts& counts = summary.counts;
  const std::string output = options.output.string();
  if (summary.interrupted) {
    print_error(
        fmt::format("stopped by a signal after {} of {} scans: {} holds their labels and no run.json; run again "
                    "with --force",
                    counts.labelled + counts.skipped, counts.selected, output));
    return kSignalBase + received_signal();
  }
  for (const std::string& note : summary.notes) {
    spdlog::info("note: {}", note);
  }
  for (const SkippedScan& scan : summary.skipped) {
    spdlog::warn("skipped scan {}: {}", scan.name, scan.reason);
  }
  const auto share = [&counts](std::uint64_t part) { return percent(part, counts.points); };
  spdlog::info(
      "{} scans, {} points: {:.1f} % drivable, {:.1f} % terrain, {:.1f} % obstacle, {:.1f} % falling snow, {:.1f} % no "
      "return, {} invalid -> {}",
      counts.labelled, counts.points, share(counts.drivable), share(counts.terrain), share(counts.obstacle),
      share(counts.falling_snow), share(counts.no_return), counts.invalid, output);
  if (summary.edges && summary.edges->has_map) {
    report_map(*summary.edges);
  }
  const auto& located = summary.localization;
  if (located) {
    spdlog::info("located in the map: {} of {} scans", located->located, located->scans);
  }
  if (counts.skipped > 0) {
    spdlog::warn("{} of {} scans were skipped, see {}/run.json", counts.skipped, counts.selected, output);
    return kWithLosses;
  }
  return located && located->located == 0 ? kWithLosses : kWhole;
}

/// The page about the run. The results stand without it.
void show(const Recording& recording, const RunOptions& options) {
  try {
    static_cast<void>(make_report(options.output, &recording));
  } catch (const Error& error) {
    spdlog::warn("no report was written: {}", error.what());
  }
}

/// X,Y,YAW or X,Y,Z,YAW: the height is that of the ground in the map either way.
Pose start_pose(const std::vector<double>& numbers) {
  const double yaw_rad = numbers.back() * std::numbers::pi / 180.0;
  const double z_m = numbers.size() == 4 ? numbers[2] : 0.0;
  return Pose::from_yaw_pitch_roll(yaw_rad, 0.0, 0.0, {numbers[0], numbers[1], z_m});
}

int execute(RunCommand& command) {
  command.console.start();
  ChosenMachine chosen = command.machine.choose();
  if (!command.start.empty()) {
    command.options.start = start_pose(command.start);
  }
  const Recording recording = Recording::open(command.recording);
  command.options.notes = adopt_sheet(chosen.machine, recording.sheet(), chosen.pinned);
  command.options.machine_file = chosen.file;
  chosen.machine.mapping.surface = chosen.machine.mapping.surface || command.map_surface;
  catch_signals();
  const RunSummary summary = [&] {
    ProgressBar bar(command.console.is_quiet());
    command.options.on_progress = [&bar](std::size_t done, std::size_t total) { bar.show(done, total); };
    command.options.should_stop = [] { return received_signal() != 0; };
    return run(recording, chosen.machine, command.options);
  }();
  if (!summary.interrupted) {
    show(recording, command.options);
  }
  return report(summary, command.options);
}

}  // namespace

void add_run(CLI::App& app, int& exit_code) {
  auto command = std::make_shared<RunCommand>();
  RunOptions& options = command->options;
  options.threads = std::max(1U, std::thread::hardware_concurrency());

  CLI::App* sub = app.add_subcommand("run", "Label the points of a recording");
  sub->footer(kRunExamples);
  sub->add_option("RECORDING", command->recording, "Sequence folder, KITTI folder, folder of scans, or one scan")
      ->required();
  command->machine.add_options(*sub, true);
  sub->add_option("-o,--output", options.output, "Folder for the results")->required()->type_name("FOLDER");
  sub->add_flag("--force", options.force, "Replace the results of an earlier run in that folder");
  sub->add_option("--threads", options.threads, "Scans worked on at a time; the results are the same for any number")
      ->check(CLI::Range(1, 1024))
      ->capture_default_str();
  sub->add_option("--first", options.first, "Index of the first scan, from 0")
      ->check(CLI::NonNegativeNumber)
      ->capture_default_str();
  auto* count = sub->add_option("--count", command->count, "Number of scans, else all")->check(CLI::PositiveNumber);
  sub->add_option("--poses", options.poses,
                  "Poses of the machine instead of those of the recording: .tum, .csv, .nmea, or KITTI's poses.txt")
      ->type_name("FILE");
  sub->add_option("--map", options.map, "Map of the road edges, edges.ot of an earlier run, that this one continues")
      ->type_name("FILE");
  sub->add_flag("--map-surface", command->map_surface,
                "Map the surface: out/map, map.pcd, elevation (mapping.surface)");
  sub->add_option("--terrain", options.terrain,
                  "Elevation model of the ground without snow (GeoTIFF or ESRI ASCII grid), to measure snow depth from")
      ->type_name("FILE");
  auto* localize = sub->add_option("--localize", options.localize,
                                   "Locate the machine in a map of the surface: folder of a run with --map-surface")
                       ->type_name("FOLDER");
  sub->add_option("--start", command->start,
                  "Where in that map the machine is at the first scan, roughly; else from the poses of the recording")
      ->type_name("X,Y[,Z],YAW")
      ->delimiter(',')
      ->expected(3, 4)
      ->check(CLI::Range(-1e9, 1e9))
      ->needs(localize);
  command->console.add_options(*sub);
  sub->callback([command, count, &exit_code] {
    if (count->count() > 0) {
      command->options.count = command->count;
    }
    exit_code = execute(*command);
  });
}

}  // namespace berm::app
