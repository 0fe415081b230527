#include <memory>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "berm/io/recording.hpp"
#include "berm/io/recording_info.hpp"
#include "commands.hpp"
#include "console.hpp"
#include "exit_code.hpp"
#include "info_text.hpp"
#include "progress_bar.hpp"

namespace berm::app {
namespace {

constexpr const char* kInfoExamples = R"(Examples:
  berm info recording
  berm info scan.pcd
  berm info recording --json --count 10 | jq .sensor

Ends with 0, or 3 if scans could not be read.)";

struct InfoCommand {
  Console console;
  std::string recording;
  std::size_t first = 0;
  std::size_t count = 0;
  bool json = false;
  std::string output = "-";
};

int execute(const InfoCommand& command) {
  command.console.start();
  const Recording recording = Recording::open(command.recording);
  InspectOptions options{.first = command.first};
  if (command.count > 0) {
    options.count = command.count;
  }
  const RecordingInfo info = [&] {
    ProgressBar bar(command.console.is_quiet());
    options.progress = [&bar](std::size_t done, std::size_t all) { bar.show(done, all); };
    return inspect(recording, options);
  }();
  const auto dump = [&info] {
    return to_json(info).dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
  };
  write_result(command.output, command.json ? dump() : to_text(info));
  return info.scans_failed > 0 ? kWithLosses : kWhole;
}

}  // namespace

void add_info(CLI::App& app, int& exit_code) {
  auto command = std::make_shared<InfoCommand>();
  CLI::App* sub = app.add_subcommand("info", "Say what is in a recording");
  sub->footer(kInfoExamples);
  sub->add_option("RECORDING", command->recording, "Sequence folder, KITTI folder, folder of scans, or one scan")
      ->required();
  sub->add_flag("--json", command->json, "For programs");
  sub->add_option("--first", command->first, "Index of the first scan to look into, from 0")
      ->check(CLI::NonNegativeNumber)
      ->capture_default_str();
  sub->add_option("--count", command->count, "Number of scans to look into, else all")->check(CLI::PositiveNumber);
  sub->add_option("-o,--output", command->output, "File for the result, - for stdout")
      ->type_name("FILE")
      ->capture_default_str();
  command->console.add_options(*sub);
  sub->callback([command, &exit_code] { exit_code = execute(*command); });
}

}  // namespace berm::app
