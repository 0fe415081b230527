#pragma once

#include <string>
#include <vector>

#include <CLI/App.hpp>

#include "berm/map/edge_lines.hpp"
#include "berm/map/edge_map.hpp"

namespace berm::app {

/// Reads a map of road edges (.ot). Throws FileError.
[[nodiscard]] EdgeMap read_map(const std::string& file);

/// An output file that is there already is replaced only if the user says so.
class OutputOption {
 public:
  /// Adds -o/--output, required, and --force.
  void add_options(CLI::App& command, const std::string& text);
  /// The file to write. Throws Error(exists) if it is there and is not to be replaced.
  [[nodiscard]] const std::string& target() const;
  [[nodiscard]] const std::string& name() const { return file_; }

 private:
  std::string file_;
  bool force_ = false;
};

/// --set lines.KEY=VALUE: how voxels become lines.
class LinesOption {
 public:
  void add_options(CLI::App& command);
  /// Throws UsageError for a key or value that does not exist.
  [[nodiscard]] EdgeLinesConfig choose() const;

 private:
  std::vector<std::string> values_;
};

/// Each adds one subcommand of `berm map`, as those of commands.hpp.
void add_map_info(CLI::App& app, int& exit_code);
void add_map_merge(CLI::App& app, int& exit_code);
void add_map_lines(CLI::App& app, int& exit_code);
void add_map_export(CLI::App& app, int& exit_code);
void add_map_draw(CLI::App& app, int& exit_code);

}  // namespace berm::app
