#include "berm/io/pose_file.hpp"

#include <algorithm>
#include <cstddef>
#include <fstream>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>

#include "berm/core/error.hpp"
#include "line_reader.hpp"
#include "text_numbers.hpp"

namespace berm {
namespace {

namespace fs = std::filesystem;

/// Enough for any first line and the comments before it.
constexpr std::size_t kPoseHeadBytes = 65536;

std::string read_pose_head(const fs::path& path) {
  std::error_code code;
  const fs::file_status status = fs::status(path, code);
  if (!fs::exists(status)) {
    throw FileError(ErrorCode::not_found, path.string(), std::nullopt, "there is no such file of poses");
  }
  std::ifstream stream;
  if (fs::is_regular_file(status)) {
    stream.open(path, std::ios::binary);
  }
  if (!stream.is_open()) {
    throw FileError(ErrorCode::unreadable, path.string(), std::nullopt, "cannot be read, expected a file of poses");
  }
  std::string head(kPoseHeadBytes, '\0');
  stream.read(head.data(), static_cast<std::streamsize>(head.size()));
  head.resize(static_cast<std::size_t>(stream.gcount()));
  return head;
}

/// The first line that is neither blank nor a comment.
std::string_view first_line(std::string_view text) {
  while (!text.empty()) {
    const std::string_view line = text.substr(0, text.find_first_of("\r\n"));
    const std::size_t begin = line.find_first_not_of(" \t");
    if (begin != std::string_view::npos && line[begin] != '#') {
      return line;
    }
    text.remove_prefix(std::min(line.size() + 1, text.size()));
  }
  return {};
}

/// How many numbers a line holds; 0 if it holds anything else.
std::size_t count_numbers(std::string_view line) {
  std::size_t count = 0;
  for (std::string_view word = take_word(line); !word.empty(); word = take_word(line)) {
    if (!parse_number(word)) {
      return 0;
    }
    ++count;
  }
  return count;
}

}  // namespace

PoseFileKind recognise_pose_file(const fs::path& path) {
  constexpr std::size_t kTumNumbers = 8;
  constexpr std::size_t kKittiNumbers = 12;
  const std::string head = read_pose_head(path);
  const fs::path extension = path.extension();
  if (extension == ".tum") {
    return PoseFileKind::tum;
  }
  if (extension == ".csv" || extension == ".nmea") {
    return PoseFileKind::log;
  }
  switch (count_numbers(first_line(head))) {
    case kTumNumbers:
      return PoseFileKind::tum;
    case kKittiNumbers:
      return PoseFileKind::kitti;
    default:
      return PoseFileKind::log;
  }
}

}  // namespace berm
