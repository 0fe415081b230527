#include "console.hpp"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <optional>

#include <spdlog/sinks/stdout_color_sinks.h>
#include <spdlog/spdlog.h>

#include "berm/core/error.hpp"
#include "berm/io/atomic_file.hpp"

namespace berm::app {

void Console::add_options(CLI::App& command) {
  auto* quiet = command.add_flag("-q,--quiet", quiet_, "Say nothing but errors; no progress bar");
  command.add_flag("-v,--verbose", verbose_, "Say more")->excludes(quiet);
}

void Console::start() const {
  auto logger = spdlog::stderr_color_mt("berm");
  logger->set_pattern("berm: %v");
  logger->set_level(quiet_ ? spdlog::level::err : verbose_ ? spdlog::level::debug : spdlog::level::info);
  spdlog::set_default_logger(std::move(logger));
}

void print_error(std::string_view message) {
  std::string line = "berm: error: ";
  for (const char c : message) {
    line += c == '\n' || c == '\r' ? ' ' : c;
  }
  line += '\n';
  std::fputs(line.c_str(), stderr);
}

void write_result(const std::string& target, std::string_view text) {
  if (target != "-") {
    write_file_atomically(target, text);
    return;
  }
  const bool written = std::fwrite(text.data(), 1, text.size(), stdout) == text.size() && std::fflush(stdout) == 0;
  if (!written) {
    throw FileError(ErrorCode::write_failed, "stdout", std::nullopt, std::strerror(errno));
  }
}

}  // namespace berm::app
