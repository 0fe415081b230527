#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <string_view>

#include "berm/view/shown_run.hpp"

namespace berm {

/// A line of a run's scans.csv.
struct ScanRow {
  std::uint32_t points = 0;
  bool degraded = false;
};

/// The lines of scans.csv by the name of their scan. Lines that are none are left out: a view is no place to refuse
/// them.
[[nodiscard]] std::map<std::string, ScanRow, std::less<>> parse_scan_rows(std::string_view csv);

/// How many points the head of a scan file announces; 0 where it does not say. Reads at most 4 KiB.
[[nodiscard]] std::uint32_t announced_points(const std::filesystem::path& scan_file);

}  // namespace berm
