#include "scan_list.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <fstream>
#include <limits>
#include <optional>
#include <system_error>
#include <vector>

namespace berm {
namespace {

/// The next field of a line of CSV; quotes around it are taken off.
std::string take_field(std::string_view& line) {
  std::string field;
  bool quoted = false;
  std::size_t i = 0;
  for (; i < line.size() && (quoted || line[i] != ','); ++i) {
    if (line[i] != '"') {
      field += line[i];
    } else if (quoted && i + 1 < line.size() && line[i + 1] == '"') {
      field += line[i++];
    } else {
      quoted = !quoted;
    }
  }
  line.remove_prefix(std::min(i + 1, line.size()));
  return field;
}

std::vector<std::string> split_fields(std::string_view line) {
  std::vector<std::string> fields;
  const bool ends_empty = !line.empty() && line.back() == ',';
  while (!line.empty()) {
    fields.push_back(take_field(line));
  }
  if (ends_empty) {
    fields.emplace_back();
  }
  return fields;
}

std::uint32_t parse_count(std::string_view text) {
  std::uint32_t value = 0;
  const auto [end, code] = std::from_chars(text.data(), text.data() + text.size(), value);
  return code == std::errc() ? value : 0;
}

std::string_view take_line(std::string_view& text) {
  const std::size_t end = std::min(text.find('\n'), text.size());
  const std::string_view line = text.substr(0, end);
  text.remove_prefix(std::min(end + 1, text.size()));
  return line.ends_with('\r') ? line.substr(0, line.size() - 1) : line;
}

}  // namespace

std::map<std::string, ScanRow, std::less<>> parse_scan_rows(std::string_view csv) {
  std::map<std::string, ScanRow, std::less<>> rows;
  const std::vector<std::string> names = split_fields(take_line(csv));
  const auto column = [&names](std::string_view name) {
    return static_cast<std::size_t>(std::find(names.begin(), names.end(), name) - names.begin());
  };
  const std::size_t scan = column("scan");
  const std::size_t points = column("points");
  const std::size_t degraded = column("degraded");
  while (!csv.empty()) {
    const std::vector<std::string> fields = split_fields(take_line(csv));
    if (std::max({scan, points, degraded}) < fields.size()) {
      rows[fields[scan]] = {parse_count(fields[points]), !fields[degraded].empty()};
    }
  }
  return rows;
}

std::uint32_t announced_points(const std::filesystem::path& scan_file) {
  std::error_code code;
  if (scan_file.extension() == ".bin") {
    constexpr std::uintmax_t kPointBytes = 16;
    const std::uintmax_t bytes = std::filesystem::file_size(scan_file, code);
    const std::uintmax_t points = code ? 0 : bytes / kPointBytes;
    return points <= std::numeric_limits<std::uint32_t>::max() ? static_cast<std::uint32_t>(points) : 0;
  }
  if (!std::filesystem::is_regular_file(scan_file, code)) {
    return 0;  // a pipe would be waited for
  }
  std::array<char, 4096> head{};
  std::ifstream file(scan_file, std::ios::binary);
  file.read(head.data(), head.size());
  std::string_view text(head.data(), static_cast<std::size_t>(file.gcount()));
  constexpr std::string_view kKey = "POINTS ";
  while (!text.empty()) {
    const std::string_view line = take_line(text);
    if (line.starts_with(kKey)) {
      return parse_count(line.substr(kKey.size()));
    }
    if (line.starts_with("DATA")) {
      return 0;
    }
  }
  return 0;
}

}  // namespace berm
