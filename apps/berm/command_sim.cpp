#include <algorithm>
#include <chrono>
#include <memory>
#include <optional>
#include <thread>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include "berm/core/error.hpp"
#include "berm/io/settings.hpp"
#include "berm/render/image.hpp"
#include "berm/render/png.hpp"
#include "berm/sim/photograph.hpp"
#include "berm/sim/simulate.hpp"
#include "commands.hpp"
#include "console.hpp"
#include "exit_code.hpp"
#include "progress_bar.hpp"
#include "signals.hpp"

namespace berm::app {
namespace {

constexpr const char* kSimExamples = R"(Examples:
  berm sim --list
  berm sim groomer_snowfall -o recording
  berm sim haul_road -o recording --seed 7 --seconds 60
  berm sim groomer_clear -o recording --sensor vlp16 --set mount.pitch_deg=5 --set vehicle.speed_m_per_s=2
  berm sim haul_road --picture road.png
  berm sim my_scenario.yaml -o recording --set world.elevation=dem.asc

Writes a sequence folder with its truth: scans/, labels/, times.txt, gnss.tum, truth.tum, edges.csv, terrain.asc,
scenario.yaml and sensor.yaml as they were used, and sequence.json last. The same scenario, sensor and seed give the
same bytes for any number of threads.)";

struct SimCommand {
  Console console;
  std::string scenario;
  std::string sensor;
  std::vector<std::string> values;
  std::optional<double> seconds;
  bool list = false;
  std::string picture;
  sim::SimulateOptions options;
};

/// Runs `body`; what it refuses was asked for on the command line.
template <typename Body>
auto as_usage(Body&& body) {
  try {
    return body();
  } catch (const ConfigError& error) {
    throw UsageError(error.what());
  }
}

int list_known() {
  const auto folders = sim::scenario_folders();
  std::string text;
  for (const std::string& name : sim::list_scenarios(folders)) {
    const auto file = sim::find_scenario(name, folders);
    text += fmt::format("{}\t{}\n", name, sim::read_scenario(file).scenario.description);
  }
  write_result("-", text);
  return kWhole;
}

sim::Scenario choose_scenario(const SimCommand& command) {
  const auto file = as_usage([&] { return sim::find_scenario(command.scenario, sim::scenario_folders()); });
  sim::Scenario scenario = sim::read_scenario(file);
  as_usage([&] {
    for (const std::string& value : command.values) {
      set_value(scenario, value, "--set " + value);
    }
    if (!command.sensor.empty()) {
      scenario.scenario.sensor = command.sensor;
    }
    if (command.seconds) {
      set_value(scenario, fmt::format("scenario.seconds={}", *command.seconds), "--seconds");
    }
    scenario.check();
  });
  return scenario;
}

double percent_of_beams(std::uint64_t part, std::uint64_t whole) {
  return whole == 0 ? 0.0 : 100.0 * static_cast<double>(part) / static_cast<double>(whole);
}

int report(const sim::SimulateSummary& summary, const std::string& output, double elapsed_s) {
  if (summary.interrupted) {
    print_error(
        fmt::format("stopped by a signal after {} of {} scans: {} holds them and no sequence.json; simulate "
                    "again with --force",
                    summary.scans, summary.selected, output));
    return kSignalBase + received_signal();
  }
  spdlog::info(
      "{} scans over {:.1f} m, {:.1f} M beams: {:.1f} % came back, {:.1f} % off flakes or dust; "
      "{:.1f} s -> {}",
      summary.scans, summary.driven_m, static_cast<double>(summary.beams) * 1e-6,
      percent_of_beams(summary.returns, summary.beams), percent_of_beams(summary.in_the_air, summary.beams), elapsed_s,
      output);
  return kWhole;
}

/// A look at the world from where the machine begins.
void take_picture(const SimCommand& command, const sim::Scenario& scenario) {
  spdlog::info("building the world");
  const sim::World world = sim::build_world(scenario, command.options.seed);
  const sim::RayCaster caster(world, sim::RayCasterConfig{});
  const sim::Photograph picture =
      sim::photograph(caster, sim::camera_behind(world, scenario.vehicle.start_m), command.options.threads);
  Image image(picture.width_px, picture.height_px, Rgb{});
  auto rgb = picture.rgb.begin();
  for (int row = 0; row < picture.height_px; ++row) {
    for (int column = 0; column < picture.width_px; ++column, rgb += 3) {
      image.set(column, row, {rgb[0], rgb[1], rgb[2]});
    }
  }
  const std::vector<std::byte> png = encode_png(image);
  write_result(command.picture, {reinterpret_cast<const char*>(png.data()), png.size()});
}

int execute(SimCommand& command) {
  command.console.start();
  if (command.list) {
    return list_known();
  }
  if (command.scenario.empty() || (command.options.output.empty() && command.picture.empty())) {
    throw UsageError("expected SCENARIO and -o FOLDER or --picture FILE, or --list; see berm sim --help");
  }
  const sim::Scenario scenario = choose_scenario(command);
  if (!command.picture.empty()) {
    take_picture(command, scenario);
    if (command.options.output.empty()) {
      return kWhole;
    }
  }
  const auto sensor_file = as_usage([&] { return sim::find_sensor(scenario.scenario.sensor, sim::sensor_folders()); });
  const sim::Sensor sensor = sim::read_sensor(sensor_file);
  const auto start = std::chrono::steady_clock::now();
  catch_signals();
  const sim::SimulateSummary summary = [&] {
    ProgressBar bar(command.console.is_quiet());
    command.options.on_stage = [](const std::string& stage) { spdlog::info("{}", stage); };
    command.options.on_progress = [&bar](std::size_t done, std::size_t total) { bar.show(done, total); };
    command.options.should_stop = [] { return received_signal() != 0; };
    const auto make = [&] { return sim::simulate(scenario, sensor, command.options); };
    const bool changed = command.seconds || !command.values.empty() || !command.sensor.empty();
    return changed ? as_usage(make) : make();
  }();
  const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
  return report(summary, command.options.output.string(), elapsed.count());
}

}  // namespace

void add_sim(CLI::App& app, int& exit_code) {
  auto command = std::make_shared<SimCommand>();
  sim::SimulateOptions& options = command->options;
  options.threads = std::max(1U, std::thread::hardware_concurrency());

  CLI::App* sub = app.add_subcommand("sim", "Make a recording of a scenario, with its truth");
  sub->footer(kSimExamples);
  sub->add_option("SCENARIO", command->scenario, "A scenario by name (berm sim --list) or a YAML file")
      ->type_name("NAME|FILE");
  sub->add_option("-o,--output", options.output, "Folder for the recording")->type_name("FOLDER");
  sub->add_option("--picture", command->picture, "Draw the world from behind the machine's start; needs no -o")
      ->type_name("FILE.png");
  sub->add_flag("--list", command->list, "Print the scenarios that are known by name, and what they show");
  sub->add_option("--seed", options.seed, "Another number, another world, weather and noise")
      ->check(CLI::NonNegativeNumber)
      ->capture_default_str();
  sub->add_option("--seconds", command->seconds, "Length of the recording instead of that of the scenario");
  sub->add_option("--sensor", command->sensor, "A sensor by name or a YAML file, instead of that of the scenario")
      ->type_name("NAME|FILE");
  sub->add_option("--set", command->values, "Another value for a key of the scenario, as often as needed")
      ->type_name("SECTION.KEY=VALUE")
      ->allow_extra_args(false);
  sub->add_option("--threads", options.threads, "Scans made at a time; the files are the same for any number")
      ->check(CLI::Range(1, 1024))
      ->capture_default_str();
  sub->add_flag("--force", options.force, "Replace the made recording in that folder");
  command->console.add_options(*sub);
  sub->callback([command, &exit_code] { exit_code = execute(*command); });
}

}  // namespace berm::app
