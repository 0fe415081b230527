#include "berm/io/label_file.hpp"

#include <algorithm>
#include <cstring>

#include <fmt/format.h>

#include "berm/core/error.hpp"
#include "berm/io/atomic_file.hpp"
#include "berm/io/file_reader.hpp"
#include "little_endian.hpp"

namespace berm {

Label to_label(std::uint32_t raw) {
  switch (semantic_class(raw)) {
    case 0:
    case 1:
      return Label::unlabeled;
    case 110:
      return Label::falling_snow;
    case 40:
    case 44:
    case 48:
    case 49:
    case 60:
      return Label::drivable;
    case 72:
    case 111:
      return Label::terrain;
    default:
      return Label::obstacle;
  }
}

std::vector<std::uint32_t> parse_labels(std::span<const std::byte> bytes, const std::string& name,
                                        std::optional<std::size_t> expected_points) {
  constexpr std::size_t kLabelBytes = sizeof(std::uint32_t);
  const std::size_t count = bytes.size() / kLabelBytes;
  if (bytes.size() % kLabelBytes != 0) {
    throw FileError(
        ErrorCode::truncated, name, count * kLabelBytes,
        fmt::format("{} bytes left for a label of 4: the file is cut or no SemanticKITTI label file; copy it again",
                    bytes.size() % kLabelBytes));
  }
  if (expected_points && count != *expected_points) {
    throw FileError(
        ErrorCode::malformed, name, std::nullopt,
        fmt::format("holds {} labels for a scan of {} points; do they belong together?", count, *expected_points));
  }
  std::vector<std::uint32_t> labels(count);
  if (count != 0) {
    std::memcpy(labels.data(), bytes.data(), bytes.size());
  }
  return labels;
}

std::vector<std::uint32_t> read_labels(const std::filesystem::path& path, std::optional<std::size_t> expected_points) {
  FileBuffer buffer;
  return parse_labels(read_file(path, buffer), path.string(), expected_points);
}

void write_labels(const std::filesystem::path& path, std::span<const Label> labels) {
  std::vector<std::uint32_t> raw(labels.size());
  std::transform(labels.begin(), labels.end(), raw.begin(), semantic_kitti_id);
  write_labels(path, raw);
}

void write_labels(const std::filesystem::path& path, std::span<const std::uint32_t> raw) {
  write_file_atomically(path, std::as_bytes(raw));
}

}  // namespace berm
