#include <memory>

#include <CLI/CLI.hpp>
#include <spdlog/spdlog.h>

#include "berm/eval/evaluate.hpp"
#include "berm/io/recording.hpp"
#include "commands.hpp"
#include "console.hpp"
#include "exit_code.hpp"

namespace berm::app {
namespace {

constexpr const char* kEvalExamples = R"(Examples:
  berm eval out recording
  berm eval out recording --per-scan -o metrics.json
  berm eval out recording | jq .ground.f1

Prints one JSON object. Metrics without truth or output are named under left_out with the reason.
Ends with 0, or 3 if scans could not be judged or the run did not finish.)";

struct EvalCommand {
  Console console;
  std::string run_folder;
  std::string recording;
  std::string output = "-";
  bool per_scan = false;
};

int execute(const EvalCommand& command) {
  command.console.start();
  const Recording recording = Recording::open(command.recording);
  const Evaluation evaluation = evaluate(command.run_folder, recording, command.per_scan);
  for (const FailedScan& scan : evaluation.failed) {
    spdlog::warn("scan {} cannot be judged: {}", scan.name, scan.reason);
  }
  for (const std::string& note : evaluation.notes) {
    spdlog::warn("note: {}", note);
  }
  write_result(command.output, to_json(evaluation, command.run_folder, recording));
  return evaluation.is_whole() ? kWhole : kWithLosses;
}

}  // namespace

void add_eval(CLI::App& app, int& exit_code) {
  auto command = std::make_shared<EvalCommand>();
  CLI::App* sub = app.add_subcommand("eval", "Measure a run against the truth in its recording");
  sub->footer(kEvalExamples);
  sub->add_option("RUN", command->run_folder, "Output folder of berm run")->required();
  sub->add_option("RECORDING", command->recording, "The recording with its truth")->required();
  sub->add_option("-o,--output", command->output, "File for the result, - for stdout")
      ->type_name("FILE")
      ->capture_default_str();
  sub->add_flag("--per-scan", command->per_scan, "List the metrics of every scan as well");
  command->console.add_options(*sub);
  sub->callback([command, &exit_code] { exit_code = execute(*command); });
}

}  // namespace berm::app
