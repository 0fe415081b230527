#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include <CLI/CLI.hpp>
#include <spdlog/spdlog.h>

#include "berm/io/settings_folders.hpp"
#include "berm/view/server.hpp"
#include "browser.hpp"
#include "commands.hpp"
#include "console.hpp"
#include "exit_code.hpp"
#include "view_piste.hpp"

namespace berm::app {
namespace {

constexpr const char* kViewExamples = R"(Examples:
  berm view out
  berm view recording
  berm view out_reference out_default
  berm view out --port 8080 --no-browser

Ctrl-C ends it. Nobody but this machine reaches it unless --host says otherwise.)";

struct ViewCommand {
  Console console;
  std::vector<std::string> paths;
  ServerOptions server;
  bool no_browser = false;
};

/// The front end beside the program.
Site load_site() {
  for (const std::filesystem::path& folder : share_folders("web/viewer")) {
    std::error_code code;
    if (std::filesystem::is_regular_file(folder / "index.html", code)) {
      return Site::load(folder);
    }
  }
  return {};
}

/// The address that this machine can open: 0.0.0.0 is everywhere, and nowhere to go to.
std::string address_to_open(const ViewServer& server, const std::string& host) {
  return host == "0.0.0.0" || host == "::" ? "http://127.0.0.1:" + std::to_string(server.port()) + "/"
                                           : server.address();
}

int execute(const ViewCommand& command) {
  command.console.start();
  std::vector<ShownRun> runs;
  runs.reserve(command.paths.size());
  for (const std::string& path : command.paths) {
    runs.push_back(ShownRun::open(path));
  }
  Site site = load_site();
  if (!site.has_front_end()) {
    spdlog::warn("the pages of the viewer were not found: share/berm/web/viewer is missing beside the program");
  }
  ViewOptions options;
  options.access = {.host = command.server.host, .loopback = is_loopback(command.server.host)};
  options.piste = describe_piste;
  ViewApi api(std::move(runs), std::move(site), std::move(options));
  ViewServer server(api, command.server);
  if (!is_loopback(command.server.host)) {
    spdlog::warn("everybody who reaches {} can look at these data", server.address());
  }
  const std::string address = address_to_open(server, command.server.host);
  std::printf("%s\n", address.c_str());
  std::fflush(stdout);
  if (!command.no_browser) {
    open_browser(address);
  }
  server.run(true);
  return kWhole;
}

}  // namespace

void add_view(CLI::App& app, int& exit_code) {
  auto command = std::make_shared<ViewCommand>();
  CLI::App* sub = app.add_subcommand("view", "Look at runs and recordings in a browser");
  sub->footer(kViewExamples);
  sub->add_option("RUN", command->paths, "Folder of a run, or a recording; two are shown side by side")
      ->required()
      ->expected(1, 2)
      ->type_name("");
  sub->add_option("--port", command->server.port, "Port of the server; 0 a free one")->capture_default_str();
  sub->add_option("--host", command->server.host, "Address to bind to, in numbers; 0.0.0.0 shows it to the network")
      ->capture_default_str()
      ->type_name("ADDRESS");
  sub->add_flag("--no-browser", command->no_browser, "Only print the address");
  command->console.add_options(*sub);
  sub->callback([command, &exit_code] { exit_code = execute(*command); });
}

}  // namespace berm::app
