#include "pcd_header.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdint>
#include <optional>
#include <string_view>

#include <fmt/format.h>

#include "berm/core/error.hpp"
#include "line_reader.hpp"

namespace berm {
namespace {

/// Far above any real file; bounds what a hostile header can make us keep.
constexpr std::size_t kMaxFields = 1024;
constexpr std::uint64_t kMaxCount = std::uint64_t{1} << 20U;
constexpr std::uint64_t kMaxPoints = (std::uint64_t{1} << 48U) - 1;

constexpr std::string_view kHeaderBlanks = " \t\r\v\f";

struct Entry {
  bool present = false;
  std::size_t offset = 0;
  std::vector<std::string_view> values;
};

enum Key : std::size_t { kVersion, kFields, kSize, kType, kCount, kWidth, kHeight, kViewpoint, kPoints, kData, kKeys };
constexpr std::array<std::string_view, kKeys> kKeyNames = {"VERSION", "FIELDS", "SIZE",      "TYPE",   "COUNT",
                                                           "WIDTH",   "HEIGHT", "VIEWPOINT", "POINTS", "DATA"};

class HeaderParser {
 public:
  HeaderParser(std::string_view text, const std::string& name) : text_(text), name_(name) {}

  PcdHeader parse() {
    while (!entry(kData).present) {
      read_line();
    }
    header_.data_offset = position_;
    check_version();
    interpret_fields();
    interpret_points();
    check_viewpoint();
    interpret_encoding();
    return std::move(header_);
  }

 private:
  [[noreturn]] void fail(ErrorCode code, std::size_t offset, const std::string& problem) const {
    throw FileError(code, name_, offset, "PCD header: " + problem);
  }

  Entry& entry(Key key) { return entries_[key]; }

  const Entry& required(Key key) {
    if (!entry(key).present) {
      fail(ErrorCode::malformed, entry(kData).offset, fmt::format("{} is missing before DATA", kKeyNames[key]));
    }
    return entry(key);
  }

  void read_line() {
    const std::size_t offset = position_;
    const std::size_t end = text_.find('\n', offset);
    if (end == std::string_view::npos) {
      fail(ErrorCode::truncated, text_.size(), "the file ends before a DATA line; is it a PCD file, and whole?");
    }
    position_ = end + 1;
    ++header_.lines;
    std::vector<std::string_view> words = split(text_.substr(offset, end - offset), offset);
    if (words.empty() || words.front().front() == '#') {
      return;
    }
    // Version 0.5 said COLUMNS.
    const std::string_view key_name = words.front() == "COLUMNS" ? kKeyNames[kFields] : words.front();
    const auto key = std::find(kKeyNames.begin(), kKeyNames.end(), key_name);
    if (key == kKeyNames.end()) {
      fail(ErrorCode::malformed, offset,
           fmt::format("{} is no key of a PCD header, expected one of {}", berm::quoted(key_name),
                       fmt::join(kKeyNames, " ")));
    }
    Entry& target = entries_[static_cast<std::size_t>(key - kKeyNames.begin())];
    if (target.present) {
      fail(ErrorCode::malformed, offset, fmt::format("a second line {}", key_name));
    }
    words.erase(words.begin());
    target = {.present = true, .offset = offset, .values = std::move(words)};
  }

  std::vector<std::string_view> split(std::string_view line, std::size_t offset) const {
    std::vector<std::string_view> words;
    std::size_t begin = line.find_first_not_of(kHeaderBlanks);
    while (begin != std::string_view::npos) {
      const std::size_t end = std::min(line.find_first_of(kHeaderBlanks, begin), line.size());
      words.push_back(line.substr(begin, end - begin));
      if (words.front().front() == '#') {
        break;
      }
      if (words.size() > kMaxFields + 1) {
        fail(ErrorCode::unsupported, offset, fmt::format("more than {} values in a line", kMaxFields));
      }
      begin = line.find_first_not_of(kHeaderBlanks, end);
    }
    return words;
  }

  std::uint64_t number(std::string_view word, std::size_t offset, std::uint64_t min, std::uint64_t max) const {
    std::uint64_t value = 0;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    if (error != std::errc() || end != word.data() + word.size() || value < min || value > max) {
      fail(ErrorCode::malformed, offset,
           fmt::format("{} where a whole number from {} to {} is expected", berm::quoted(word), min, max));
    }
    return value;
  }

  std::optional<std::uint64_t> single_number(Key key) {
    const Entry& line = entry(key);
    if (!line.present) {
      return std::nullopt;
    }
    if (line.values.size() != 1) {
      fail(ErrorCode::malformed, line.offset,
           fmt::format("{} with {} values, expected 1", kKeyNames[key], line.values.size()));
    }
    return number(line.values.front(), line.offset, 0, kMaxPoints);
  }

  void check_version() {
    constexpr std::array<std::string_view, 3> kKnown = {".7", ".6", ".5"};
    const Entry& line = entry(kVersion);
    if (!line.present) {
      return;
    }
    std::string_view version = line.values.size() == 1 ? line.values.front() : std::string_view();
    // Written as 0.7, .7 and v.7
    version.remove_prefix(std::min(version.find('.'), version.size()));
    if (std::find(kKnown.begin(), kKnown.end(), version) == kKnown.end()) {
      fail(ErrorCode::unsupported, line.offset, "VERSION is none of 0.7, 0.6, 0.5");
    }
  }

  void interpret_fields() {
    const Entry& names = required(kFields);
    const Entry& sizes = required(kSize);
    const Entry& types = required(kType);
    const Entry& counts = entry(kCount);
    const std::size_t fields = names.values.size();
    if (fields == 0) {
      fail(ErrorCode::malformed, names.offset, "FIELDS names no field");
    }
    for (const Key key : {kSize, kType, kCount}) {
      if (entry(key).present && entry(key).values.size() != fields) {
        fail(ErrorCode::malformed, entry(key).offset,
             fmt::format("{} has {} values for {} fields", kKeyNames[key], entry(key).values.size(), fields));
      }
    }
    for (std::size_t i = 0; i < fields; ++i) {
      PcdField field;
      field.name = names.values[i];
      field.type = types.values[i].size() == 1 ? types.values[i].front() : '?';
      field.size = number(sizes.values[i], sizes.offset, 1, 8);
      field.count = counts.present ? number(counts.values[i], counts.offset, 1, kMaxCount) : 1;
      field.offset = header_.point_bytes;
      check_type(field, types.offset);
      header_.point_bytes += field.bytes();
      header_.fields.push_back(std::move(field));
    }
  }

  void check_type(const PcdField& field, std::size_t offset) const {
    const bool is_float = field.type == 'F' && (field.size == 4 || field.size == 8);
    const bool is_whole = (field.type == 'I' || field.type == 'U') &&
                          (field.size == 1 || field.size == 2 || field.size == 4 || field.size == 8);
    if (!is_float && !is_whole) {
      fail(ErrorCode::malformed, offset,
           fmt::format("field {} has type {} and size {}, expected F with 4 or 8, I or U with 1, 2, 4 or 8",
                       berm::quoted(field.name), berm::quoted({&field.type, 1}), field.size));
    }
  }

  void interpret_points() {
    const std::optional<std::uint64_t> width = single_number(kWidth);
    const std::optional<std::uint64_t> height = single_number(kHeight);
    const std::optional<std::uint64_t> points = single_number(kPoints);
    if (!points && !(width && height)) {
      required(kPoints);
    }
    // Both are below 2^48; a product beyond that contradicts any POINTS and any file.
    const bool overflow = width && height && *height != 0 && *width > kMaxPoints / *height;
    const std::uint64_t product = width && height && !overflow ? *width * *height : 0;
    if (overflow || (points && width && height && product != 0 && product != *points)) {
      fail(ErrorCode::malformed, entry(points ? kPoints : kWidth).offset,
           fmt::format("WIDTH {} x HEIGHT {} contradicts POINTS {}", *width, *height, points.value_or(0)));
    }
    header_.points = points.value_or(product);
    if (points && width && height && product != *points) {
      header_.notes.push_back(
          fmt::format("WIDTH {} and HEIGHT {} were ignored, POINTS says {}", *width, *height, *points));
    }
  }

  void check_viewpoint() {
    constexpr std::array<float, 7> kIdentity = {0.0F, 0.0F, 0.0F, 1.0F, 0.0F, 0.0F, 0.0F};
    const Entry& line = entry(kViewpoint);
    if (!line.present) {
      return;
    }
    if (line.values.size() != kIdentity.size()) {
      fail(ErrorCode::malformed, line.offset, fmt::format("VIEWPOINT has {} values, expected 7", line.values.size()));
    }
    bool identity = true;
    for (std::size_t i = 0; i < kIdentity.size(); ++i) {
      const std::string_view word = line.values[i];
      float value = 0.0F;
      const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
      if (error != std::errc() || end != word.data() + word.size()) {
        fail(ErrorCode::malformed, line.offset,
             fmt::format("VIEWPOINT holds {}, expected a number", berm::quoted(word)));
      }
      identity &= value == kIdentity[i];
    }
    if (!identity) {
      header_.notes.emplace_back("VIEWPOINT was ignored: points are taken in the frame of the sensor");
    }
  }

  void interpret_encoding() {
    const Entry& line = entry(kData);
    const std::string_view word = line.values.size() == 1 ? line.values.front() : std::string_view();
    if (word == "ascii") {
      header_.encoding = PcdEncoding::ascii;
    } else if (word == "binary") {
      header_.encoding = PcdEncoding::binary;
    } else if (word == "binary_compressed") {
      header_.encoding = PcdEncoding::binary_compressed;
    } else {
      fail(ErrorCode::unsupported, line.offset, "DATA is none of ascii, binary, binary_compressed");
    }
  }

  std::string_view text_;
  const std::string& name_;
  std::size_t position_ = 0;
  std::array<Entry, kKeys> entries_;
  PcdHeader header_;
};

}  // namespace

PcdHeader parse_pcd_header(std::span<const std::byte> bytes, const std::string& name) {
  return HeaderParser({reinterpret_cast<const char*>(bytes.data()), bytes.size()}, name).parse();
}

}  // namespace berm
