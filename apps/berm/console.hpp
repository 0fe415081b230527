#pragma once

#include <string>
#include <string_view>

#include <CLI/App.hpp>

namespace berm::app {

/// How much is said on stderr. stdout carries results alone.
class Console {
 public:
  /// Adds -q/--quiet and -v/--verbose to a subcommand.
  void add_options(CLI::App& command);
  /// Sets the log up; to be called once the command line is known.
  void start() const;
  [[nodiscard]] bool is_quiet() const { return quiet_; }

 private:
  bool quiet_ = false;
  bool verbose_ = false;
};

/// "berm: error: MESSAGE" on stderr, one line whatever the message holds.
void print_error(std::string_view message);

/// Writes a result to `target`, whole or not at all; "-" is stdout. Throws FileError(write_failed).
void write_result(const std::string& target, std::string_view text);

}  // namespace berm::app
