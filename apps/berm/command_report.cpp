#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include <CLI/CLI.hpp>
#include <spdlog/spdlog.h>

#include "berm/core/error.hpp"
#include "berm/io/recording.hpp"
#include "berm/report/report.hpp"
#include "commands.hpp"
#include "console.hpp"
#include "exit_code.hpp"
#include "make_report.hpp"

namespace berm::app {
namespace {

constexpr const char* kReportExamples = R"(Examples:
  berm report out
  berm report out --recording recording

Writes out/report.html, one page that opens from anywhere: what was found, warnings, plots. berm run has written it
already; this makes it anew, say after the truth or another berm has arrived.)";

struct ReportCommand {
  Console console;
  std::string run_folder;
  std::string recording;
};

/// The recording of the run; none if it is not there any more, unless it was named.
std::optional<Recording> open_recording(const ReportCommand& command) {
  if (!command.recording.empty()) {
    return Recording::open(command.recording);
  }
  const std::filesystem::path recorded = recording_of(command.run_folder);
  try {
    return Recording::open(recorded);
  } catch (const Error&) {
    spdlog::info("note: {} cannot be read, the report does without its truth; --recording says where it is now",
                 recorded.string());
    return std::nullopt;
  }
}

int execute(const ReportCommand& command) {
  command.console.start();
  const std::optional<Recording> recording = open_recording(command);
  const std::filesystem::path report = make_report(command.run_folder, recording ? &*recording : nullptr);
  spdlog::info("report -> {}", report.string());
  return kWhole;
}

}  // namespace

void add_report(CLI::App& app, int& exit_code) {
  auto command = std::make_shared<ReportCommand>();
  CLI::App* sub = app.add_subcommand("report", "Show a run in one page, report.html");
  sub->footer(kReportExamples);
  sub->add_option("RUN", command->run_folder, "Output folder of berm run")->required();
  sub->add_option("--recording", command->recording, "The recording, if it is not where it was")->type_name("FOLDER");
  command->console.add_options(*sub);
  sub->callback([command, &exit_code] { exit_code = execute(*command); });
}

}  // namespace berm::app
