#include "command_map.hpp"

#include <filesystem>
#include <system_error>

#include "berm/core/error.hpp"
#include "berm/io/file_reader.hpp"
#include "berm/io/settings.hpp"
#include "commands.hpp"
#include "exit_code.hpp"

namespace berm::app {
namespace {

constexpr const char* kMapExamples = R"(Examples:
  berm map info out/edges.ot
  berm map merge monday/edges.ot tuesday/edges.ot -o week.ot
  berm map lines week.ot -o edges.csv
  berm map export week.ot -o edges.gpkg
  berm map draw week.ot -o map.png

Maps of road edges are the edges.ot of berm run, and what berm map merge makes of them.)";

struct LinesSettings {
  EdgeLinesConfig lines;

  static void sections(auto&& section) { section("lines", &LinesSettings::lines); }
};

}  // namespace

EdgeMap read_map(const std::string& file) {
  FileBuffer buffer;
  read_file(file, buffer);
  return EdgeMap::from_octomap(buffer.text(), file, {});
}

void OutputOption::add_options(CLI::App& command, const std::string& text) {
  command.add_option("-o,--output", file_, text)->required()->type_name("FILE");
  command.add_flag("--force", force_, "Replace the file if it is there");
}

const std::string& OutputOption::target() const {
  std::error_code ignored;
  if (!force_ && std::filesystem::is_regular_file(file_, ignored)) {
    throw FileError(ErrorCode::exists, file_, std::nullopt, "is there already; --force replaces it");
  }
  return file_;
}

void LinesOption::add_options(CLI::App& command) {
  command
      .add_option("--set", values_,
                  "Another value for a key of how lines are made (spacing_m, ...), as often as needed")
      ->type_name("lines.KEY=VALUE")
      ->allow_extra_args(false);
}

EdgeLinesConfig LinesOption::choose() const {
  LinesSettings settings;
  try {
    for (const std::string& value : values_) {
      set_value(settings, value, "--set " + value);
    }
    settings.lines.check();
  } catch (const ConfigError& error) {
    throw UsageError(error.what());
  }
  return settings.lines;
}

void add_map(CLI::App& app, int& exit_code) {
  CLI::App* sub = app.add_subcommand("map", "Look into maps of road edges, merge them, turn them into lines and files");
  sub->footer(kMapExamples);
  sub->require_subcommand(1);
  add_map_info(*sub, exit_code);
  add_map_merge(*sub, exit_code);
  add_map_lines(*sub, exit_code);
  add_map_export(*sub, exit_code);
  add_map_draw(*sub, exit_code);
}

}  // namespace berm::app
