#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>

#include <CLI/CLI.hpp>
#include <spdlog/spdlog.h>

#include "berm/core/error.hpp"
#include "berm/io/atomic_file.hpp"
#include "berm/view/export_run.hpp"
#include "commands.hpp"
#include "console.hpp"
#include "exit_code.hpp"
#include "progress_bar.hpp"
#include "signals.hpp"

namespace berm::app {
namespace {

constexpr const char* kExportExamples = R"(Examples:
  berm export out --to foxglove
  berm export out --to las -o road.las
  berm export out --to ply --every 10
  berm export recording --to foxglove -o recording.mcap

Ends with 0, or 3 if scans could not be read or have no pose.)";

enum class Target : std::uint8_t { foxglove, ply, las, csv };

struct ExportCommand {
  Console console;
  std::string run;
  Target target = Target::foxglove;
  std::string output;
  bool force = false;
  ExportOptions options;
};

const char* ending_of(Target target) {
  switch (target) {
    case Target::ply:
      return ".ply";
    case Target::las:
      return ".las";
    case Target::csv:
      return ".csv";
    case Target::foxglove:
      break;
  }
  return ".mcap";
}

CloudFormat format_of(Target target) {
  return target == Target::ply ? CloudFormat::ply : target == Target::las ? CloudFormat::las : CloudFormat::csv;
}

std::filesystem::path output_of(const ExportCommand& command, const ShownRun& run) {
  const std::filesystem::path file = command.output.empty() ? run.name() + ending_of(command.target) : command.output;
  std::error_code ignored;
  if (!command.force && std::filesystem::is_regular_file(file, ignored)) {
    throw FileError(ErrorCode::exists, file.string(), std::nullopt, "is there already; --force replaces it");
  }
  return file;
}

ExportSummary write(const ExportCommand& command, const ShownRun& run, const std::filesystem::path& file) {
  if (command.target != Target::foxglove) {
    return export_cloud(run, format_of(command.target), file, command.options);
  }
  const ExportSummary summary = export_foxglove(run, file, command.options);
  if (!summary.interrupted) {
    std::filesystem::path layout = file;
    layout.replace_extension(".layout.json");
    write_file_atomically(layout, foxglove_layout());
    spdlog::info("a layout for Foxglove -> {}", layout.string());
  }
  return summary;
}

int execute(ExportCommand& command) {
  command.console.start();
  const ShownRun run = ShownRun::open(command.run);
  const std::filesystem::path file = output_of(command, run);
  catch_signals();
  const ExportSummary summary = [&] {
    ProgressBar bar(command.console.is_quiet());
    command.options.on_progress = [&bar](std::size_t done, std::size_t total) { bar.show(done, total); };
    command.options.should_stop = [] { return received_signal() != 0; };
    return write(command, run, file);
  }();
  if (summary.interrupted) {
    return kSignalBase + received_signal();
  }
  spdlog::info("{} points of {} scans -> {}", summary.points, summary.scans, file.string());
  if (summary.skipped > 0) {
    spdlog::warn("{} scans are not in it: they could not be read, or have no pose", summary.skipped);
    return kWithLosses;
  }
  return kWhole;
}

}  // namespace

void add_export(CLI::App& app, int& exit_code) {
  auto command = std::make_shared<ExportCommand>();
  CLI::App* sub = app.add_subcommand("export", "Write a run or a recording for other programs");
  sub->footer(kExportExamples);
  const std::map<std::string, Target> targets = {
      {"foxglove", Target::foxglove}, {"ply", Target::ply}, {"las", Target::las}, {"csv", Target::csv}};
  sub->add_option("RUN", command->run, "Folder of a run, or a recording")->required()->type_name("");
  sub->add_option("--to", command->target, "For whom: an MCAP file and a layout for Foxglove, or points in the world")
      ->required()
      ->transform(CLI::CheckedTransformer(targets).description(""))
      ->type_name("foxglove|ply|las|csv");
  sub->add_option("-o,--output", command->output, "File to write, else the name of the run in the working folder")
      ->type_name("FILE");
  sub->add_flag("--force", command->force, "Replace the file if it is there");
  sub->add_option("--every", command->options.every, "Take the first of so many scans")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  command->console.add_options(*sub);
  sub->callback([command, &exit_code] { exit_code = execute(*command); });
}

}  // namespace berm::app
