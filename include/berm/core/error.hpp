#pragma once

#include <cstdint>
#include <optional>
#include <stdexcept>
#include <string>

namespace berm {

/// What kind of thing went wrong; decides the exit code and what a caller may do next.
enum class ErrorCode : std::uint8_t {
  invalid_argument,  ///< the caller broke a documented condition
  config,            ///< a configuration value is unknown, of the wrong type or out of range
  not_found,         ///< a file or folder that is needed is not there
  unreadable,        ///< it is there, but the system refuses to read it
  malformed,         ///< the bytes contradict the format
  truncated,         ///< the file ends before what it announced
  unsupported,       ///< valid, but nothing that berm reads
  exists,            ///< an output is already there and was not to be replaced
  write_failed,      ///< an output cannot be written
};

/// The one exception of berm, thrown at its borders (files, configuration, arguments), never for bad points.
class Error : public std::runtime_error {
 public:
  Error(ErrorCode code, const std::string& message);

  [[nodiscard]] ErrorCode code() const noexcept { return code_; }

 private:
  ErrorCode code_;
};

/// A broken or missing file: says which, where in it, and what was expected there.
class FileError : public Error {
 public:
  /// `offset` is in bytes from the start of the file; none where the whole file is meant.
  FileError(ErrorCode code, std::string file, std::optional<std::uint64_t> offset, const std::string& problem);

  [[nodiscard]] const std::string& file() const noexcept { return file_; }
  [[nodiscard]] std::optional<std::uint64_t> offset() const noexcept { return offset_; }

 private:
  std::string file_;
  std::optional<std::uint64_t> offset_;
};

/// A configuration value that cannot be used: says which key, what it was and what is allowed.
class ConfigError : public Error {
 public:
  ConfigError(std::string key, std::string problem);
  /// `where` is the file and line, or the argument, that the value came from.
  ConfigError(const std::string& where, std::string key, std::string problem);

  [[nodiscard]] const std::string& key() const noexcept { return key_; }
  [[nodiscard]] const std::string& problem() const noexcept { return problem_; }

 private:
  std::string key_;
  std::string problem_;
};

}  // namespace berm
