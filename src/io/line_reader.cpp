#include "line_reader.hpp"

#include <algorithm>
#include <fstream>
#include <utility>

#include "text_numbers.hpp"

namespace berm {
namespace {

constexpr std::size_t kMaxQuotedBytes = 40;
constexpr std::string_view kLineBlanks = " \t";

std::unique_ptr<std::istream> open_text(const std::filesystem::path& file) {
  std::error_code error;
  const auto status = std::filesystem::status(file, error);
  if (status.type() == std::filesystem::file_type::not_found) {
    throw FileError(ErrorCode::not_found, file.string(), std::nullopt, "there is no such file");
  }
  // Opening a pipe would wait for a writer for ever.
  if (status.type() != std::filesystem::file_type::regular) {
    throw FileError(ErrorCode::unreadable, file.string(), std::nullopt,
                    "expected a text file, found " + (error ? error.message() : std::string("something else")));
  }
  auto stream = std::make_unique<std::ifstream>(file, std::ios::binary);
  if (!*stream) {
    throw FileError(ErrorCode::unreadable, file.string(), std::nullopt, "cannot be opened; check its permissions");
  }
  return stream;
}

}  // namespace

LineReader::LineReader(std::istream& input, std::string name) : input_(&input), name_(std::move(name)) {}

LineReader::LineReader(const std::filesystem::path& file)
    : owned_(open_text(file)), input_(owned_.get()), name_(file.string()) {
  std::error_code error;
  const std::uintmax_t bytes = std::filesystem::file_size(file, error);
  bytes_ = error ? 0 : bytes;
}

bool LineReader::next(std::string_view& line) {
  while (next_or_blank(line)) {
    if (!line.empty()) {
      return true;
    }
  }
  return false;
}

bool LineReader::next_or_blank(std::string_view& line) {
  while (read_line()) {
    line = buffer_;
    const std::size_t begin = line.find_first_not_of(kLineBlanks);
    if (begin == std::string_view::npos) {
      line = {};
      return true;
    }
    if (line[begin] != '#') {
      return true;
    }
  }
  return false;
}

bool LineReader::read_line() {
  try {
    return read_line_unguarded();
  } catch (const std::ios_base::failure& failure) {
    throw FileError(ErrorCode::unreadable, name_, std::nullopt,
                    "reading stopped in line " + std::to_string(line_number_) + ": " + failure.what());
  }
}

bool LineReader::read_line_unguarded() {
  buffer_.clear();
  std::streambuf& bytes = *input_->rdbuf();
  constexpr int kEnd = std::char_traits<char>::eof();
  int byte = bytes.sbumpc();
  if (byte == kEnd) {
    return false;
  }
  ++line_number_;
  for (; byte != kEnd && byte != '\n'; byte = bytes.sbumpc()) {
    if (byte == '\0') {
      throw error("expected text, found a NUL byte; is this a binary file?");
    }
    if (buffer_.size() == kMaxLineBytes) {
      throw error("longer than " + std::to_string(kMaxLineBytes) + " bytes; is this the right file?");
    }
    buffer_.push_back(static_cast<char>(byte));
  }
  if (buffer_.ends_with('\r')) {
    buffer_.pop_back();
  }
  return true;
}

void LineReader::parse_numbers(std::string_view line, std::string_view what, std::span<double> values) const {
  const auto expected = [&] {
    return ", expected " + std::to_string(values.size()) + " numbers in a line (" + std::string(what) + ")";
  };
  std::string_view rest = line;
  for (std::size_t i = 0; i < values.size(); ++i) {
    const std::string_view word = take_word(rest);
    if (word.empty()) {
      throw error("only " + std::to_string(i) + " numbers" + expected());
    }
    const std::optional<double> value = parse_number(word);
    if (!value) {
      throw error(quoted(word) + " in column " + std::to_string(i + 1) + " is no finite number" + expected());
    }
    values[i] = *value;
  }
  if (const std::string_view extra = take_word(rest); !extra.empty()) {
    throw error(quoted(extra) + " follows the last number" + expected());
  }
}

FileError LineReader::error(const std::string& problem) const {
  return {ErrorCode::malformed, name_, std::nullopt, "line " + std::to_string(line_number_) + ": " + problem};
}

std::string_view take_word(std::string_view& line) {
  line.remove_prefix(std::min(line.find_first_not_of(kLineBlanks), line.size()));
  const std::size_t length = std::min(line.find_first_of(kLineBlanks), line.size());
  const std::string_view word = line.substr(0, length);
  line.remove_prefix(length);
  return word;
}

std::string quoted(std::string_view text) {
  std::string result = "'";
  for (const char c : text.substr(0, kMaxQuotedBytes)) {
    result += c >= ' ' && c <= '~' ? c : '?';
  }
  return result + (text.size() > kMaxQuotedBytes ? "...'" : "'");
}

}  // namespace berm
