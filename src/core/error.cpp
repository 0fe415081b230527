#include "berm/core/error.hpp"

#include <utility>

namespace berm {
namespace {

std::string describe(const std::string& file, std::optional<std::uint64_t> offset, const std::string& problem) {
  std::string text = file;
  if (offset) {
    text += ": at byte " + std::to_string(*offset);
  }
  return text + ": " + problem;
}

}  // namespace

Error::Error(ErrorCode code, const std::string& message) : std::runtime_error(message), code_(code) {}

FileError::FileError(ErrorCode code, std::string file, std::optional<std::uint64_t> offset, const std::string& problem)
    : Error(code, describe(file, offset, problem)), file_(std::move(file)), offset_(offset) {}

ConfigError::ConfigError(std::string key, std::string problem)
    : Error(ErrorCode::config, key + ": " + problem), key_(std::move(key)), problem_(std::move(problem)) {}

ConfigError::ConfigError(const std::string& where, std::string key, std::string problem)
    : Error(ErrorCode::config, where + ": " + key + ": " + problem),
      key_(std::move(key)),
      problem_(std::move(problem)) {}

}  // namespace berm
