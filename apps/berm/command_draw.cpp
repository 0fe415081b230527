#include <algorithm>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <CLI/CLI.hpp>

#include "berm/core/error.hpp"
#include "berm/io/recording.hpp"
#include "berm/pipeline/pipeline.hpp"
#include "berm/pipeline/sensor_sheet.hpp"
#include "berm/render/draw_figure.hpp"
#include "berm/render/draw_scan.hpp"
#include "berm/render/png.hpp"
#include "commands.hpp"
#include "console.hpp"
#include "exit_code.hpp"
#include "label_pictures.hpp"
#include "machine_option.hpp"
#include "run_mount.hpp"

namespace berm::app {
namespace {

constexpr const char* kDrawExamples = R"(Examples:
  berm draw recording -o scan.png
  berm draw recording --run out --scan 000012 -o labels.png
  berm draw recording --run out --truth --view perspective -o right_and_wrong.png
  berm draw recording --machine groomer --view side -o - > side.png
  berm draw recording --machine groomer --figure histogram -o intensities.png
  berm draw recording --machine groomer --method piste=reference --figure waveform --first-point 4000 --points 1000 -o steps.png

--machine labels the scan on the spot; --run takes the labels of a run, --truth those of the recording, and both
together show where they agree.)";

/// What is drawn of a scan.
enum class Figure : std::uint8_t { scan, histogram, waveform };

struct DrawCommand {
  Console console;
  MachineOption machine;
  std::string recording;
  std::string scan;
  std::string run_folder;
  bool truth = false;
  bool light = false;
  Figure figure = Figure::scan;
  std::size_t first_point = 0;
  std::size_t points = 0;
  std::string output;
  DrawOptions options;
};

std::size_t find_scan(const Recording& recording, const std::string& name) {
  if (name.empty()) {
    return 0;
  }
  for (std::size_t i = 0; i < recording.size(); ++i) {
    if (recording.scan(i).name == name) {
      return i;
    }
  }
  throw UsageError("--scan " + name + ": there is no such scan, they go from " + recording.scan(0).name + " to " +
                   recording.scan(recording.size() - 1).name);
}

/// The machine whose mount levels the picture: the chosen one, else that of the run; corrected by the recording's
/// sheet.
Machine find_machine_of(const DrawCommand& command, const Recording& recording) {
  ChosenMachine chosen;
  if (command.machine.is_given()) {
    chosen = command.machine.choose();
  } else if (!command.run_folder.empty()) {
    chosen.machine.mount = read_run_mount(command.run_folder);
    return chosen.machine;
  }
  adopt_sheet(chosen.machine, recording.sheet(), chosen.pinned);
  return chosen.machine;
}

/// The boundary of the piste as lines over the picture.
std::vector<DrawnLine> boundary_lines(const PisteResult& piste, Background background) {
  std::vector<DrawnLine> lines;
  for (const auto side : {piste.left, piste.right}) {
    DrawnLine line{.name = "boundary",
                   .color = background == Background::dark ? Rgb{255, 255, 255} : Rgb{0, 0, 0},
                   .vertices_m = {}};
    for (const BoundaryPoint& point : side) {
      line.vertices_m.emplace_back(point.x_m, point.y_m, point.z_m);
    }
    lines.push_back(std::move(line));
  }
  return lines;
}

Image draw_labelled(const DrawCommand& command, const PointsView& points, std::span<const Label> labels,
                    const DrawOptions& options) {
  return command.figure == Figure::histogram ? draw_histogram(points, labels, options)
                                             : draw_scan(points, labels, options);
}

Image draw_processed(const DrawCommand& command, const Scan& scan, const Machine& machine) {
  Pipeline pipeline(machine);
  const ScanResult result = pipeline.process(scan);
  const PointsView points = scan.cloud.view();
  if (command.figure != Figure::waveform) {
    DrawOptions options = command.options;
    options.lines = boundary_lines(result.piste, options.background);
    return draw_labelled(command, points, result.labels, options);
  }
  std::vector<PointRange> envelopes;
  for (const Envelope& envelope : result.piste.envelopes) {
    envelopes.push_back({envelope.first, envelope.last});
  }
  return draw_waveform({.points = points,
                        .labels = result.labels,
                        .series = result.series,
                        .steps = result.piste.steps,
                        .envelopes = envelopes,
                        .first = command.first_point,
                        .count = command.points},
                       command.options);
}

void check_figure(const DrawCommand& command, const Machine& machine, const PointsView& points) {
  if (command.figure == Figure::histogram && points.intensity.empty()) {
    throw UsageError("--figure histogram: the scan has no intensity");
  }
  if (command.figure != Figure::waveform) {
    return;
  }
  if (!command.machine.is_given() || !command.run_folder.empty() || command.truth) {
    throw UsageError("--figure waveform works on the spot: it needs --machine, and neither --run nor --truth");
  }
  if (machine.methods.piste == "none") {
    throw UsageError("--figure waveform needs a piste method: add --method piste=default or piste=reference");
  }
  if (command.first_point >= points.size()) {
    throw UsageError("--first-point " + std::to_string(command.first_point) + ": the scan has " +
                     std::to_string(points.size()) + " points");
  }
}

Image draw(const DrawCommand& command, const Recording& recording, const ScanEntry& entry, const Scan& scan,
           const Machine& machine) {
  const PointsView points = scan.cloud.view();
  check_figure(command, machine, points);
  std::optional<RawLabels> output;
  std::optional<RawLabels> truth;
  if (!command.run_folder.empty()) {
    output = read_labels(std::filesystem::path(command.run_folder) / "labels" / (entry.name + ".label"), points.size());
  }
  if (command.truth) {
    if (!entry.truth_labels) {
      throw UsageError("--truth: the recording " + recording.path().string() + " has no labels for scan " + entry.name);
    }
    truth = read_labels(*entry.truth_labels, points.size());
  }
  if (output && truth && command.figure == Figure::scan) {
    return draw_classes(points, compare_ground(*output, *truth), kGroundComparison, command.options);
  }
  if (output || truth) {
    return draw_labelled(command, points, to_labels(output ? *output : *truth), command.options);
  }
  if (command.machine.is_given()) {
    return draw_processed(command, scan, machine);
  }
  return draw_labelled(command, points, {}, command.options);
}

int execute(DrawCommand& command) {
  command.console.start();
  const Recording recording = Recording::open(command.recording);
  const Machine machine = find_machine_of(command, recording);
  const std::size_t index = find_scan(recording, command.scan);
  const ScanEntry entry = recording.scan(index);
  Scan scan;
  recording.read(index, scan);
  scan.T_base_sensor = machine.mount.T_base_sensor();
  command.options.T_base_sensor = scan.T_base_sensor;
  command.options.background = command.light ? Background::light : Background::dark;
  if (command.options.title.empty()) {
    command.options.title = recording.path().filename().string() + " " + entry.name;
  }
  const auto png = encode_png(draw(command, recording, entry, scan, machine));
  write_result(command.output, {reinterpret_cast<const char*>(png.data()), png.size()});
  return kWhole;
}

void add_picture_options(CLI::App& sub, DrawCommand& command) {
  const std::map<std::string, DrawView> views = {{"top", DrawView::top},
                                                 {"side", DrawView::side},
                                                 {"front", DrawView::front},
                                                 {"perspective", DrawView::perspective}};
  const std::map<std::string, DrawColor> colors = {
      {"label", DrawColor::label}, {"intensity", DrawColor::intensity}, {"height", DrawColor::height}};
  const std::map<std::string, Figure> figures = {
      {"scan", Figure::scan}, {"histogram", Figure::histogram}, {"waveform", Figure::waveform}};
  DrawOptions& options = command.options;
  // The choices stand in the type name: CLI11 would print them as {top->,side->}.
  sub.add_option("--figure", command.figure,
                 "The scan itself, how often which intensity comes back, or x and z over the firing order")
      ->transform(CLI::CheckedTransformer(figures).description(""))
      ->type_name("scan|histogram|waveform");
  sub.add_option("--first-point", command.first_point, "Where a waveform begins, from 0")
      ->check(CLI::NonNegativeNumber)
      ->capture_default_str();
  sub.add_option("--points", command.points, "How many points of a waveform are shown; 0 all")
      ->check(CLI::NonNegativeNumber)
      ->capture_default_str();
  sub.add_option("--view", options.view, "From where")
      ->transform(CLI::CheckedTransformer(views).description(""))
      ->type_name("top|side|front|perspective");
  sub.add_option("--color", options.color, "What the colours say")
      ->transform(CLI::CheckedTransformer(colors).description(""))
      ->type_name("label|intensity|height");
  sub.add_option("--width", options.width_px, "Width of the picture in pixels")->capture_default_str();
  sub.add_option("--height", options.height_px, "Height of the picture in pixels")->capture_default_str();
  sub.add_option("--range", options.range_m, "How far is shown, in m; 0 as far as most points are")
      ->capture_default_str();
  sub.add_flag("--ahead", options.ahead, "Show nothing behind the sensor");
  sub.add_option("--title", options.title, "Text above the picture");
  sub.add_flag("--light", command.light, "Light background, for paper");
}

}  // namespace

void add_draw(CLI::App& app, int& exit_code) {
  auto command = std::make_shared<DrawCommand>();
  CLI::App* sub = app.add_subcommand("draw", "Draw one scan as a PNG picture");
  sub->footer(kDrawExamples);
  sub->add_option("RECORDING", command->recording, "Sequence folder, KITTI folder, folder of scans, or one scan")
      ->required();
  sub->add_option("-o,--output", command->output, "PNG file, - for stdout")->required()->type_name("FILE");
  sub->add_option("--scan", command->scan, "Name of the scan, else the first")->type_name("NAME");
  sub->add_option("--run", command->run_folder, "Take the labels of this run")->type_name("FOLDER");
  sub->add_flag("--truth", command->truth, "Take the labels that came with the recording");
  command->machine.add_options(*sub, false);
  add_picture_options(*sub, *command);
  command->console.add_options(*sub);
  sub->callback([command, &exit_code] {
    try {
      command->options.check();
    } catch (const ConfigError& error) {
      throw UsageError(error.what());
    }
    exit_code = execute(*command);
  });
}

}  // namespace berm::app
