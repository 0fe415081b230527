#pragma once

#include <CLI/App.hpp>

namespace berm::app {

/// Each adds one subcommand to `app`, which leaves what the program returns in `exit_code`. Exceptions pass through.
void add_info(CLI::App& app, int& exit_code);
void add_run(CLI::App& app, int& exit_code);
void add_sim(CLI::App& app, int& exit_code);
void add_eval(CLI::App& app, int& exit_code);
void add_draw(CLI::App& app, int& exit_code);
void add_machine(CLI::App& app, int& exit_code);
void add_map(CLI::App& app, int& exit_code);
void add_report(CLI::App& app, int& exit_code);
void add_view(CLI::App& app, int& exit_code);
void add_export(CLI::App& app, int& exit_code);

}  // namespace berm::app
