#pragma once

#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include <CLI/App.hpp>

#include "berm/pipeline/machine.hpp"

namespace berm::app {

/// A machine as the command line asks for it.
struct ChosenMachine {
  Machine machine;
  std::filesystem::path file;
  std::set<std::string> pinned;  ///< keys that --set or --method gave
};

/// --machine, --method and --set of a subcommand.
class MachineOption {
 public:
  void add_options(CLI::App& command, bool required);
  /// The machine as the first argument instead of an option.
  void add_positional(CLI::App& command);
  [[nodiscard]] bool is_given() const { return !name_.empty(); }
  /// Throws UsageError for a machine or key that does not exist, ConfigError or FileError for a broken file.
  [[nodiscard]] ChosenMachine choose() const;

 private:
  void add_changes(CLI::App& command);

  std::string name_;
  std::vector<std::string> methods_;
  std::vector<std::string> values_;
};

}  // namespace berm::app
