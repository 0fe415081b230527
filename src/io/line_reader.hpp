#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <istream>
#include <memory>
#include <span>
#include <string>
#include <string_view>

#include "berm/core/error.hpp"

namespace berm {

/// The lines of a text file one by one, in bounded memory: LF or CRLF, last line end optional. Blank lines and lines
/// that start with '#' are skipped (and counted).
class LineReader {
 public:
  /// A longer line is no text file of ours.
  static constexpr std::size_t kMaxLineBytes = 4096;

  /// Reads from `input`, which must outlive the reader; `name` is what errors call it.
  LineReader(std::istream& input, std::string name);
  /// Opens `file`; throws FileError if it is not there, no regular file or unreadable.
  explicit LineReader(const std::filesystem::path& file);

  /// The next line without its end, valid until the next call; false at the end. Throws FileError for a line that is
  /// too long or holds a NUL byte, and for a read that fails.
  [[nodiscard]] bool next(std::string_view& line);

  /// The same, but blank lines are given, as empty ones.
  [[nodiscard]] bool next_or_blank(std::string_view& line);

  /// Splits `line` at blanks and reads all of it as exactly `values.size()` finite numbers; `what` names the columns.
  void parse_numbers(std::string_view line, std::string_view what, std::span<double> values) const;

  /// Size of the file at opening; 0 where unknown, as for a stream.
  [[nodiscard]] std::uintmax_t bytes() const { return bytes_; }

  /// A FileError that names the current line.
  [[nodiscard]] FileError error(const std::string& problem) const;

 private:
  [[nodiscard]] bool read_line();
  [[nodiscard]] bool read_line_unguarded();

  std::unique_ptr<std::istream> owned_;
  std::istream* input_;
  std::string name_;
  std::string buffer_;
  std::uintmax_t bytes_ = 0;
  std::size_t line_number_ = 0;
};

/// Takes the first word, delimited by blanks or tabs, off `line`; empty at the end.
[[nodiscard]] std::string_view take_word(std::string_view& line);

/// `text` for an error message: shortened, unprintable bytes replaced.
[[nodiscard]] std::string quoted(std::string_view text);

}  // namespace berm
