#include <exception>
#include <string>

#include <CLI/CLI.hpp>

#include "berm/core/error.hpp"
#include "berm/core/version.hpp"
#include "commands.hpp"
#include "console.hpp"
#include "exit_code.hpp"

namespace berm::app {
namespace {

constexpr const char* kMainExamples = R"(Examples:
  berm sim groomer_snowfall -o recording
  berm info recording
  berm run recording --machine car -o out
  berm eval out recording

'berm COMMAND --help' says more about a command.)";

int exit_code_of(const Error& error) {
  return error.code() == ErrorCode::invalid_argument ? kWrongUsage : kFailed;
}

int report_parse_error(const CLI::App& app, const CLI::ParseError& error) {
  if (error.get_exit_code() == 0) {
    return app.exit(error);  // --help and --version
  }
  const auto chosen = app.get_subcommands();
  const std::string command = chosen.empty() ? "berm" : "berm " + chosen.front()->get_name();
  print_error(std::string(error.what()) + "; see " + command + " --help");
  return kWrongUsage;
}

int run_program(int argc, char** argv) {
  CLI::App app{"LiDAR recordings of machines that work off-road, turned into labels and maps.", "berm"};
  int exit_code = kWhole;
  app.footer(kMainExamples);
  app.set_version_flag("--version", "berm " + std::string(version()));
  app.require_subcommand(1);
  add_info(app, exit_code);
  add_run(app, exit_code);
  add_sim(app, exit_code);
  add_eval(app, exit_code);
  add_draw(app, exit_code);
  add_machine(app, exit_code);
  add_map(app, exit_code);
  add_report(app, exit_code);
  add_view(app, exit_code);
  add_export(app, exit_code);
  try {
    app.parse(argc, argv);
    return exit_code;
  } catch (const CLI::ParseError& error) {
    return report_parse_error(app, error);
  } catch (const UsageError& error) {
    print_error(error.what());
    return kWrongUsage;
  } catch (const Error& error) {
    print_error(error.what());
    return exit_code_of(error);
  } catch (const std::bad_alloc&) {
    print_error("not enough memory");
  } catch (const std::exception& error) {
    print_error(error.what());
  }
  return kFailed;
}

}  // namespace
}  // namespace berm::app

int main(int argc, char** argv) {
  return berm::app::run_program(argc, argv);
}
